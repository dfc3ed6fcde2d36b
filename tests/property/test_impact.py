"""Laws of times of impact, for every kind of shape and motion, at rest and turning, near, far, fast and grazing."""

from math import cos, hypot, nextafter, sin

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from carom.constants import END_DEPTH_CONTINUOUS, END_SLOP
from tests import naive
from tests.naive_impact import (
    STANDING,
    Carriage,
    Flight,
    carom_advance,
    carom_impact,
    edge,
    exact_touches,
    gap,
    missed,
)
from tests.strategies import Ball, Figure, Motion, angles, figures, fractions, meetings, motions, numbers

SAMPLES = 400
#: Of the ball's radius: what is no deeper may be rounding, or the slop of an end.
DEPTH = 2.0 * END_DEPTH_CONTINUOUS

#: Nothing so small that sixty digits would not tell it from nothing.
paces = numbers(-100.0, 100.0).map(lambda speed: speed if abs(speed) > 1e-6 else 0.0)
vectors = st.tuples(paces, paces)
pulls = st.one_of(st.just((0.0, 0.0)), st.just((0.0, -9.8)), vectors)
durations = st.floats(1e-3, 10.0)
powers = st.integers(-3, 3).map(lambda power: 2.0**power)


@st.composite
def flights(draw: st.DrawFn) -> tuple[Figure, Flight]:
    """A figure, and a ball that is near it, more often than not overlapping, at some time of its flight."""
    figure, (x, y, radius) = draw(meetings())
    vx, vy = draw(vectors)
    gx, gy = draw(pulls)
    duration = draw(durations)
    before = -duration * draw(fractions)
    start_x = x + vx * before + 0.5 * gx * before * before
    start_y = y + vy * before + 0.5 * gy * before * before
    return figure, Flight(start_x, start_y, radius, vx + gx * before, vy + gy * before, gx, gy, duration)


@st.composite
def carriages(draw: st.DrawFn) -> Carriage:
    """A pivot that moves and a turn about it."""
    x, y, vx, vy = (draw(numbers(-20.0, 20.0)) for _ in range(4))
    return Carriage(x, y, vx, vy, draw(st.one_of(st.just(0.0), st.floats(-20.0, 20.0))))


def rounding(figure: Figure, flight: Flight) -> float:
    """How far rounding may misplace a ball on its path."""
    return 1e-14 * (flight.path() + sum(map(abs, figure[1])))


def check_touch(figure: Figure, flight: Flight, carriage: Carriage, time: float) -> None:
    """The ball touches, beside the shape, and goes on approaching; or it comes over an end, all but touching."""
    x, y = carriage.seen(*flight.place(time), time)
    tolerance = rounding(figure, flight)
    depth = gap(figure, flight.radius, x, y)
    assert -END_DEPTH_CONTINUOUS * flight.radius - tolerance <= depth <= tolerance
    assert edge(figure, x, y) >= -2.0 * END_SLOP * flight.radius - tolerance


@pytest.mark.slow
@given(flights())
def test_at_its_impact_a_ball_touches_and_none_is_missed_before(scene: tuple[Figure, Flight]) -> None:
    figure, flight = scene
    assume(gap(figure, flight.radius, flight.x, flight.y) > 0.0)
    time = carom_impact(figure, flight, END_SLOP * flight.radius)
    if time is not None:
        assert 0.0 <= time <= flight.duration
        check_touch(figure, flight, STANDING, time)
    until = flight.duration if time is None else time
    tolerance = DEPTH * flight.radius + rounding(figure, flight)
    assert missed(figure, flight, STANDING, until, tolerance, SAMPLES) is None


@pytest.mark.slow
@given(flights(), carriages())
def test_the_same_holds_for_shapes_that_move_and_turn(scene: tuple[Figure, Flight], carriage: Carriage) -> None:
    figure, flight = scene
    flight = Flight(*flight.numbers()[:7], 0.1 * flight.duration)
    assume(gap(figure, flight.radius, flight.x, flight.y) > 0.0)
    time = carom_advance(figure, flight, carriage, END_SLOP * flight.radius)
    if time is not None:
        assert 0.0 <= time <= flight.duration
        check_touch(figure, flight, carriage, time)
    until = flight.duration if time is None else time
    tolerance = DEPTH * flight.radius + rounding(figure, flight)
    assert missed(figure, flight, carriage, until, tolerance, SAMPLES) is None


@pytest.mark.slow
@given(flights(), st.integers(0, 8), st.integers(0, 6))
def test_far_fast_and_small_agree_with_roots_in_sixty_digits(
    scene: tuple[Figure, Flight], speed_power: int, radius_power: int
) -> None:
    figure, flight = scene
    fast, small = 10.0**speed_power, 10.0**-radius_power
    middle = flight.place(0.5 * flight.duration)
    vx, vy, half = flight.vx * fast, flight.vy * fast, 0.5 * flight.duration
    flight = Flight(
        middle[0] - vx * half,
        middle[1] - vy * half,
        flight.radius * small,
        vx,
        vy,
        flight.gx,
        flight.gy,
        flight.duration,
    )
    assume(gap(figure, flight.radius, flight.x, flight.y) > 1e-9 * flight.radius)
    compare_with_exact(figure, flight)


@pytest.mark.slow
@given(figures, angles, st.integers(-12, -1), st.booleans(), st.floats(0.01, 10.0), pulls)
def test_grazing_touches_are_told_from_misses(
    figure: Figure, direction: float, power: int, deep: bool, radius: float, pull: tuple[float, float]
) -> None:
    # at half-time the ball is at its nearest to a point or disc, too near or too far by a hair
    assume(figure[0] in {"point", "disc"})
    reach = radius + (figure[1][2] if figure[0] == "disc" else 0.0)
    away = reach * (1.0 - 10.0**power if deep else 1.0 + 10.0**power)
    speed = 40.0 * (1.0 + hypot(*pull)) * (1.0 + reach)
    vx, vy = -speed * sin(direction), speed * cos(direction)
    x, y = figure[1][0] + away * cos(direction), figure[1][1] + away * sin(direction)
    gx, gy = pull
    flight = Flight(
        x - 0.5 * vx + 0.125 * gx, y - 0.5 * vy + 0.125 * gy, radius, vx - 0.5 * gx, vy - 0.5 * gy, gx, gy, 1.0
    )
    compare_with_exact(figure, flight)


def compare_with_exact(figure: Figure, flight: Flight) -> None:
    """The first exact touch beside the shape is the one found, unless rounding decides which it is, or whether."""
    tolerance = rounding(figure, flight)
    touches = exact_touches(figure, flight)
    # a touch from which the ball gets no deeper than rounding before it leaves again
    assume(all(speed * speed > 100.0 * tolerance * bend(flight) for _, speed, _ in touches))
    # an end closer than rounding, or one that the ball comes over all but touching
    room = 4.0 * END_DEPTH_CONTINUOUS * flight.radius + tolerance
    fastest = hypot(flight.vx, flight.vy) + hypot(flight.gx, flight.gy) * flight.duration
    assume(all(abs(inside) > tolerance + room * fastest / speed for _, speed, inside in touches))
    beside = [(time, speed) for time, speed, inside in touches if inside > 0.0]
    found = carom_impact(figure, flight, 0.0)
    if not beside:
        if found is not None:  # then it is one to rounding
            check_touch(figure, flight, STANDING, found)
    else:
        time, speed = beside[0]
        assume(time < flight.duration * (1.0 - 1e-12))
        assert found is not None
        assert abs(found - time) * speed <= tolerance


def bend(flight: Flight) -> float:
    """How fast the rate of a gap may change: by the pull, and by the turn of a path about the ball's own radius."""
    speed = hypot(flight.vx, flight.vy) + hypot(flight.gx, flight.gy) * flight.duration
    return hypot(flight.gx, flight.gy) + speed * speed / flight.radius


@pytest.mark.slow
@given(flights())
def test_a_ball_that_is_thrown_back_has_no_impact_at_once(scene: tuple[Figure, Flight]) -> None:
    figure, flight = scene
    assume(gap(figure, flight.radius, flight.x, flight.y) > 0.0)
    time = carom_impact(figure, flight, END_SLOP * flight.radius)
    assume(time is not None)
    x, y = flight.place(time or 0.0)
    vx, vy = flight.vx + flight.gx * (time or 0.0), flight.vy + flight.gy * (time or 0.0)
    assume(naive.closest(figure, x, y) != (x, y))
    contact = naive.find_overlap(figure, x, y, flight.radius * (1.0 + 1e-6) + rounding(figure, flight))
    assume(contact is not None)
    _, _, nx, ny, _ = contact or (0.0,) * 5
    s = vx * nx + vy * ny
    assume(s < -1e-6 * hypot(vx, vy))
    after = Flight(x, y, flight.radius, vx - 2.0 * s * nx, vy - 2.0 * s * ny, flight.gx, flight.gy, flight.duration)
    again = carom_impact(figure, after, END_SLOP * flight.radius)
    assert again is None or again > 0.0


@pytest.mark.slow
@given(flights(), motions)
def test_moving_all_alike_changes_no_time(scene: tuple[Figure, Flight], motion: Motion) -> None:
    figure, flight = scene
    touches = exact_touches(figure, flight)
    depth = gap(figure, flight.radius, flight.x, flight.y)
    tolerance = 100.0 * (rounding(figure, flight) + 1e-14 * sum(map(abs, motion)))
    assume(depth > tolerance)
    fastest = hypot(flight.vx, flight.vy) + hypot(flight.gx, flight.gy) * flight.duration
    room = 4.0 * END_DEPTH_CONTINUOUS * flight.radius + tolerance
    assume(all(speed * speed > 100.0 * tolerance * bend(flight) for _, speed, _ in touches))
    assume(all(abs(inside) > tolerance + room * fastest / speed for _, speed, inside in touches))
    turn = (motion[0], 0.0, 0.0)
    moved = Flight(
        *naive.moved_point(motion, flight.x, flight.y),
        flight.radius,
        *naive.moved_point(turn, flight.vx, flight.vy),
        *naive.moved_point(turn, flight.gx, flight.gy),
        flight.duration,
    )
    here = carom_impact(figure, flight, END_SLOP * flight.radius)
    there = carom_impact(naive.moved_figure(motion, figure), moved, END_SLOP * flight.radius)
    if here is None or there is None:
        late = max(here or 0.0, there or 0.0)
        assert here is there or late > flight.duration * (1.0 - 1e-9)
        return
    speed = next(speed for time, speed, inside in touches if inside > 0.0)
    assert abs(here - there) * speed <= tolerance


@given(flights(), powers, powers)
def test_units_of_length_and_time_do_not_matter_to_the_bit(
    scene: tuple[Figure, Flight], length: float, second: float
) -> None:
    figure, flight = scene
    kind, given_numbers = figure
    places = 4 if kind == "segment" else 3
    scaled = kind, tuple(number * (length if at < places else 1.0) for at, number in enumerate(given_numbers))
    rate, pull = length / second, length / (second * second)
    other = Flight(
        flight.x * length,
        flight.y * length,
        flight.radius * length,
        flight.vx * rate,
        flight.vy * rate,
        flight.gx * pull,
        flight.gy * pull,
        flight.duration * second,
    )
    here = carom_impact(figure, flight, END_SLOP * flight.radius)
    there = carom_impact(scaled, other, END_SLOP * other.radius)
    assert there == (None if here is None else here * second)


@given(flights())
def test_a_shape_that_does_not_turn_is_met_in_closed_form(scene: tuple[Figure, Flight]) -> None:
    figure, flight = scene
    carriage = Carriage(3.0, -2.0, 0.5, 0.25, 0.0)
    relative = Flight(*flight.numbers()[:3], flight.vx - 0.5, flight.vy - 0.25, flight.gx, flight.gy, flight.duration)
    assert carom_advance(figure, flight, carriage, 0.0) == carom_impact(figure, relative, 0.0)


@pytest.mark.slow
@given(meetings(), vectors, pulls)
def test_a_deep_overlap_that_approaches_is_an_impact_now(
    meeting: tuple[Figure, Ball], velocity: tuple[float, float], pull: tuple[float, float]
) -> None:
    figure, (x, y, radius) = meeting
    assume(naive.margin(figure, x, y, radius) > 1e-6)
    contact = naive.find_overlap(figure, x, y, radius)
    assume(contact is not None)
    _, _, nx, ny, _ = contact or (0.0,) * 5
    s = velocity[0] * nx + velocity[1] * ny
    assume(abs(s) > 1e-6 * hypot(*velocity))
    flight = Flight(x, y, radius, *velocity, *pull, 1.0)
    time = carom_impact(figure, flight, 0.0)
    assert (time == 0.0) == (s < 0.0)


def test_the_next_double_after_a_touch_decides() -> None:
    figure: Figure = ("segment", (0.0, 0.0, 10.0, 0.0))
    for y in (nextafter(1.0, 0.0), 1.0, nextafter(1.0, 2.0)):
        flight = Flight(5.0, y, 1.0, 0.0, -1.0, 0.0, -1.0, 1.0)
        assert carom_impact(figure, flight, 0.0) == pytest.approx(0.0, abs=1e-15)
