"""What a snapshot may not hold, though its hash is right: each field, each relation, each name, one at a time."""

import json
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

import carom
from carom.rows.relation import LYING
from carom.rows.shape import ARC, SHAPE
from carom.rows.state import STATE
from tests.snapshots import Parts, eventful, put_together, refused, taken_apart

NAN, INF = float("nan"), float("inf")


@pytest.fixture(scope="module")
def world() -> carom.World:
    """A world in the middle of things."""
    return eventful()


STATE_FAULTS: dict[str, list[Any]] = {
    "gravity_x": [NAN, INF],
    "gravity_y": [NAN, -INF],
    "friction": [-1.0, NAN],
    "sleep_speed": [-1.0, INF],
    "sleep_time": [-1.0, NAN],
    "rest_speed": [NAN, INF, -2.0],
    "max_speed": [0.0, NAN, -2.0],
    "left": [NAN, 1e9],
    "bottom": [INF, 1e9],
    "right": [NAN, -1e9],
    "top": [-INF, -1e9],
    "max_impacts": [-1, 2**40],
    "substeps": [0, -1, 2**40],
    "iterations": [0, -5],
    "levels": [0, 17],
    "detection": [-1, 2, 99],
    "broad_phase": [-1, 3],
    "total_restitution": [-1, 2],
    "bounded": [2, -1],
    "remove_strays": [2],
    "time": [NAN, INF, -1.0],
    "next_id": [0, -1, 3],
    "sleeping": [-1, 1000],
    "collisions": [-1],
    "balls": [0, 10**6, -1],
    "shapes": [0, 10**6, -1],
    "wake": [3, -1],
    "reach": [NAN, -1.0],
}


BALL_FAULTS: dict[str, list[Any]] = {
    "still_time": [-1.0, NAN],
    "id": [0, -1, 10**9],
    "relation": [0, 5, -2],
    "sensor": [2],
    "can_collide": [7],
    "asleep": [2],
    "stray": [255],
}


SHAPE_FAULTS: dict[str, list[Any]] = {
    **{name: [NAN, INF, -INF] for name in SHAPE.names or () if SHAPE[name].kind == "f"},
    "left": [1e3, -1e9, NAN],
    "kind": [5, 255],
    "motion": [2, 255],
    "sensor": [2],
    "solid": [3],
    "rotating": [2],
    "turn_limited": [2],
    "once": [2],
    "elasticity": [-1.0],
    "kick": [-0.5, NAN],
    "id": [0, 10**9, -3],
    "ax": [50.0],
    "cy": [-50.0],
    "tx": [0.5],
    "length": [-1.0, 99.0],
    "turn_low": [0.5, NAN],
    "angular_velocity": [NAN],
    "orientation": [NAN, 99.0],
}


@pytest.mark.parametrize("field", STATE.names or ())
def test_a_bad_state_is_refused(world: carom.World, field: str) -> None:
    parts = taken_apart(world.snapshot())
    for value in STATE_FAULTS.get(field, [-1]):
        state = parts.state.copy()
        state[field] = value
        assert refused(world, put_together(parts._replace(state=state))), (field, value)


@pytest.mark.parametrize("field", BALL_FAULTS)
def test_a_bad_ball_is_refused(world: carom.World, field: str) -> None:
    parts = taken_apart(world.snapshot())
    for value in BALL_FAULTS[field]:
        for row in (0, len(parts.balls) - 1):
            balls = parts.balls.copy()
            balls[field][row] = value
            assert refused(world, put_together(parts._replace(balls=balls))), (field, value)


@pytest.mark.parametrize("field", SHAPE_FAULTS)
def test_a_bad_shape_is_refused(world: carom.World, field: str) -> None:
    parts = taken_apart(world.snapshot())
    limited = int(np.flatnonzero(parts.shapes["turn_limited"])[0])
    for value in SHAPE_FAULTS[field]:
        shapes = parts.shapes.copy()
        shapes[field][limited] = value
        assert refused(world, put_together(parts._replace(shapes=shapes))), (field, value)


def test_impossible_shapes_are_refused(world: carom.World) -> None:
    parts = taken_apart(world.snapshot())
    kinds, motions = parts.shapes["kind"], parts.shapes["motion"]
    faults: list[tuple[Any, str, Any]] = [
        (kinds == ARC, "start_angle", 7.0),
        (kinds == ARC, "end_angle", -0.5),
        (kinds == ARC, "radius", -1.0),
        (kinds == ARC, "initial_end_angle", parts.shapes["initial_start_angle"][kinds == ARC][0]),
        (kinds == 3, "radius", 0.0),
        (kinds == 2, "dx", 3.0),
        (motions == 0, "velocity_x", 1.0),
        (motions == 0, "turn_limited", 1),
        (motions == 1, "motion", 0),
    ]
    for mask, field, value in faults:
        shapes = parts.shapes.copy()
        shapes[field][np.flatnonzero(mask)[0]] = value
        assert refused(world, put_together(parts._replace(shapes=shapes))), (field, value)
    shapes = parts.shapes.copy()
    row = shapes[np.flatnonzero(kinds == 1)[0]]
    row["bx"], row["by"], row["length"] = row["ax"], row["ay"], 0.0
    assert refused(world, put_together(parts._replace(shapes=shapes)))


@pytest.mark.parametrize(
    "relation",
    [(-1, 0, 0), (9, 0, 0), (0, -1, 0), (0, 99, 0), (1, 0, -1), (1, 0, 999), (2, 0, 0), (2, 0, 5), (2, 3, 99)],
)
def test_a_relation_of_nothing_is_refused(world: carom.World, relation: tuple[int, int, int]) -> None:
    parts = taken_apart(world.snapshot())
    relations = np.concatenate([parts.relations, np.array([(*relation, 0.0, 0.0)])])
    assert refused(world, put_together(parts._replace(relations=relations)))


def test_balls_that_lie_on_each_other_do_so_both(world: carom.World) -> None:
    parts = taken_apart(world.snapshot())
    for rows in (
        [(LYING, 0, 1, 2.0, 0.0)],
        [(LYING, 0, 0, 2.0, 0.0)],
        [(LYING, 0, 1, 2.0, 0.0), (LYING, 1, 2, -2.0, 0.0)],
        [(LYING, 0, 1, 2.0, 0.0), (LYING, 1, 0, 2.0, 0.0)],
    ):
        relations = np.concatenate([parts.relations, np.array(rows)])
        assert refused(world, put_together(parts._replace(relations=relations)))


@pytest.mark.parametrize(("column", "value"), [(0, 0.5), (1, 0.5), (2, 0.5), (3, NAN), (4, INF)])
def test_a_relation_that_is_no_row_or_has_no_force_is_refused(world: carom.World, column: int, value: float) -> None:
    parts = taken_apart(world.snapshot())
    parts.relations[0, column] += value
    assert refused(world, put_together(parts))


def test_relations_that_cannot_be_are_refused(world: carom.World) -> None:
    parts = taken_apart(world.snapshot())
    for relations in (
        np.concatenate([parts.relations, parts.relations[:1]]),
        parts.relations.astype("i4"),
        parts.relations[:, :4].copy(),
        parts.relations.T.copy(),
        parts.relations.ravel(),
        parts.relations[:, :2].copy(),
    ):
        assert refused(world, put_together(parts._replace(relations=relations)))


@pytest.mark.parametrize(
    ("field", "value"), [("kind", 3), ("kind", -1), ("ball", 0), ("ball", 10**9), ("shape", -1), ("time", NAN)]
)
def test_a_hit_that_cannot_have_happened_is_refused(world: carom.World, field: str, value: Any) -> None:
    parts = taken_apart(world.snapshot())
    parts.hits[field][0] = value
    assert refused(world, put_together(parts))


def mill_of(header: dict[str, Any]) -> dict[str, Any]:
    """The compound that a header speaks of."""
    (mill,) = header["compounds"]
    found: dict[str, Any] = mill
    return found


HEADER_FAULTS: list[Callable[[dict[str, Any]], Any]] = [
    lambda header: header.pop("names"),
    lambda header: header.update(more=1),
    lambda header: header.update(names=[]) or header.update(names=None),
    lambda header: header["names"].update({"999": "nothing"}),
    lambda header: header["names"].update({"x": "no id"}),
    lambda header: header["names"].update({"01": "no id"}),
    lambda header: header["names"].update({"1": 5}),
    lambda header: header["names"].update({"1": None}),
    lambda header: header.update(compounds={}) or header.update(compounds=5),
    lambda header: header["compounds"].append(header["compounds"][0]),
    lambda header: header["compounds"].append({"parts": [], "name": None, "surface": {}}),
    lambda header: mill_of(header).pop("surface"),
    lambda header: mill_of(header).update(name=5),
    lambda header: mill_of(header).update(parts=[]),
    lambda header: mill_of(header)["parts"].append(999),
    lambda header: mill_of(header)["parts"].append(1),
    lambda header: mill_of(header)["parts"].append("2"),
    lambda header: mill_of(header)["parts"].append(True),
    lambda header: mill_of(header)["parts"].append([1]),
    lambda header: mill_of(header)["parts"].append(mill_of(header)["parts"][1]),
    lambda header: mill_of(header)["parts"].reverse(),
    lambda header: mill_of(header)["surface"].update(elasticity=-1),
    lambda header: mill_of(header)["surface"].update(elasticity=NAN),
    lambda header: mill_of(header)["surface"].update(layer="all"),
    lambda header: mill_of(header)["surface"].update(velocity=[1, 0]),
    lambda header: mill_of(header)["surface"].update(shade=3),
    lambda header: mill_of(header)["surface"].update(sensor=1),
    lambda header: header.pop("groups"),
    lambda header: header["groups"].append({"parts": mill_of(header)["parts"], "name": None, "surface": {}}),
    lambda header: header["groups"].append({"parts": [], "name": None, "surface": {}}),
    lambda header: header["groups"].append({"parts": [1, 1], "name": None, "surface": {}}),
    lambda header: header["groups"].append({"parts": [1, 999], "name": None, "surface": {}}),
    lambda header: header["groups"].append({"parts": [1], "name": None, "surface": {"once": True}}),
    lambda header: header["groups"].append({"parts": [1], "name": None, "surface": {"shade": 1}}),
]


@pytest.mark.parametrize("fault", range(len(HEADER_FAULTS)))
def test_a_bad_header_is_refused(world: carom.World, fault: int) -> None:
    parts = taken_apart(world.snapshot())
    header = json.loads(parts.text.tobytes())
    HEADER_FAULTS[fault](header)
    text = np.frombuffer(json.dumps(header).encode(), "u1")
    assert refused(world, put_together(parts._replace(text=text)))


@pytest.mark.parametrize("text", [b"", b"{}", b"[]", b"null", b"\xff\xfe", b"{" * 5000, b"nonsense"])
def test_a_header_that_is_none_is_refused(world: carom.World, text: bytes) -> None:
    parts = taken_apart(world.snapshot())
    assert refused(world, put_together(parts._replace(text=np.frombuffer(text, "u1"))))


def test_tables_of_another_form_are_refused(world: carom.World) -> None:
    parts = taken_apart(world.snapshot())
    for place, name in enumerate(Parts._fields[1:], start=1):
        table = parts[place]
        others = [table[None], table[:0].reshape(-1)[:0] if name == "state" else table.astype(object, copy=True)]
        if table.dtype.names:
            others += [table[list(table.dtype.names[1:])], np.zeros(len(table)), table.view("u1").reshape(-1)]
        for other in others:
            if other.dtype.hasobject:
                continue
            assert refused(world, put_together(parts._replace(**{name: other}))), name
    doubled = np.concatenate([parts.balls, parts.balls])
    assert refused(world, put_together(parts._replace(balls=doubled)))
    assert refused(world, put_together(parts._replace(state=np.concatenate([parts.state, parts.state]))))


def test_an_id_of_a_ball_and_a_shape_is_refused(world: carom.World) -> None:
    parts = taken_apart(world.snapshot())
    last = parts.shapes["id"][-1]
    balls = parts.balls.copy()
    balls["id"] = np.sort(np.concatenate([balls["id"][1:], [last]]))
    assert refused(world, put_together(parts._replace(balls=balls)))
