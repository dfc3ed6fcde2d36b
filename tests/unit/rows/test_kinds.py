"""Every question about a shape, asked of every kind and of one that there is not, against an outline of many points."""

import ast
from collections.abc import Callable
from math import cos, inf, pi, sin
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

import carom
from carom.rows import kinds, kinds_in_motion, kinds_near, pose
from carom.rows.shape import BALL_KIND, KIND_NAMES
from carom.rows.tables import Row
from carom.shapes import SHAPE_CLASSES
from carom.world.kernels.continuous import support
from tests.conventions.source_trees import functions, kernel_files

Points = NDArray[np.float64]

UNKNOWN = 200
MANY = 20_001
#: How far apart two points of an outline may be, and what is found by looking at points and moments one by one.
NEAR = 2e-3

#: One shape of each kind, all about the middle of a room of 4 by 4, with the place of its outline that a ball is thrown
#: at and the unit normal there. A new kind needs its line here, and one in `outline` and `is_inside`.
SAMPLES: dict[str, tuple[carom.Shape, tuple[float, float], tuple[float, float]]] = {
    "point": (carom.Point((0.25, -0.5)), (0.25, -0.5), (0.6, 0.8)),
    "segment": (carom.Segment((-0.5, -0.5), (1.0, 0.625)), (0.25, 0.0625), (-0.6, 0.8)),
    "gate": (carom.Gate((-0.5, -0.5), (1.0, 0.625), direction=(0.6, -0.8)), (0.25, 0.0625), (0.6, -0.8)),
    "circle": (carom.Circle((0.25, -0.5), 0.8, solid=True), (0.73, 0.14), (0.6, 0.8)),
    "arc": (carom.Arc((0.25, -0.5), 0.8, 0.2, 2.0), (0.73, 0.14), (0.6, 0.8)),
}
STRAIGHT, ROUND, ENDED = {"segment", "gate"}, {"point", "circle", "arc"}, {"segment", "gate", "arc"}
RADIUS = 0.125
#: Fields that say where a shape is.
GEOMETRY = ("ax", "ay", "bx", "by", "cx", "cy", "dx", "dy", "start_angle", "end_angle")
BOXES = [(x, y, x + 0.3, y + 0.3) for x in np.arange(-1.5, 1.5, 0.37) for y in np.arange(-1.5, 1.5, 0.37)]
PLACES = [(float(x), float(y)) for x in np.arange(-1.5, 1.6, 0.29) for y in np.arange(-1.5, 1.6, 0.29)]

KINDS = pytest.mark.parametrize("kind", [KIND_NAMES[code] for code in SHAPE_CLASSES])


def row_of(kind: str) -> Row:
    """The row of the sample of a kind."""
    return SAMPLES[kind][0]._row


def outline(shape: Any) -> Points:
    """Many points along a shape from end to end, from what its attributes say."""
    share = np.linspace(0.0, 1.0, MANY)[:, None]
    if isinstance(shape, carom.Segment):
        return np.asarray(shape.p0) + share * (np.asarray(shape.p1) - np.asarray(shape.p0))
    if isinstance(shape, carom.Point):
        return np.array([shape.position])
    start, turn = 0.0, 2.0 * pi
    if isinstance(shape, carom.Arc):
        start, turn = shape.start_angle, (shape.end_angle - shape.start_angle) % (2.0 * pi)
    angles = start + share * turn
    return np.asarray(shape.center) + shape.radius * np.hstack([np.cos(angles), np.sin(angles)])


def nearest(kind: str, x: float, y: float) -> tuple[float, Points, bool, bool]:
    """The distance of a sample from a place, its point there, and whether that is a bare end; whether it is inside."""
    shape = SAMPLES[kind][0]
    points = outline(shape)
    ways = np.hypot(*(points - (x, y)).T)
    first = int(ways.argmin())
    bare = kind in ENDED and first in (0, MANY - 1)
    return float(ways[first]), points[first], bare, is_inside(shape, x, y)


def is_inside(shape: Any, x: float, y: float) -> bool:
    """Whether a place is inside of a shape that is solid."""
    return isinstance(shape, carom.Circle) and shape.contains((x, y))


def thrown(kind: str) -> tuple[float, float, float, float]:
    """The place of a ball before the side of a sample that stops it, and its velocity towards that."""
    _, (px, py), (nx, ny) = SAMPLES[kind]
    return px + nx, py + ny, -2.0 * nx, -2.0 * ny


def first_moment(kind: str, moved: Callable[[float], tuple[float, float]]) -> float:
    """The first share of a way, from 0 to 1, at which a ball that is at `moved(share)` touches a sample."""
    points = outline(SAMPLES[kind][0])[::20]
    for share in np.linspace(0.0, 1.0, 2001):
        x, y = moved(float(share))
        if float(np.hypot(*(points - (x, y)).T).min()) <= RADIUS:
            return float(share)
    return inf


# -- what the kinds are ----------------------------------------------------------------------------------------------


@KINDS
def test_what_a_kind_is(kind: str) -> None:
    code = int(row_of(kind)["kind"])
    assert kinds.is_straight(code) == (kind in STRAIGHT)
    assert kinds.is_round(code) == (kind in ROUND)
    assert kinds.has_ends(code) == (kind in ENDED)


@pytest.mark.parametrize("code", [UNKNOWN, BALL_KIND])
def test_no_other_kind_is_anything(code: int) -> None:
    assert not kinds.is_straight(code)
    assert not kinds.is_round(code)
    assert not kinds.has_ends(code)


# -- contact ---------------------------------------------------------------------------------------------------------


@KINDS
def test_contacts_and_gaps_are_as_far_and_in_the_direction_of_the_nearest_point(kind: str) -> None:
    row, seen = row_of(kind), 0
    for x, y in PLACES:
        away, point, bare, inside = nearest(kind, x, y)
        if away < 0.05:
            continue
        away, normal = (-away if inside else away), ((x, y) - point) / (-away if inside else away)
        radius = abs(away) + 0.1
        contact, gap = kinds.find_contact(row, x, y, radius, 0.0, 0.0), kinds.gap_at_rest(row, x, y, radius, 0, 0, 0)
        assert kinds.in_reach(row, x, y) == (kind in ENDED and not bare)
        assert (contact is None) == (gap is None) == bare
        if contact is not None and gap is not None:
            seen += 1
            assert contact == pytest.approx((*point, *normal, radius - away), abs=NEAR)
            assert gap == pytest.approx((away - radius, *normal), abs=NEAR)
            assert kinds.find_contact(row, x, y, 0.9 * away, 0.0, 0.0) is None or inside
    assert seen > 10


@KINDS
def test_what_is_detected_is_what_is_touched_but_by_a_gate_from_its_open_side(kind: str) -> None:
    row, (_, (px, py), (nx, ny)) = row_of(kind), SAMPLES[kind]
    for side in (1.0, -1.0):
        x, y = px + side * 0.1 * nx, py + side * 0.1 * ny
        opens = kind == "gate" and side < 0.0
        given = (row, x, y, RADIUS, -side * nx, -side * ny)
        assert kinds.lets_pass(row, x, y) == opens
        assert kinds.detect_contact(*given) == (None if opens else pytest.approx(kinds.find_contact(*given)))


def test_how_deep_a_ball_is_that_comes_past_an_end() -> None:
    expected = {"segment": 0.5, "gate": 0.5, "arc": 0.5}
    found = {}
    for kind in SAMPLES:
        (ax, ay), (bx, by) = outline(SAMPLES[kind][0])[[0, 1 if kind != "point" else 0]]
        way = np.array([bx - ax, by - ay]) / (np.hypot(bx - ax, by - ay) or 1.0)
        across = 0.5 * np.array([-way[1], way[0]])  # of a ball of radius 1, in the line by half of it
        edge = np.array([ax, ay]) + across
        begin, end = edge - 1e-3 * way, edge + 1e-3 * way
        found[kind] = kinds.depth_on_entry(row_of(kind), 1.0, *begin.tolist(), *end.tolist())
    assert {kind: depth for kind, depth in found.items() if depth > -inf} == pytest.approx(expected, abs=NEAR)


# -- near ------------------------------------------------------------------------------------------------------------


@KINDS
def test_the_nearest_point_and_its_distance(kind: str) -> None:
    row = row_of(kind)
    for x, y in PLACES:
        away, point, _, inside = nearest(kind, x, y)
        assert kinds_near.distance_to_shape(row, x, y) == pytest.approx(0.0 if inside else away, abs=NEAR)
        px, py, within = kinds_near.closest_on_shape(row, x, y)
        assert (np.hypot(x - px, y - py), within) == (pytest.approx(away, abs=NEAR), inside)
        assert np.hypot(*(point - (px, py))) < 0.1 or away > 0.3


@KINDS
def test_what_is_in_a_box(kind: str) -> None:
    points, shape = outline(SAMPLES[kind][0]), SAMPLES[kind][0]
    for left, bottom, right, top in BOXES:
        (x, y) = points.T
        meets = bool(((left <= x) & (x <= right) & (bottom <= y) & (y <= top)).any())
        meets = meets or is_inside(shape, left, bottom)
        assert kinds_near.box_meets_shape(row_of(kind), left, bottom, right, top) == meets


# -- in motion -------------------------------------------------------------------------------------------------------


@KINDS
def test_a_ball_touches_when_its_way_comes_within_its_radius(kind: str) -> None:
    x, y, vx, vy = thrown(kind)
    for ax, ay in ((0.0, 0.0), (0.3, -0.4)):
        moment = first_moment(
            kind, lambda t, a=(ax, ay): (x + (vx + 0.5 * a[0] * t) * t, y + (vy + 0.5 * a[1] * t) * t)
        )
        found = kinds_in_motion.impact_at_rest(row_of(kind), x, y, RADIUS, vx, vy, ax, ay, 1.0)
        assert found == pytest.approx(moment, abs=NEAR)
    assert kinds_in_motion.impact_at_rest(row_of(kind), x, y, RADIUS, -vx, -vy, 0.0, 0.0, 1.0) is None


@KINDS
def test_a_ball_touches_a_shape_that_travels_and_turns_when_it_comes_within_its_radius(kind: str) -> None:
    x, y, vx, vy = thrown(kind)
    row = row_of(kind)
    px, py = float(row["pivot_x"]), float(row["pivot_y"])

    def seen(t: float, ux: float, uy: float, spin: float) -> tuple[float, float]:
        dx, dy = x + vx * t - px - ux * t, y + vy * t - py - uy * t
        c, s = cos(spin * t), sin(spin * t)
        return px + c * dx + s * dy, py - s * dx + c * dy

    for ux, uy, spin in ((0.2, -0.1, 0.0), (0.1, 0.2, 0.3)):
        moment = first_moment(kind, lambda t, u=(ux, uy, spin): seen(t, *u))
        found = kinds_in_motion.impact_in_frame(row, ux, uy, spin, x, y, RADIUS, vx, vy, 0.0, 0.0, 1.0)
        assert found == pytest.approx(moment, abs=NEAR)


@KINDS
def test_a_moved_circle_stops_where_it_touches_and_a_gate_only_from_its_closed_side(kind: str) -> None:
    _, (px, py), (nx, ny) = SAMPLES[kind]
    x, y, dx, dy = thrown(kind)
    share = first_moment(kind, lambda t: (x + dx * t, y + dy * t))
    found = kinds_in_motion.ray_shape(row_of(kind), x, y, RADIUS, dx, dy)
    assert found == pytest.approx((share, px, py, nx, ny), abs=NEAR)
    behind = kinds_in_motion.ray_shape(row_of(kind), px - 2.0 * nx, py - 2.0 * ny, RADIUS, -dx, -dy)
    assert (behind is None) == (kind == "gate")


# -- pose ------------------------------------------------------------------------------------------------------------


@KINDS
def test_the_box_is_that_of_the_outline(kind: str) -> None:
    row = row_of(kind)
    pose.derive(row)
    points = outline(SAMPLES[kind][0])
    found = [float(row[side]) for side in ("left", "bottom", "right", "top")]
    assert found == pytest.approx([*points.min(axis=0), *points.max(axis=0)], abs=NEAR)


@KINDS
@pytest.mark.parametrize("turn", [0.0, 0.7])
def test_a_posed_shape_is_the_initial_one_turned_and_moved(kind: str, turn: float) -> None:
    row = row_of(kind).copy()
    before = outline(SAMPLES[kind][0])[:: MANY // 50] - (float(row["pivot_x"]), float(row["pivot_y"]))
    row["orientation"] = turn
    row["pivot_x"] += 0.5
    row["pivot_y"] -= 0.25
    pose.pose(row)
    c, s = cos(turn), sin(turn)
    for x, y in before:
        place = float(row["pivot_x"]) + c * x - s * y, float(row["pivot_y"]) + s * x + c * y
        assert kinds_near.distance_to_shape(row, *place) == pytest.approx(0.0, abs=1e-12)


# -- what slides along ------------------------------------------------------------------------------------------------


@KINDS
def test_what_keeps_a_ball_on_a_shape_at_rest(kind: str) -> None:
    _, (px, py), (nx, ny) = SAMPLES[kind]
    x, y, speed = px + RADIUS * nx, py + RADIUS * ny, 3.0
    bend = {"point": RADIUS, "circle": 0.8 + RADIUS, "arc": 0.8 + RADIUS}.get(kind, inf)
    held = support.holding_acceleration(row_of(kind), 0.0, x, y, -speed * ny, speed * nx, nx, ny)
    assert held == pytest.approx(-speed * speed / bend)


# -- a kind that there is not ----------------------------------------------------------------------------------------

#: What each question gets for an answer about a row of an unknown kind.
MISSES: dict[str, tuple[Callable[..., Any], tuple[float, ...], Any]] = {
    "find_contact": (kinds.find_contact, (0.0, 0.0, 9.0, 1.0, 0.0), None),
    "detect_contact": (kinds.detect_contact, (0.0, 0.0, 9.0, 1.0, 0.0), None),
    "gap_at_rest": (kinds.gap_at_rest, (0.0, 0.0, 9.0, 1.0, 0.0, 9.0), None),
    "in_reach": (kinds.in_reach, (0.0, 0.0), False),
    "depth_on_entry": (kinds.depth_on_entry, (9.0, -3.0, 0.0, 0.0, 0.0), -inf),
    "lets_pass": (kinds.lets_pass, (0.0, 0.0), False),
    "distance_to_shape": (kinds_near.distance_to_shape, (0.0, 0.0), inf),
    "closest_on_shape": (kinds_near.closest_on_shape, (0.0, 0.0), (inf, inf, False)),
    "box_meets_shape": (kinds_near.box_meets_shape, (-9.0, -9.0, 9.0, 9.0), False),
    "impact_at_rest": (kinds_in_motion.impact_at_rest, (-3.0, -3.0, 9.0, 1.0, 1.0, 0.0, 0.0, 9.0), None),
    "impact_in_frame": (
        kinds_in_motion.impact_in_frame,
        (0.0, 0.0, 1.0, -3.0, -3.0, 9.0, 1.0, 1.0, 0.0, 0.0, 9.0),
        None,
    ),
    "ray_shape": (kinds_in_motion.ray_shape, (-3.0, -3.0, 9.0, 6.0, 6.0), None),
    "bend_center": (kinds.bend_center, (), None),
}

#: Those that write; each has a test of its own here.
WRITERS = {"derive", "pose", "_shift", "_turn"}
#: It does with an unknown kind what it does with a gate: it lets the ball go on for a part of the substep.
INDIFFERENT = {"slide_time"}


@KINDS
@pytest.mark.parametrize("question", MISSES)
def test_an_unknown_kind_is_met_by_nothing(kind: str, question: str) -> None:
    function, arguments, miss = MISSES[question]
    row = row_of(kind).copy()
    row["kind"] = UNKNOWN
    assert function(row, *arguments) == miss


@KINDS
def test_an_unknown_kind_is_everywhere_and_stays_so_when_it_moves(kind: str) -> None:
    row = row_of(kind).copy()
    row["kind"] = UNKNOWN
    before = row.copy()
    row["pivot_x"] += 1.0
    for turn in (0.0, 0.5):
        row["orientation"] = turn
        pose.pose(row)
        assert [float(row[side]) for side in ("left", "bottom", "right", "top")] == [-inf, -inf, inf, inf]
        assert all(row[field] == before[field] for field in GEOMETRY)


def tells_kinds_apart(function: ast.FunctionDef | ast.AsyncFunctionDef) -> bool:
    """Whether a function of shapes compares codes of kinds, or does so by asking what is straight or round."""
    nodes = list(ast.walk(function))
    named = {
        part.id
        for node in nodes
        if isinstance(node, ast.Compare)
        for part in ast.walk(node.comparators[0])
        if isinstance(part, ast.Name)
    }
    asked = {node.func.id for node in nodes if isinstance(node, ast.Call) and isinstance(node.func, ast.Name)}
    of_shapes = "ShapeRow" in ast.unparse(function.args)
    return of_shapes and bool(named & {name.upper() for name in KIND_NAMES} or asked & {"is_straight", "is_round"})


def test_every_kernel_that_tells_kinds_apart_is_asked_here() -> None:
    telling = {function.name for path in kernel_files() for function in functions(path) if tells_kinds_apart(function)}
    assert telling == MISSES.keys() | WRITERS | INDIFFERENT
