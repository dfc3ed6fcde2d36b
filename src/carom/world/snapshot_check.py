"""Whether what a snapshot holds is a state that a world can be in: everything is checked before anything is changed."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property, lru_cache
from math import isclose
from typing import Any, cast

import numpy as np

from carom.constants import SNAPSHOT_TOLERANCE, TWO_PI
from carom.errors import InvalidArgument, SnapshotError
from carom.rows.ball import BALL
from carom.rows.flight import ASLEEP, COURSE, FLYING
from carom.rows.hit import EXIT, HIT
from carom.rows.kinds import is_straight
from carom.rows.pose import derive
from carom.rows.relation import INSIDE_BALL, INSIDE_SHAPE, LASTING, LYING, NO_RELATION, PASSING
from carom.rows.shape import ARC, CIRCLE, GATE, KINEMATIC, POINT, SHAPE, STATIC, ShapeRow
from carom.rows.state import DISCRETE, MOTIONS_CHANGED, STATE
from carom.rows.tables import Rows
from carom.shapes import SHAPE_CLASSES
from carom.shapes.compound import Compound
from carom.shapes.table import word_of
from carom.world.kernels.step.relations import is_of_balls
from carom.world.removal import Relation
from carom.world.settings import SETTINGS, Settings
from carom.world.statistics import COUNTERS

#: Fields of the state that a snapshot holds: the settings, which stand before the time, and what has come of the steps.
KEPT = (
    *(STATE.names or ())[: (STATE.names or ()).index("time")],
    *("time", "time_low", "next_id", *COUNTERS, "balls", "shapes", "wake", "reach"),
)

#: The others only say how its tables stand, or where an unfinished step is; a snapshot leaves them at 0.
DERIVED = tuple(name for name in STATE.names or () if name not in KEPT)


#: The words of 64 bits of a shape's row that are floats.
FLOATS = [word_of(SHAPE, field) for field in SHAPE.names or () if SHAPE[field].kind == "f"]

#: Rows of shapes of which it is kept whether they agree: most shapes are the same in one snapshot after the other.
ROWS_KEPT = 1024


@dataclass(frozen=True)
class Contents:
    """What a snapshot holds: names, compounds and groups, and the tables of a world."""

    header: dict[str, Any]
    state: Rows
    balls: Rows
    shapes: Rows
    relations: Rows
    hits: Rows
    courses: Rows

    @cached_property
    def ids_and_kinds(self) -> tuple[bytes, ...]:
        """The ids of the balls, those of the shapes, and the kinds of these."""
        return ids_and_kinds(self.balls, self.shapes)

    @cached_property
    def names(self) -> dict[int, str]:
        """The names of members, by their ids."""
        return {int(key): name for key, name in self.header["names"].items()}

    @property
    def relation_list(self) -> list[Relation]:
        """The relations as they are outside of a pool."""
        return [(int(kind), int(ball), int(other), *force) for kind, ball, other, *force in self.relations.tolist()]


def ids_and_kinds(balls: Rows, shapes: Rows) -> tuple[bytes, ...]:
    """The ids of balls, those of shapes, and the kinds of these."""
    return balls["id"].tobytes(), shapes["id"].tobytes(), shapes["kind"].tobytes()


def check_contents(contents: Contents) -> None:
    """Raise `SnapshotError` where the contents are not a state that a world can be in."""
    tables = (contents.state, contents.balls, contents.shapes, contents.relations, contents.hits, contents.courses)
    kinds = [STATE, BALL, SHAPE, np.dtype("f8"), HIT, COURSE]
    need([table.dtype for table in tables] == kinds, "tables of another version")
    need([table.ndim for table in tables] == [1, 1, 1, 2, 1, 1], "tables of another form")
    _check_state(contents)
    _check_balls(contents.balls)
    _check_shapes(contents.shapes)
    _check_relations(contents)
    _check_hits(contents)
    _check_courses(contents)
    _check_header(contents)


def need(right: Any, fault: str) -> None:
    """Raise `SnapshotError` unless something is right."""
    if not right:
        raise SnapshotError(f"snapshot has {fault}")


def _check_state(contents: Contents) -> None:
    """Raise where settings, counts or time are none that a world can have."""
    need(len(contents.state) == 1, "more than one state")
    state = contents.state[0]
    expected = contents.state.copy()
    for name in (*DERIVED, *COUNTERS):
        expected[name] = 0 if name in DERIVED else abs(state[name])
    expected["balls"], expected["shapes"] = len(contents.balls), len(contents.shapes)
    expected["sleeping"] = np.count_nonzero(contents.balls["asleep"])
    expected["wake"] = state["wake"] if 0 <= state["wake"] <= MOTIONS_CHANGED else 0
    for name in SETTINGS:
        setting = vars(Settings)[name]
        try:
            setting._write(expected[0], setting.check(name, setting._read(state)))
        except (InvalidArgument, IndexError) as error:
            raise SnapshotError(f"snapshot has a bad setting: {error}") from None
    need(expected.tobytes() == contents.state.tobytes(), "a state that no world is in between two steps")
    need(0.0 <= float(state["time"]) < np.inf and 0.0 <= float(state["reach"]) < np.inf, "a time that is not finite")
    need(abs(state["time_low"]) <= np.spacing(state["time"]), "a time that is not the sum of two")
    for rows in (contents.balls, contents.shapes):
        ids = rows["id"]
        need((np.diff(ids) > 0).all(), "ids out of order")
        need(not len(ids) or 0 < ids[0] <= ids[-1] < state["next_id"], "ids out of range")
    need(not np.intersect1d(contents.balls["id"], contents.shapes["id"]).size, "an id twice")


def _check_balls(balls: Rows) -> None:
    """Raise where what only balls' setters write is wrong. What views may write, the next step checks."""
    need((balls["relation"] == NO_RELATION).all(), "balls with relations of their own")
    need((np.isfinite(balls["still_time"]) & (balls["still_time"] >= 0.0)).all(), "balls with a bad time of rest")
    for field in ("sensor", "can_collide", "asleep", "stray"):
        need((balls[field] <= 1).all(), "balls with bad switches")


def _check_shapes(shapes: Rows) -> None:
    """Raise where a shape is none that constructors and setters let through."""
    kinds, motions = shapes["kind"], shapes["motion"]
    need(np.isin(kinds, tuple(SHAPE_CLASSES)).all() and (motions <= KINEMATIC).all(), "shapes of unknown kinds")
    words = shapes.view(np.float64).reshape(len(shapes), SHAPE.itemsize // 8)
    need(np.isfinite(words[:, FLOATS]).all(), "shapes that are not finite")
    for field in ("sensor", "can_collide", "solid", "rotating", "turn_limited", "once"):
        need((shapes[field] <= 1).all(), "shapes with bad switches")
    need((shapes["elasticity"] >= 0.0).all() and (shapes["kick"] >= 0.0).all(), "shapes with a bad elasticity or kick")
    need((shapes["radius"][(kinds == CIRCLE) | (kinds == ARC)] > 0.0).all(), "circles with a bad radius")
    moving = (shapes["angular_velocity"] != 0.0) | (shapes["velocity_x"] != 0.0) | (shapes["velocity_y"] != 0.0)
    moving |= shapes["time_left"] != 0.0
    need((shapes["time_left"] >= 0.0).all(), "shapes that have arrived and do not rest")
    need(not ((moving | (shapes["turn_limited"] != 0)) & (motions == STATIC)).any(), "static shapes that move")
    limited = shapes[shapes["turn_limited"] != 0]
    inside = (limited["turn_low"] <= limited["orientation"]) & (limited["orientation"] <= limited["turn_high"])
    sent = limited["target_orientation"]
    inside &= (limited["time_left"] == 0.0) | ((limited["turn_low"] <= sent) & (sent <= limited["turn_high"]))
    need((inside & (limited["turn_low"] <= 0.0) & (limited["turn_high"] >= 0.0)).all(), "shapes beyond their stops")
    arcs = shapes[kinds == ARC]
    for field in ("start_angle", "end_angle", "initial_start_angle", "initial_end_angle"):
        need(((arcs[field] >= 0.0) & (arcs[field] < TWO_PI)).all(), "arcs with bad angles")
    need((arcs["initial_start_angle"] != arcs["initial_end_angle"]).all(), "arcs of no length")
    data = shapes.tobytes()
    rows = (data[at : at + SHAPE.itemsize] for at in range(0, len(data), SHAPE.itemsize))
    need(all(map(_agrees, rows)), "shapes whose parts do not agree")


@lru_cache(ROWS_KEPT)
def _agrees(data: bytes) -> bool:
    """Whether what follows from a shape's geometry (ends, tangent, middle, box) is what its row, as bytes, says.

    Not to the bit: on another machine sines and cosines may have other last digits.
    """
    row = dict(zip(SHAPE.names or (), np.frombuffer(data, SHAPE)[0].item(), strict=True))
    derived = dict(row)
    derive(cast(ShapeRow, derived))
    size = max(abs(row[field]) for field in ("left", "bottom", "right", "top", "radius", "length"))
    near = {name: SNAPSHOT_TOLERANCE * (1.0 if name in ("tx", "ty") else size) for name in row}
    if is_straight(row["kind"]) and (row["ax"], row["ay"]) == (row["bx"], row["by"]):
        return False
    if row["kind"] == GATE and not isclose(row["dx"] ** 2 + row["dy"] ** 2, 1.0, abs_tol=SNAPSHOT_TOLERANCE):
        return False
    return all(isclose(row[name], derived[name], rel_tol=0.0, abs_tol=near[name]) for name in row)


def _check_relations(contents: Contents) -> None:
    """Raise where a relation is of rows that are not there, or of kinds that have none."""
    need(contents.relations.shape[1] == 5, "relations of another form")
    need(np.isfinite(contents.relations).all(), "relations that are not finite")
    need((contents.relations[:, :3] % 1.0 == 0.0).all(), "relations of no rows")
    for kind, ball, other, _x, _y in contents.relation_list:
        others = contents.balls if is_of_balls(kind) else contents.shapes
        need(kind in (PASSING, INSIDE_SHAPE, INSIDE_BALL, LASTING, LYING), "relations of unknown kinds")
        need(0 <= ball < len(contents.balls) and 0 <= other < len(others), "relations of unknown rows")
        need(kind != INSIDE_BALL or other < ball, "relations of balls in the wrong order")
    lying = {(ball, other): (x, y) for kind, ball, other, x, y in contents.relation_list if kind == LYING}
    both = all(i != j and lying.get((j, i)) == (-x, -y) for (i, j), (x, y) in lying.items())
    need(both, "balls that lie on each other by halves")
    need(len({relation[:3] for relation in contents.relation_list}) == len(contents.relations), "a relation twice")


def _check_hits(contents: Contents) -> None:
    """Raise where a pending hit cannot have happened."""
    hits, next_id = contents.hits, contents.state[0]["next_id"]
    need((hits["kind"] >= 0).all() and (hits["kind"] <= EXIT).all(), "hits of unknown kinds")
    need(np.isfinite(hits["time"]).all(), "hits at no time")
    for field in ("ball", "shape"):
        need((hits[field] > 0).all() and (hits[field] < next_id).all(), "hits of unknown ids")


def _check_courses(contents: Contents) -> None:
    """Raise where a flight is none that a ball can be on, or there are too few of them or too many."""
    courses, discrete = contents.courses, contents.state[0]["detection"] == DISCRETE
    need(len(courses) == (0 if discrete else len(contents.balls)), "flights of other balls")
    for field in COURSE.names or ():
        if courses[field].dtype.kind == "f":
            need(np.isfinite(courses[field]).all(), "flights that are not finite")
    need(((courses["kind"] == FLYING) | (courses["kind"] == ASLEEP)).all(), "flights of unknown kinds")
    need((courses["time"] <= contents.state[0]["time"]).all(), "flights that begin later than now")


def _check_header(contents: Contents) -> None:
    """Raise where names, compounds or groups are of what is not there."""
    header = contents.header
    need(set(header) == {"names", "compounds", "groups"}, "another header")
    ids, kinds, motions = (contents.shapes[field].tolist() for field in ("id", "kind", "motion"))
    shapes = dict(zip(ids, zip(kinds, motions, strict=True), strict=True))
    known = {str(key) for key in (*shapes, *contents.balls["id"].tolist())}
    need(set(header["names"]) <= known, "names of nothing")
    need(all(isinstance(name, str) for name in header["names"].values()), "names that are no text")
    taken: list[int] = []
    for kind, motion in (("compounds", KINEMATIC), ("groups", STATIC)):
        for whole in header[kind]:
            need(set(whole) == {"parts", "name", "surface"}, f"{kind} of another form")
            parts = whole["parts"]
            need(all(type(part) is int and part in shapes for part in parts), f"{kind} of unknown parts")
            need(parts, f"{kind} without parts")
            need(all(shapes[part][1] == motion for part in parts), f"{kind} whose parts do not move as they must")
            need(whole["name"] is None or isinstance(whole["name"], str), "names that are no text")
            _check_surface(whole["surface"])
            taken += parts
    for compound in header["compounds"]:
        need(shapes[compound["parts"][0]][0] == POINT, "a compound without a center point")
    need(len(set(taken)) == len(taken), "a shape in two compounds or groups")
    _check_drops(contents.shapes, header["groups"])


def _check_surface(surface: dict[str, Any]) -> None:
    """Raise where what was set for all parts of a compound or group cannot be."""
    if surface == {}:
        return
    probe = Compound([], (0.0, 0.0))
    try:
        for name, value in surface.items():
            setattr(probe, name, value)
    except (AttributeError, InvalidArgument) as error:
        raise SnapshotError(f"snapshot has a compound or group with a bad surface: {error}") from None
    need(probe._surface == surface, "a compound or group with a surface of another form")


def _check_drops(shapes: Rows, groups: list[dict[str, Any]]) -> None:
    """Raise where shapes switch themselves off together that are not a group which does."""
    expected = np.zeros(len(shapes), np.int64)
    for group in groups:
        if group["surface"].get("once"):
            parts = np.array(group["parts"], np.int64)
            expected[np.searchsorted(shapes["id"], parts)] = np.roll(parts, -1)
    need((shapes["drops_with"] == expected).all(), "shapes that drop with others than those of their group")
