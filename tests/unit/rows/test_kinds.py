"""Every question about a shape, asked of every kind and of one that there is not, against an outline of many points."""

import ast
from collections.abc import Callable
from math import inf, pi
from typing import Any

import numpy as np
import pytest

from carom import Arc, Segment
from carom.geometry.path import Path, Turning
from carom.rows import kinds, kinds_in_motion, kinds_near, pose
from carom.rows.kinds import depth_on_entry
from carom.rows.shape import BALL_KIND, KIND_NAMES
from carom.world.kernels.continuous import lasting
from tests.conventions.source_trees import functions, kernel_files
from tests.unit.rows.samples import (
    ENDED,
    KINDS,
    NEAR,
    PLACES,
    RADIUS,
    ROUND,
    SAMPLES,
    STRAIGHT,
    nearest,
    outline,
    row_of,
)

UNKNOWN = 200

#: Fields that say where a shape is.
GEOMETRY = ("ax", "ay", "bx", "by", "cx", "cy", "dx", "dy", "start_angle", "end_angle")


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


# -- what slides along ------------------------------------------------------------------------------------------------


@KINDS
def test_what_keeps_a_ball_on_a_shape_at_rest(kind: str) -> None:
    _, (px, py), (nx, ny) = SAMPLES[kind]
    x, y, speed = px + RADIUS * nx, py + RADIUS * ny, 3.0
    bend = {"point": RADIUS, "circle": 0.8 + RADIUS, "arc": 0.8 + RADIUS}.get(kind, inf)
    held = lasting.holding_acceleration(row_of(kind), 0.0, x, y, -speed * ny, speed * nx, nx, ny)
    assert held == pytest.approx(-speed * speed / bend)


@KINDS
def test_only_in_a_hollow_bend_smaller_than_itself_a_ball_lacks_room(kind: str) -> None:
    row = row_of(kind).copy()
    row["solid"] = 0
    x, y, r = float(row["cx"]), float(row["cy"]), float(row["radius"])
    hollow = kind in {"circle", "arc"}
    assert kinds.lacks_room(row, x + 0.5 * r, y, 1.01 * r) == hollow
    assert not kinds.lacks_room(row, x + 0.5 * r, y, r)
    assert not kinds.lacks_room(row, x + 1.01 * r, y, 1.01 * r)
    row["solid"] = 1
    assert kinds.lacks_room(row, x + 0.5 * r, y, 1.01 * r) == (kind == "arc")


# -- a kind that there is not ----------------------------------------------------------------------------------------

NEARING = Path(-3.0, -3.0, 1.0, 1.0, 0.0, 0.0)
#: What each question gets for an answer about a row of an unknown kind.
MISSES: dict[str, tuple[Callable[..., Any], tuple[Any, ...], Any]] = {
    "find_contact": (kinds.find_contact, (0.0, 0.0, 9.0, 1.0, 0.0), None),
    "detect_contact": (kinds.detect_contact, (0.0, 0.0, 9.0, 1.0, 0.0), None),
    "gap_at_rest": (kinds.gap_at_rest, (0.0, 0.0, 9.0, 1.0, 0.0, 9.0), None),
    "in_reach": (kinds.in_reach, (0.0, 0.0), False),
    "depth_on_entry": (kinds.depth_on_entry, (9.0, -3.0, 0.0, 0.0, 0.0), -inf),
    "lets_pass": (kinds.lets_pass, (0.0, 0.0), False),
    "distance_to_shape": (kinds_near.distance_to_shape, (0.0, 0.0), inf),
    "closest_on_shape": (kinds_near.closest_on_shape, (0.0, 0.0), (inf, inf, False)),
    "height_over": (kinds_near.height_over, (0.0, 0.0, 1.0, 1.0), inf),
    "crosses_side": (kinds_near.crosses_side, (-9.0, -9.0, 18.0, 18.0, 1.0), False),
    "box_meets_shape": (kinds_near.box_meets_shape, (-9.0, -9.0, 9.0, 9.0), False),
    "impact_at_rest": (kinds_in_motion.impact_at_rest, (NEARING, 9.0, 9.0), None),
    "impact_in_frame": (
        kinds_in_motion.impact_in_frame,
        (Turning(0.0, 0.0, 0.0, 0.0, 1.0), NEARING, 9.0, 9.0),
        None,
    ),
    "ray_shape": (kinds_in_motion.ray_shape, (-3.0, -3.0, 9.0, 6.0, 6.0), None),
    "bend_center": (kinds.bend_center, (), None),
    "lacks_room": (kinds.lacks_room, (0.0, 0.0, 9.0), False),
}

#: Those that write; each has a test of its own here.
WRITERS = {"derive", "pose_by", "_shift", "_turn"}
#: What they do with an unknown kind is what they do with most: a ball slides along it for a part of the substep, and
#: it is a wall, if a point is on it; having arrived, it is everywhere.
INDIFFERENT = {"time_to_end", "past_end", "_arrive"}


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


def test_the_depth_on_entry_is_the_least_before_and_where_the_centre_crosses_an_edge() -> None:
    wall = Segment((0, 0), (10, 0))._row
    assert depth_on_entry(wall, 1.0, -1.0, 0.5, 3.0, 0.5) == pytest.approx(0.5)
    assert depth_on_entry(wall, 1.0, -1.0, 2.0, 1.0, 0.0) == pytest.approx(-1)
    assert depth_on_entry(wall, 1.0, 12.0, 0.5, 8.0, -1.5) == pytest.approx(0.5)
    assert depth_on_entry(wall, 1.0, 12.0, 0.0, 8.0, 1.5) == pytest.approx(0.25)
    arc = Arc((0, 0), 5, 0, pi / 2)._row
    assert depth_on_entry(arc, 1.0, 5.0, -1e-9, 4.5, 1.0) == pytest.approx(1)
    assert depth_on_entry(arc, 1.0, 5.0, -2.0, 5.0, 1.0) == pytest.approx(1 - (29**0.5 - 5))
    assert depth_on_entry(arc, 1.0, -1.0, 5.5, 1.0, 4.5) == pytest.approx(1 - (31.25**0.5 - 5))
    assert depth_on_entry(arc, 1.0, 3.0, -3.0, 3.0, 1.0) == pytest.approx(-1)
    assert depth_on_entry(arc, 1.0, -1.0, -1.0, 1.0, 1.0) == pytest.approx(-4)
