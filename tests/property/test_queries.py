"""Queries of any world say what asking every member by itself says, one by one or many at once, compiled or not."""

from math import cos, hypot, inf, pi, sin
from typing import Any

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from carom import Aabb, Arc, Ball, Circle, Gate, Point, Segment, World
from carom.compiler import door
from carom.world import search
from tests import strategies
from tests.worlds import world_of

#: More queries than are answered without making grids.
MANY = 40

members = st.lists(
    st.tuples(strategies.figures, st.sampled_from(("shape", "gate", "ball", "sensor", "moving", "layer 2"))),
    max_size=8,
)
queries = st.tuples(strategies.points, strategies.points)


def member_of(figure: strategies.Figure, role: str) -> Any:
    """A figure as a shape or ball."""
    kind, given = figure
    options: dict[str, Any] = {}
    if role == "sensor":
        options = {"sensor": True}
    elif role == "moving":
        options = {"motion": "kinematic", "velocity": (3, -1), "angular_velocity": 2}
    elif role == "layer 2":
        options = {"layer": 2}
    if kind == "point":
        return Point(given, **options)
    if kind == "segment":
        shape = Gate if role == "gate" else Segment
        return shape(given[:2], given[2:], **options)
    if kind == "arc":
        return Arc(given[:2], *given[2:], **options)
    if role == "ball":
        return Ball(given[:2], given[2], velocity=(1, 2))
    return Circle(given[:2], given[2], solid=kind == "disc", **options)


def peopled(parts: Any, **settings: Any) -> tuple[World, list[Any]]:
    """A world of members, and the members."""
    members = [member_of(figure, role) for figure, role in parts]
    return world_of(*members, **settings), members


def alone(part: Any) -> World:
    """A world of one member."""
    return world_of(member_of(*part))


def asked_at_once(question: Any, *arguments: Any, **options: Any) -> Any:
    """The answer to one of many equal queries, in an array; all must be the same."""
    answers = question(*(np.array([argument] * MANY, float) for argument in arguments), **options)
    assert len({row.tobytes() for row in np.asarray(answers)}) == 1
    return answers[0]


@pytest.mark.slow
@given(members, queries, st.sampled_from((0.0, 0.01, 1.0, 30.0)), st.booleans())
def test_the_first_touch_is_that_of_the_member_that_is_touched_first(
    parts: Any, query: Any, radius: float, sensors: bool
) -> None:
    world, shapes = peopled(parts)
    start, target = query

    def cast(place: World) -> Any:
        """The first touch in a world."""
        if radius == 0.0:
            return place.ray_cast(start, target, sensors=sensors)
        return place.circle_cast(start, radius, target, sensors=sensors)

    hits = [(hit.fraction, k, hit) for k, part in enumerate(parts) if (hit := cast(alone(part))) is not None]
    found = cast(world)
    if radius == 0.0:
        assert asked_at_once(world.ray_cast, start, target, sensors=sensors) == found
    else:
        assert asked_at_once(world.circle_cast, start, radius, target, sensors=sensors) == found
    if not hits:
        assert found is None
        return
    fraction, k, hit = min(hits, key=lambda item: item[:2])
    assert (found.shape, found.fraction, found.point, found.normal) == (shapes[k], fraction, hit.point, hit.normal)


@given(members, queries, st.sampled_from((0.0, 0.1, 5.0)))
def test_a_touch_is_on_the_shape_and_its_normal_points_back_along_the_radius(
    parts: Any, query: Any, radius: float
) -> None:
    world, shapes = peopled(parts)
    (x, y), (to_x, to_y) = query
    hit = world.circle_cast((x, y), radius, (to_x, to_y)) if radius else world.ray_cast((x, y), (to_x, to_y))
    overlaps = radius > 0.0 and any(shape.detect(Ball((x, y), radius)) is not None for shape in shapes)
    if hit is None or hit.fraction == 0.0 or overlaps:
        return
    at_x, at_y = x + hit.fraction * (to_x - x), y + hit.fraction * (to_y - y)
    slack = 1e-9 * (200.0 + radius)
    assert hit.shape.distance(hit.point) <= slack
    assert hypot(*hit.normal) == pytest.approx(1.0)
    assert hit.normal[0] * (to_x - x) + hit.normal[1] * (to_y - y) <= slack
    assert abs(hypot(at_x - hit.point[0], at_y - hit.point[1]) - radius) <= max(slack, 2e-6 * radius)
    away = hit.point[0] + radius * hit.normal[0], hit.point[1] + radius * hit.normal[1]
    assert away == pytest.approx((at_x, at_y), abs=max(slack, 2e-3 * radius))


@given(members, queries)
def test_a_way_that_is_free_is_free_the_other_way_round(parts: Any, query: Any) -> None:
    lines = [(figure, "shape") for figure, _ in parts if figure[0] != "disc"]
    world, _ = peopled(lines)
    start, target = query
    forth, back = world.ray_cast(start, target), world.ray_cast(target, start)
    # Through a tangent point or an end it is rounding that decides.
    assume(all(hit is None or min(hit.fraction, 1.0 - hit.fraction) > 1e-9 for hit in (forth, back)))
    if (forth is None) != (back is None):
        hit = forth or back
        way = np.subtract(target, start)
        grazing = abs(np.dot(hit.normal, way)) <= 1e-6 * hypot(*way)
        ends = [hit.shape.p0, hit.shape.p1] if hasattr(hit.shape, "p0") else []
        assert grazing or any(hypot(*np.subtract(hit.point, end)) < 1e-9 for end in ends)


@pytest.mark.slow
@given(members, strategies.points, st.booleans())
def test_the_nearest_is_the_member_at_the_least_distance(parts: Any, point: Any, sensors: bool) -> None:
    world, shapes = peopled(parts)
    found = world.nearest(point, sensors=sensors)
    assert asked_at_once(world.nearest, point, sensors=sensors) == found
    nearest = inf, -1
    for k, shape in enumerate(shapes):
        solid = isinstance(shape, Ball) or (isinstance(shape, Circle) and shape.solid)
        sign = -1.0 if solid and shape.contains(point) else 1.0
        if sensors or not shape.sensor:
            nearest = min(nearest, (sign * shape.distance(point), k))
    if nearest[1] < 0:
        assert found is None
        return
    assert (found.distance, found.shape) == (nearest[0], shapes[nearest[1]])
    assert found.point == found.shape.closest_point(point)


def points_on(figure: strategies.Figure, count: int) -> Any:
    """Points along a figure, its middle too if it is solid, and how far they are apart."""
    kind, given = figure
    parts = np.linspace(0.0, 1.0, count)
    if kind == "point":
        return np.array([given]), 0.0
    if kind == "segment":
        a, b = np.array(given[:2]), np.array(given[2:])
        return a + parts[:, None] * (b - a), hypot(*(b - a)) / count
    start, turn = (given[3], (given[4] - given[3]) % (2.0 * pi)) if kind == "arc" else (0.0, 2.0 * pi)
    angles = start + turn * parts
    rim = np.array(given[:2]) + given[2] * np.stack([np.cos(angles), np.sin(angles)], axis=1)
    return rim, given[2] * turn / count


@pytest.mark.slow
@given(members, queries)
def test_a_box_holds_the_members_that_come_into_it(parts: Any, corners: Any) -> None:
    world, shapes = peopled(parts)
    box = Aabb.at(corners[0]).including(corners[1])
    found = world.overlapping(box, sensors=True)
    many = world.overlapping(np.array([tuple(box)] * MANY), sensors=True)
    assert many["shape"].tolist() == [shape.id for shape in found] * MANY
    for (figure, role), shape in zip(parts, shapes, strict=True):
        rim, step = points_on(figure, 500)
        low, high = np.array((box.left, box.bottom)), np.array((box.right, box.top))
        inside = bool(((rim > low + 1e-9) & (rim < high - 1e-9)).all(axis=1).any())
        near = bool(((rim > low - step - 1e-9) & (rim < high + step + 1e-9)).all(axis=1).any())
        if figure[0] == "disc" or (role == "ball" and figure[0] == "circle"):
            centre = np.clip(figure[1][:2], low, high)
            inside = near = hypot(*(centre - figure[1][:2])) <= figure[1][2]
        assert inside <= (shape in found) <= near


@pytest.mark.slow
@given(members)
def test_overlaps_are_the_contacts_that_detect_finds(parts: Any) -> None:
    balls = [((kind, given), "ball") for (kind, given), _ in parts if kind in ("circle", "disc")]
    world, shapes = peopled(parts + balls)
    expected = [
        contact
        for ball in world.balls
        for shape in shapes
        if not shape.sensor and shape.kind != "ball" and (contact := shape.detect(ball)) is not None
    ]
    expected += [
        contact
        for k, ball in enumerate(world.balls)
        for first in world.balls[:k]
        if (contact := first.detect(ball)) is not None
    ]
    expected.sort(key=lambda contact: (contact.ball.id, contact.shape.id))
    assert list(world.contacts()) == expected


@pytest.mark.slow
@given(members, queries)
def test_the_broad_phase_of_the_world_changes_no_answer(parts: Any, query: Any) -> None:
    answers = []
    for broad_phase in ("brute", "grid", "quadtree"):
        world, _ = peopled(parts, broad_phase=broad_phase)
        world.step(0.01)
        answers.append(world.ray_cast(np.array([query[0]] * MANY), query[1]).tobytes())
    assert len(set(answers)) == 1


def large_world(rng: np.random.Generator, count: int) -> World:
    """A world of shapes of every kind and size, and of balls."""
    world = World(detection="discrete")
    for k in range(count):
        (x, y), angle, size = rng.uniform(-100, 100, 2), rng.uniform(0.1, 6), rng.uniform(1, 30 if k % 5 == 0 else 8)
        world.add(Segment((x, y), (x + size * cos(angle), y + size * sin(angle)), elasticity=0.9))
        world.add(Circle((y, x), size, solid=k % 2 == 0))
        world.add(Arc((y, -x), size, angle, 0.05))
        world.add(Ball((-x, -y), size / 3, velocity=(1, 2), mass=size))
        world.add(Point((-x, y)))
    return world


@pytest.mark.compiled
@pytest.mark.parametrize("seed", range(4))
def test_grids_find_what_lists_find(seed: int, monkeypatch: pytest.MonkeyPatch) -> None:
    world = large_world(np.random.default_rng(seed), 40)
    answers = []
    for scans in (0, 10**9):
        monkeypatch.setattr(search, "SEARCH_SCANS", scans)
        world._search = None
        answers.append(answers_of(world))
    assert answers[0] == answers[1]


def answers_of(world: World) -> list[bytes]:
    """The bytes of answers to all sorts of questions."""
    rng = np.random.default_rng(1)
    starts, ends = rng.uniform(-120, 120, (2, 2 * MANY, 2))
    ends[:10, 0], ends[10:20, 1] = starts[:10, 0], starts[10:20, 1]
    boxes = np.hstack([np.minimum(starts, ends), np.maximum(starts, ends)])
    few = starts[:3], ends[:3]
    return [
        answers.tobytes()
        for answers in (
            world.ray_cast(starts, ends),
            world.ray_cast(*few),
            world.circle_cast(starts, 2.0, ends),
            world.nearest(starts),
            world.nearest(few[0]),
            world.overlapping(boxes),
            world.contacts(),
            world.aim(world.balls[0], ends),
        )
    ]


@pytest.mark.compiled
def test_compiled_and_interpreted_answers_are_the_same_bits(monkeypatch: pytest.MonkeyPatch) -> None:
    pytest.importorskip("numba")
    world = large_world(np.random.default_rng(2), 30)
    compiled_answers = answers_of(world)
    monkeypatch.setattr(door, "load", lambda function, size: function)
    world._search = None
    assert answers_of(world) == compiled_answers
