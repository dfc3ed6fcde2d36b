"""Shapes and balls as views of rows: alone, in a table of a world, and back; their copies."""

import copy
import gc
import inspect
import pickle
import weakref
from typing import Any

import numpy as np
import pytest

from carom import Arc, Ball, Circle, Gate, Point, Segment, Shape
from carom.rows.ball import BALL
from carom.rows.shape import KIND_NAMES, SHAPE
from carom.shapes import SHAPE_CLASSES
from carom.shapes.table import RowTable
from carom.turns import Turn
from tests.worlds import row_bits

Member = Shape | Ball
MEMBERS: list[Member] = [
    Point((1, 2), name="post", user=[1, 2]),
    Segment((1, 2), (3, 4), elasticity=0.5, motion="kinematic", angular_velocity=1),
    Gate((1, 2), (3, 4), direction=(0, 1)),
    Circle((1, 2), 3, solid=True),
    Arc((1, 2), 3, 1, 2),
    Ball((1, 2), 3, velocity=(4, 5), mass=6),
]
each_member = pytest.mark.parametrize("member", MEMBERS, ids=lambda member: member.kind)


class Home:
    """A world that only takes note of changes."""

    def __init__(self) -> None:
        self.changes = 0
        self._turn = Turn()

    def _changed(self, member: Member) -> None:
        self.changes += 1

    def _note_change(self) -> None:
        self.changes += 1

    def _set_going(self) -> None:
        self.changes += 1

    def _moved(self, shape: Member, before: object) -> None:
        assert shape._row.tobytes() != before.tobytes()  # type: ignore[attr-defined]
        self.changes += 1


@each_member
def test_in_a_world_it_is_a_live_view_of_its_row(member: Member) -> None:
    twin, home = copy.copy(member), Home()
    table = RowTable(np.zeros(3, BALL if isinstance(twin, Ball) else SHAPE))
    table.rows[2] = twin._row
    twin._enter(home, table, 2, 42)
    assert (row_bits(twin), twin.id, twin.world) == (row_bits(member), 42, home)
    twin.elasticity = 0.125
    twin.position = (8, 9)
    assert table.rows[2]["elasticity"] == 0.125
    assert home.changes == 2
    table.rows[2]["layer"] = 7
    assert twin.layer == 7
    table.rows = np.concatenate([table.rows, table.rows])  # a table that grows
    twin.layer = 9
    assert table.rows[2]["layer"] == 9


@each_member
def test_after_leaving_it_keeps_its_last_values(member: Member) -> None:
    twin, home = copy.copy(member), Home()
    table = RowTable(np.zeros(1, BALL if isinstance(twin, Ball) else SHAPE))
    table.rows[0] = twin._row
    twin._enter(home, table, 0, 7)
    table.rows[0]["elasticity"] = 0.75
    twin._leave()
    table.rows[:] = 0
    assert (twin.id, twin.world, twin.elasticity, twin.position) == (None, None, 0.75, member.position)
    twin.elasticity = 0.5
    assert home.changes == 0


def test_what_only_a_world_knows_stays_there() -> None:
    ball, table = Ball((0, 0), 1), RowTable(np.zeros(1, BALL))
    table.rows[0] = ball._row
    ball._enter(Home(), table, 0, 1)
    table.rows["asleep"], table.rows["still_time"], table.rows["relation"], table.rows["stray"] = 1, 3.0, 5, 1
    assert ball.asleep
    twin = copy.copy(ball)
    ball._leave()
    for lone in (ball, twin):
        assert not lone.asleep
        assert row_bits(lone) == row_bits(Ball((0, 0), 1))


@each_member
def test_an_object_for_a_row_that_is_there_already(member: Member) -> None:
    table, home = RowTable(np.array([member._row])), Home()
    kind = Ball if isinstance(member, Ball) else SHAPE_CLASSES[int(table.rows[0]["kind"])]
    assert type(member) is kind
    view = kind._of_row(home, table, 5, 0)
    assert (row_bits(view), view.id, view.world, view.name, view.user) == (row_bits(member), 5, home, None, None)
    assert getattr(view, "compound", None) is None
    view.elasticity = 0.0
    assert table.rows[0]["elasticity"] == 0.0


def test_every_kind_has_its_class() -> None:
    assert [KIND_NAMES[kind] for kind in SHAPE_CLASSES] == ["point", "segment", "gate", "circle", "arc"]
    assert [kind.__name__.lower() for kind in SHAPE_CLASSES.values()] == list(KIND_NAMES[:5])


@each_member
@pytest.mark.parametrize("copied", [copy.copy, copy.deepcopy, lambda member: pickle.loads(pickle.dumps(member))])
def test_copies_are_lone_and_their_own(member: Member, copied: Any) -> None:
    member.user = ["mine"]
    twin = copied(member)
    assert type(twin) is type(member)
    assert (row_bits(twin), twin.name, twin.user) == (row_bits(member), member.name, member.user)
    twin.position = (50, 60)
    assert row_bits(twin) != row_bits(member)


def test_a_copy_of_what_is_in_a_world_is_lone() -> None:
    ball, home = Ball((0, 0), 1), Home()
    ball._enter(home, RowTable.of_row(ball._row), 0, 1)
    assert copy.deepcopy(ball).world is None
    assert copy.copy(ball).id is None


@pytest.mark.slow
@each_member
def test_a_member_can_be_held_weakly(member: Member) -> None:
    twin = copy.copy(member)
    reference = weakref.ref(twin)
    assert reference() is twin
    del twin
    gc.collect()
    assert reference() is None


def test_all_that_comes_back_is_plain() -> None:
    for member in MEMBERS:
        for name in dir(type(member)):
            if name.startswith("_") or not isinstance(inspect.getattr_static(type(member), name), property):
                continue
            value = getattr(member, name)
            for part in value if isinstance(value, tuple) else (value,):
                assert not isinstance(part, np.generic), (member, name)


def test_names_are_texts() -> None:
    point = Point((0, 0), name="a")
    point.name = None
    assert point.name is None
