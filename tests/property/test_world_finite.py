"""Worlds of all kinds stay finite and sound, however balls and shapes are heaped, at ordinary and at extreme sizes."""

from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from carom import Arc, Ball, Circle, Gate, NonFiniteState, Point, Segment, World
from carom.errors import InvalidArgument
from carom.shapes.shape import Shape

#: Few numbers, so that centres, ends, lines and circles coincide.
grid = st.sampled_from((-2.0, -1.0, -0.5, 0.0, 0.5, 1.0, 2.0))
sizes = st.sampled_from((0.5, 1.0, 2.0))
places = st.tuples(grid, grid)
angles = st.sampled_from((0.0, 0.5, 1.5707963267948966, 3.141592653589793, 4.0))
surfaces = st.fixed_dictionaries(
    {},
    optional={
        "elasticity": st.sampled_from((0.0, 0.5, 1.0, 1.2)),
        "kick": st.sampled_from((0.0, 2.0)),
        "sensor": st.booleans(),
    },
)
rails = st.one_of(
    st.just({}),
    st.fixed_dictionaries(
        {"motion": st.just("kinematic")},
        optional={
            "pivot": places,
            "angular_velocity": st.sampled_from((-3.0, 0.0, 40.0)),
            "velocity": places,
            "turn_limits": st.sampled_from(((-1.0, 1.0), (0.0, 0.0))),
        },
    ),
)


@st.composite
def shapes(draw: st.DrawFn, scale: float = 1.0) -> Shape:
    """A shape of any kind about the origin."""
    options: dict[str, Any] = {**draw(surfaces), **draw(rails)}
    for name in ("pivot", "velocity"):
        if name in options:
            options[name] = tuple(scale * number for number in options[name])
    kind = draw(st.sampled_from(("point", "segment", "gate", "circle", "arc")))
    place = tuple(scale * number for number in draw(places))
    if kind == "point":
        return Point(place, **options)
    if kind == "circle":
        return Circle(place, scale * draw(sizes), solid=draw(st.booleans()), **options)
    if kind == "arc":
        start = draw(angles)
        return Arc(place, scale * draw(sizes), start, draw(angles.filter(lambda angle: angle != start)), **options)
    end = tuple(scale * number for number in draw(places))
    end = (place[0] + scale, place[1]) if end == place else end
    return Gate(place, end, **options) if kind == "gate" else Segment(place, end, **options)


@st.composite
def balls(draw: st.DrawFn, scale: float = 1.0) -> Ball:
    """A ball about the origin, often at rest, often where another is."""
    (x, y), (vx, vy) = draw(places), draw(st.one_of(st.just((0.0, 0.0)), places))
    return Ball(
        (scale * x, scale * y),
        scale * draw(sizes),
        (scale * vx, scale * vy),
        draw(st.sampled_from((1e-9, 1.0, 1e9))),
        elasticity=draw(st.sampled_from((0.0, 0.5, 1.0, 1.1))),
        sensor=draw(st.integers(0, 9)) == 0,
    )


settings_of_worlds = st.fixed_dictionaries(
    {},
    optional={
        "gravity": st.sampled_from(((0.0, -10.0), (1.0, 1.0))),
        "iterations": st.sampled_from((1, 3, 6)),
        "substeps": st.sampled_from((1, 2)),
        "broad_phase": st.sampled_from(("brute", "quadtree")),
        "restitution": st.just("total"),
        "friction": st.just(1.0),
        "sleep_speed": st.just(1.0),
        "sleep_time": st.just(0.05),
        "rest_speed": st.sampled_from((0.0, 1.0)),
        "max_speed": st.just(5.0),
    },
)


def assert_sound(world: World, hits: np.ndarray) -> None:
    """All numbers are finite, all normals unit vectors, all impulses given, and the counters right."""
    assert np.isfinite(world.balls.position).all()
    assert np.isfinite(world.balls.velocity).all()
    bounces = np.asarray(hits)[hits["kind"] == 0]
    for name in ("time", "setback", "speed", "impulse"):
        assert np.isfinite(bounces[name]).all()
        assert (bounces[name] >= 0).all()
    assert np.abs(np.hypot(*bounces["normal"].T) - 1).max(initial=0) < 1e-12
    assert world.statistics.collisions == len(bounces)
    assert world.statistics.sleeping == sum(ball.asleep for ball in world.balls)


@pytest.mark.slow
@given(st.lists(shapes(), max_size=6), st.lists(balls(), min_size=1, max_size=6), settings_of_worlds)
def test_a_heap_of_anything_stays_finite(things: list[Shape], movers: list[Ball], settings: dict[str, Any]) -> None:
    world = World(detection="discrete", **settings)
    for thing in [*things, *movers]:
        world.add(thing)
    assert_sound(world, world.run(0.2, dt=0.02))


@given(st.data(), st.sampled_from((1e-150, 1e-30, 1e30, 1e100)))
def test_sizes_far_from_one_are_as_good(data: st.DataObject, scale: float) -> None:
    world = World(detection="discrete", substeps=1)
    for thing in data.draw(st.lists(shapes(scale), max_size=4)) + data.draw(st.lists(balls(scale), max_size=4)):
        world.add(thing)
    assert_sound(world, world.run(0.1, dt=0.02))


@pytest.mark.compiled
@given(st.lists(places, min_size=2, max_size=12), sizes, st.sampled_from(("brute", "grid", "quadtree")))
def test_balls_at_few_places_part_in_the_end(where: list[tuple[float, float]], radius: float, phase: str) -> None:
    world = World(detection="discrete", broad_phase=phase, iterations=50)
    world.add_balls(where, radius=radius)
    assert_sound(world, world.run(1, dt=0.1))
    gaps = world.balls.position[:, None] - world.balls.position[None, :]
    distances = np.hypot(gaps[..., 0], gaps[..., 1])[np.triu_indices(len(where), 1)]
    assert distances.min() > 1.9 * radius


@pytest.mark.parametrize("phase", ["brute", "grid", "quadtree"])
@pytest.mark.parametrize("velocity", [(1e308, 0.0), (-1e308, 1e308)])
def test_a_step_that_overflows_is_refused_and_undone(phase: str, velocity: tuple[float, float]) -> None:
    world = World(detection="discrete", broad_phase=phase, substeps=3)
    world.add(Segment((0, 0), (1, 0)))
    world.add(Ball((0, 5), radius=1, velocity=velocity))
    world.add(Ball((0, 9), radius=1))
    before = world.digest()
    with pytest.raises(NonFiniteState):
        world.step(100.0)
    assert world.digest() == before
    world.balls[0].velocity = (0, 0)
    world.step(0.1)


@pytest.mark.parametrize("phase", ["brute", "grid", "quadtree"])
def test_a_shape_that_leaves_the_range_of_numbers_is_refused_too(phase: str) -> None:
    world = World(detection="discrete", broad_phase=phase, substeps=3)
    paddle = world.add(Segment((0, 0), (1, 0), motion="kinematic", velocity=(1e308, 0)))
    world.add(Ball((0, 5), radius=1))
    before = world.digest()
    with pytest.raises(NonFiniteState):
        world.step(100.0)
    assert world.digest() == before
    assert paddle.p0 == (0, 0)


@pytest.mark.parametrize("bad", [np.nan, np.inf, -np.inf])
@pytest.mark.parametrize("what", ["position", "velocity", "radius", "mass"])
def test_a_state_made_bad_through_a_view_is_refused(bad: float, what: str) -> None:
    world = World(detection="discrete")
    world.add(Ball((0, 5), radius=1))
    column = getattr(world.balls, what)
    column[0] = bad
    with pytest.raises(NonFiniteState, match="ball"):
        world.step(0.1)
    assert np.asarray(column).ravel()[0] == bad or np.isnan(bad)


def test_a_radius_or_mass_made_negative_through_a_view_is_refused() -> None:
    world = World(detection="discrete")
    world.add(Ball((0, 5), radius=1))
    for column in (world.balls.radius, world.balls.mass):
        column[0] = -1.0
        with pytest.raises(InvalidArgument):
            world.step(0.1)
        column[0] = 1.0
    world.step(0.1)
