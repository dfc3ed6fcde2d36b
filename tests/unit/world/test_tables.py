"""Tables that grow, and rows that are found by their ids wherever they moved."""

import numpy as np
import pytest

import carom
from carom.rows.ball import BALL
from carom.rows.hit import HIT
from carom.world.tables import Arrays, WorldTable, grown, joined


def table_of(ids: list[int]) -> WorldTable:
    """A table of balls with ids."""
    table = WorldTable(BALL, len(ids))
    table.rows["id"] = ids
    table.count = len(ids)
    return table


def test_a_grown_table_begins_with_what_was_there() -> None:
    rows = np.arange(6).reshape(3, 2)
    larger = grown(rows, 5, 2)
    assert larger.tolist() == [[0, 1], [2, 3], [0, 0], [0, 0], [0, 0]]


@pytest.mark.parametrize(("shape", "dtype"), [((3,), BALL), ((3, 2), "u4"), ((0,), BALL)])
def test_a_grown_table_begins_where_a_line_of_memory_does(shape: tuple[int, ...], dtype: str) -> None:
    rows = np.ones(shape, dtype)
    larger = grown(rows, 7, len(rows))
    assert larger.shape == (7, *shape[1:])
    assert larger.dtype == rows.dtype
    assert larger.ctypes.data % 64 == 0
    assert (larger[: len(rows)] == rows).all()
    assert not any(larger[len(rows) :].tobytes())


def test_rows_are_found_by_their_ids() -> None:
    table = table_of([2, 5, 9])
    assert [table.find(member) for member in (2, 5, 9)] == [0, 1, 2]
    for missing in (1, 3, 10, None):
        with pytest.raises(carom.InvalidArgument, match=f"not {missing}"):
            table.find(missing)


def test_rows_that_stay_keep_their_order() -> None:
    table = table_of([1, 2, 3, 4])
    table.drop(np.array([True, False, True, False]))
    assert table.used["id"].tolist() == [2, 4]
    table.reserve(3)
    assert len(table.rows) >= 3
    assert table.used["id"].tolist() == [2, 4]


def test_room_is_doubled_unless_told_otherwise() -> None:
    table = table_of([1, 2, 3])
    table.reserve(4)
    assert len(table.rows) == 6
    table.reserve(7, doubling=False)
    assert len(table.rows) == 7


def test_many_balls_take_no_more_rows_than_they_need() -> None:
    world = carom.World()
    world.add_balls(np.zeros((1000, 2)), radius=1.0)
    assert len(world._arrays.balls.rows) == 1000


def test_a_map_has_room_for_a_few_shapes_that_go() -> None:
    world = carom.World()
    shapes = [carom.Point((x, 0)) for x in range(600)]
    world.add(*shapes)
    world.step(0.01)
    rows = world._arrays.shapes.rows
    world.remove(*shapes[5:40])
    world.step(0.01)
    assert world._arrays.shapes.rows is rows


def test_shapes_are_met_in_the_order_of_motion_then_kind_then_adding() -> None:
    world = carom.World()
    given = [
        carom.Arc((0, 0), 1, 0, 1),
        carom.Segment((0, 0), (1, 0), motion="kinematic"),
        carom.Circle((0, 0), 1),
        carom.Point((0, 0), motion="kinematic"),
        carom.Gate((0, 0), (1, 0)),
        carom.Segment((0, 0), (1, 0)),
        carom.Point((0, 0)),
        carom.Point((1, 0)),
    ]
    for shape in given:
        world.add(shape)
    world.step(0.1)
    order = [given[row] for row in world._arrays.order[: len(given)]]
    kinds = ["point", "point", "segment", "gate", "circle", "arc", "point", "segment"]
    assert [shape.kind for shape in order] == kinds
    assert order[0] is given[6]
    assert world._arrays.states[0]["fixed"] == 6


def test_hits_that_are_given_back_come_first() -> None:
    arrays = Arrays()
    arrays.hits["time"][:2] = [3.0, 4.0]
    arrays.states[0]["hits"] = 2
    early = np.zeros(2, arrays.hits.dtype)
    early["time"] = [1.0, 2.0]
    arrays.give_back(early)
    assert arrays.hits["time"][: arrays.states[0]["hits"]].tolist() == [1, 2, 3, 4]


def test_pairs_are_found_by_ids_wherever_the_rows_moved() -> None:
    world = carom.World()
    balls = world.add(*(carom.Ball((float(i), -float(i)), 0.5) for i in range(6)))
    assert [ball.position for ball in balls] == [(i, -i) for i in range(6)]
    world.remove(balls[0], balls[3])
    world.add(*(carom.Ball((9.0, 9.0), 0.5) for _ in range(20)))
    left = [balls[i] for i in (1, 2, 4, 5)]
    assert [ball.position for ball in left] == [(i, -i) for i in (1, 2, 4, 5)]
    left[2].position = (4.0, 7.0)
    assert world.balls.position[:4].tolist() == [[1, -1], [2, -2], [4, 7], [5, -5]]
    assert balls[3].position == (3.0, -3.0)


def test_tables_joined_are_a_new_one_of_their_rows_in_order() -> None:
    parts = [np.zeros(count, HIT) for count in (2, 0, 3)]
    for number, part in enumerate(parts):
        part["time"], part["ball"], part["point"] = np.arange(len(part)) + 10.0 * number, number, (1.0, number)
    whole = joined([*parts, parts[2][::-2]], HIT)
    assert whole.dtype == HIT
    assert whole.tobytes() == b"".join(part.tobytes() for part in (*parts, parts[2][::-2]))
    whole["time"] = -1.0
    assert parts[0]["time"].tolist() == [0.0, 1.0]
    assert joined([], HIT).shape == (0,)
