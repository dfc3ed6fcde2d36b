"""Names lead to the places where arrays have what bears them."""

import numpy as np

from carom.record.members import parts
from carom.rl.names import Names, meant
from carom.shapes.label import name_of
from tests.rl_tasks import yard


def test_an_expression_means_names_that_it_matches_as_a_whole() -> None:
    assert meant("bumper.*", "bumper 1")
    assert not meant("bumper", "bumper 1")
    assert meant("", "")
    assert not meant(None, "")


def test_shapes_balls_and_parts_are_found() -> None:
    names = Names(yard().build())
    assert [names.shapes[index].name for index in names.shapes_like("flipper|paddle")] == ["flipper", "paddle"]
    assert names.bearers("wall") == [0, 1, 2]
    assert names.bearers("blade") == [], "a part is not moved by itself"
    assert names.balls_like("ball .*") == [0, 1]
    assert names.balls_like(None) == []
    assert [name for name, one in zip(names.columns, names.columns_like("flipper|blade"), strict=False) if one] == [
        "flipper",
        "blade",
    ]
    assert len(names.columns_like(".*")) == len(names.columns) + 1
    assert not names.columns_like(".*")[-1], "what is no shape has no name"


def test_ids_lead_to_columns_and_balls() -> None:
    world = yard().build()
    names = Names(world)
    single = parts(world.shapes)
    ids = np.array([part.id for part in single])
    assert names.columns_of(ids).tolist() == list(range(len(names.columns)))
    assert [names.columns[column] for column in names.columns_of(ids)] == [name_of(part) for part in single]
    assert names.balls_of(np.array([ball.id for ball in world.balls])[::-1]).tolist() == [1, 0]


def test_a_ball_that_was_hit_has_the_last_column() -> None:
    world = yard().build()
    names = Names(world)
    ids = np.array([ball.id for ball in world.balls])
    assert names.columns_of(ids).tolist() == [len(names.columns)] * len(ids)
