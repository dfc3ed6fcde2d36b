"""`move_to` brings any kinematic shape to a place in a time, to the bit, and lets it rest there, in both modes."""

import copy
import pickle
from collections.abc import Callable
from math import hypot, pi
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from carom import Arc, Ball, Circle, Compound, Gate, InvalidArgument, Point, Segment, World
from carom.rows.pose import rest
from carom.shapes.shape import Shape
from tests.kernel_calls import advance_pose
from tests.strategies import angles, numbers

MAKERS: dict[str, Callable[..., Shape | Compound]] = {
    "point": lambda **options: Point((0.1, 0.2), motion="kinematic", **options),
    "segment": lambda **options: Segment((-1, 0.3), (1.1, -0.2), motion="kinematic", **options),
    "gate": lambda **options: Gate((-1, 0.3), (1.1, -0.2), motion="kinematic", **options),
    "circle": lambda **options: Circle((0.1, 0.2), 0.3, motion="kinematic", **options),
    "arc": lambda **options: Arc((0.1, 0.2), 0.7, 0.5, 2.6, motion="kinematic", **options),
    "off": lambda **options: Arc((0.1, 0.2), 0.7, 0.5, 2.6, motion="kinematic", pivot=(1.3, -0.4), **options),
    "compound": lambda **options: Compound([Segment((0, 0), (1, 0.5)), Circle((1, 1), 0.2)], (0.1, 0.3), **options),
}
DETECTIONS: tuple[Any, ...] = ("discrete", "continuous")
kinds = st.sampled_from(sorted(MAKERS))
places = st.tuples(numbers(-9.0, 9.0), numbers(-9.0, 9.0))


def assert_there(shape: Shape | Compound, place: tuple[float, float], orientation: float) -> None:
    """The shape is at a place to the bit, and rests."""
    assert shape.position == place
    assert shape.orientation == orientation
    assert shape.velocity == (0.0, 0.0)
    assert shape.angular_velocity == 0.0


@pytest.mark.slow
@given(
    kinds,
    st.sampled_from(DETECTIONS),
    st.integers(1, 4),
    st.lists(st.tuples(places, st.floats(0.001, 0.2), st.one_of(st.none(), angles), st.integers(1, 20)), min_size=1),
)
def test_it_is_there_when_the_time_is_over_and_not_before(
    kind: str, detection: Any, substeps: int, ways: list[tuple[Any, float, float | None, int]]
) -> None:
    world = World(detection=detection, substeps=substeps)
    shape = MAKERS[kind]()
    world.add(shape)
    for place, seconds, turn, steps in ways[:4]:
        orientation = shape.orientation if turn is None else turn
        start = shape.pivot
        shape.move_to(place, seconds, turn)
        speed = hypot(*shape.velocity)
        for number in range(1, steps + 1):
            world.step(1 / 60)
            if number / 60 < seconds - 1e-6:
                way = hypot(shape.pivot[0] - start[0], shape.pivot[1] - start[1])
                assert way == pytest.approx(speed * number / 60, rel=1e-9, abs=1e-9)
            elif number / 60 > seconds + 1e-6:
                assert_there(shape, place, orientation)


@pytest.mark.slow
@pytest.mark.parametrize("kind", MAKERS)
def test_no_drift(kind: str) -> None:
    shape = MAKERS[kind]()
    parts = [shape.center_point, *shape.shapes] if isinstance(shape, Compound) else [shape]
    ends = (0.3, 0.7), (-1.1, 2.3)
    seen = []
    for number in range(2000):
        shape.move_to(ends[number % 2], 1 / 60, orientation=number % 2 + 0.1)
        for part in parts:
            advance_pose(part._row, 1 / 60)
            rest(part._row)
        assert_there(shape, ends[number % 2], number % 2 + 0.1)
        seen.append([part.aabb for part in parts])
    assert seen[0::2] == [seen[0]] * 1000
    assert seen[1::2] == [seen[1]] * 1000


@pytest.mark.slow
@pytest.mark.parametrize("detection", DETECTIONS)
def test_no_drift_in_a_hundred_thousand_frames(detection: Any) -> None:
    world = World(detection=detection)
    bat = Arc((0.1, 0.2), 0.7, 0.5, 2.6, motion="kinematic")
    world.add(bat)
    ends = (0.3, 0.7), (-1.1, 2.3)
    for number in range(100_000):
        bat.move_to(ends[number % 2], 1 / 60)
        world.step(1 / 60)
        assert bat.position == ends[number % 2]
        assert (bat.start_angle, bat.end_angle, bat.radius) == (0.5, 2.6, 0.7)


@pytest.mark.parametrize("kind", MAKERS)
@pytest.mark.parametrize("detection", DETECTIONS)
def test_on_its_way_it_is_in_snapshots_copies_and_pickles(kind: str, detection: Any) -> None:
    world = World(detection=detection)
    shape = MAKERS[kind]()
    world.add(shape)
    shape.move_to((3, 0.1), 0.1, orientation=0.7)
    world.run(0.05)
    restored = World()
    restored.restore(world.snapshot())
    others = [restored, copy.deepcopy(world), pickle.loads(pickle.dumps(world))]
    world.run(0.1)
    for other in others:
        other.run(0.1)
        assert other.digest() == world.digest()
    assert_there(shape, (3, 0.1), 0.7)


@pytest.mark.parametrize("detection", DETECTIONS)
def test_a_ball_is_hit_at_the_speed_of_the_way(detection: Any) -> None:
    world = World(detection=detection, substeps=32)
    bat = world.add(Segment((0, -1), (0, 1), motion="kinematic"))
    ball = world.add(Ball((0.5, 0), 0.2))
    bat.move_to((1.0, 0), 0.1)
    world.run(0.2)
    assert ball.velocity == (pytest.approx(20), 0)
    assert ball.position[0] > 1
    other = world.add(Ball((2, 0.5), 0.2, velocity=(-10, 0)))
    world.run(0.2)
    assert other.velocity == (pytest.approx(10), 0)  # off a wall at rest


@pytest.mark.parametrize("detection", DETECTIONS)
def test_it_rests_from_when_it_arrives_within_a_step(detection: Any) -> None:
    world = World(detection=detection, substeps=64)
    bat = world.add(Segment((0, -1), (0, 1), motion="kinematic"))
    ball = world.add(Ball((2.0, 0), 0.25, velocity=(-2.0, 0)))
    bat.move_to((1.0, 0), 0.1)  # the ball comes when it has been there for long
    world.step(1.0)
    assert ball.velocity == (2.0, 0)


@pytest.mark.parametrize("kind", sorted(set(MAKERS) - {"point"}))
def test_what_else_is_set_lets_it_rest_where_it_is(kind: str) -> None:
    changes: list[Callable[[Any], object]] = [
        lambda shape: setattr(shape, "position", (5, 5)),
        lambda shape: setattr(shape, "pivot", (5, 5)),
        lambda shape: shape.rotate((0, 0), 0.2),
        lambda shape: shape.reset(),
        lambda shape: setattr(shape, "rotating", True),
        lambda shape: setattr(shape, "turn_limits", (-1, 1)),
        lambda shape: setattr(shape, "turn_limits", None),
        lambda shape: setattr(shape, "angular_velocity", 0.0),
        lambda shape: setattr(shape, "velocity", (0, 0)),
    ]
    for change in changes:
        world = World(detection="discrete")
        shape = MAKERS[kind]()
        world.add(shape)
        shape.move_to((3, 4), 0.1, orientation=0.5)
        world.step(1 / 60)
        change(shape)
        place, turn = shape.position, shape.orientation
        world.run(0.3)
        assert_there(shape, place, turn)


def test_a_velocity_that_is_set_on_the_way_is_all_that_moves_it() -> None:
    world = World(detection="discrete")
    bat = world.add(Circle((0, 0), 1, motion="kinematic"))
    bat.move_to((3, 4), 0.1, orientation=2.0)
    bat.velocity = 1, 0
    world.run(1.0)
    assert bat.position == (pytest.approx(1), 0)
    assert bat.orientation == 0


def test_a_part_that_is_added_on_the_way_comes_along() -> None:
    world = World(detection="discrete")
    both = Compound([Circle((0, 0), 1)], (0, 0))
    world.add(both)
    both.move_to((3, 4), 0.1, orientation=pi / 2)
    world.run(0.05)
    part = both.add(Point((2, 0)))
    world.run(0.1)
    assert_there(both, (3, 4), pi / 2)
    assert part.position == pytest.approx((3, 6))
    assert part.velocity == (0, 0)


@pytest.mark.parametrize("detection", DETECTIONS)
def test_stops_hold(detection: Any) -> None:
    world = World(detection=detection)
    bat = world.add(Segment((0, 0), (2, 0), motion="kinematic", pivot=(0, 0), turn_limits=(-0.5, 0.5)))
    bat.move_to((2, 2), 0.1, orientation=0.5)
    world.run(0.3)
    assert_there(bat, (2, 2), 0.5)
    with pytest.raises(InvalidArgument, match=r"orientation must be within turn_limits=\(-0.5, 0.5\), not 0.6"):
        bat.move_to((0, 0), 0.1, orientation=0.6)
    assert_there(bat, (2, 2), 0.5)


def test_what_cannot_go_is_refused() -> None:
    with pytest.raises(InvalidArgument, match="motion must be 'kinematic'"):
        Circle((0, 0), 1).move_to((1, 1), 0.1)
    both = Compound([Circle((0, 0), 1)], (0, 0), rotating=False)
    with pytest.raises(InvalidArgument, match="compound"):
        both.shapes[0].move_to((1, 1), 0.1)
    with pytest.raises(InvalidArgument, match="orientation must be None while rotating is False, not 1"):
        both.move_to((1, 1), 0.1, orientation=1)
    both.move_to((1, 1), 0.1)
    shape = Circle((0, 0), 1, motion="kinematic")
    with pytest.raises(InvalidArgument, match="finite"):
        shape.move_to((1e308, 0), 1e-3)
    with pytest.raises(InvalidArgument, match="finite"):
        Circle((0, 0), 1e308, motion="kinematic").move_to((1.7e308, 0), 10)
    assert shape.velocity == (0, 0)
    shape.move_to((0, 0), 0.1)
    with pytest.raises(InvalidArgument, match="motion must stay 'kinematic'"):
        shape.motion = "static"
