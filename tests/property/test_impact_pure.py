"""A time of impact is a function of the path and the shape: how far one looks ahead only leaves out what is later."""

from collections.abc import Callable
from math import atan2, cos, inf, nextafter, pi, sin

from hypothesis import given
from hypothesis import strategies as st

from carom.constants import END_SLOP
from carom.geometry.impact import impact_ball
from carom.geometry.path import Path
from tests.naive_impact import Flight, carom_impact
from tests.strategies import Figure, angles, figures, fractions, meetings, numbers, places_on, radii

Vector = tuple[float, float]
paces = numbers(-100.0, 100.0)
vectors = st.tuples(paces, paces)
scales = st.integers(-9, 3).map(lambda power: 10.0**power)
pulls = st.one_of(
    st.just((0.0, 0.0)),
    st.just((0.0, -9.8)),
    vectors,
    st.builds(lambda pull, scale: (pull[0] * scale, pull[1] * scale), vectors, scales),
)
durations = st.one_of(st.floats(1e-3, 10.0), st.floats(1e-9, 1e9))
#: As parts of the time found, and near it: where to look no farther.
parts = st.lists(st.one_of(fractions, st.floats(1.0, 1e6), st.floats(0.999999, 1.000001)), min_size=4, max_size=4)


@st.composite
def crossings(draw: st.DrawFn) -> tuple[Figure, Flight]:
    """A figure, and a ball that is near it at some time of its flight, which may be long."""
    figure, (x, y, radius) = draw(meetings())
    (vx, vy), (gx, gy), duration = draw(vectors), draw(pulls), draw(durations)
    before = -duration * draw(fractions)
    start_x = x + vx * before + 0.5 * gx * before * before
    start_y = y + vy * before + 0.5 * gy * before * before
    return figure, Flight(start_x, start_y, radius, vx + gx * before, vy + gy * before, gx, gy, duration)


@st.composite
def leavings(draw: st.DrawFn) -> tuple[Figure, Flight]:
    """A figure, and a ball that touches it to rounding and leaves, slides or approaches, steeply or ever so flatly."""
    figure, radius = draw(figures), draw(radii)
    x, y = draw(places_on(figure))
    turn, slope = draw(angles), draw(st.integers(0, 17))
    if figure[0] == "segment":
        turn = atan2(figure[1][3] - figure[1][1], figure[1][2] - figure[1][0]) + 0.5 * pi
    elif figure[0] != "point":
        turn = atan2(y - figure[1][1], x - figure[1][0])
    side = draw(st.sampled_from((1.0, -1.0)))
    nx, ny = side * cos(turn), side * sin(turn)
    x, y = x + radius * nx, y + radius * ny
    along, off = draw(paces), draw(paces) * 10.0**-slope
    gx, gy = draw(pulls)
    return figure, Flight(x, y, radius, off * nx - along * ny, off * ny + along * nx, gx, gy, draw(durations))


def check(time_within: Callable[[float], float | None], duration: float, shares: list[float]) -> None:
    """What is found within any duration is what is found in all time, unless it is later."""
    time = time_within(inf)
    looks = [duration, 1e300]
    if time is not None:
        assert 0.0 <= time < inf
        looks += [time, nextafter(time, inf), nextafter(time, -1.0), *[share * time for share in shares]]
    for look in looks:
        if look >= 0.0:
            assert time_within(look) == (time if time is not None and time <= look else None)


def check_flight(figure: Figure, flight: Flight, shares: list[float]) -> None:
    """The same for a figure and a flight."""
    numbers_given = flight.numbers()[:7]
    check(
        lambda look: carom_impact(figure, Flight(*numbers_given, look), END_SLOP * flight.radius),
        flight.duration,
        shares,
    )


@given(crossings(), parts)
def test_how_far_one_looks_changes_no_bit_of_an_impact(scene: tuple[Figure, Flight], shares: list[float]) -> None:
    check_flight(*scene, shares)


@given(leavings(), parts)
def test_nor_where_the_ball_touches_at_first(scene: tuple[Figure, Flight], shares: list[float]) -> None:
    check_flight(*scene, shares)


@given(crossings(), vectors, pulls, st.booleans(), parts)
def test_nor_of_two_balls(
    scene: tuple[Figure, Flight], velocity: Vector, pull: Vector, alike: bool, shares: list[float]
) -> None:
    figure, flight = scene
    second = Path(flight.x, flight.y, flight.vx, flight.vy, flight.gx, flight.gy)
    first = Path(*figure[1][:2], *velocity, *((flight.gx, flight.gy) if alike else pull))
    reach = flight.radius + (figure[1][2] if figure[0] in {"circle", "disc", "arc"} else 1.0)
    check(lambda look: impact_ball(first, second, reach, look), flight.duration, shares)
