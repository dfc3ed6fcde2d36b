"""Names and distances, which shapes, balls and compounds have alike."""

import pytest

import carom

THINGS = [
    carom.Segment((3, -1), (3, 1)),
    carom.Ball((5, 0), radius=2),
    carom.Compound([carom.Point((3, 0)), carom.Point((9, 9))], pivot=(7, 7)),
    carom.Group([carom.Point((3, 0)), carom.Point((9, 9))]),
]


@pytest.mark.parametrize("thing", THINGS, ids=lambda thing: thing.kind)
def test_a_name_is_text_or_none(thing: carom.Segment | carom.Ball | carom.Compound) -> None:
    assert thing.name is None
    thing.name = "it"
    with pytest.raises(carom.InvalidArgument, match="name must be a string or None, not 3"):
        thing.name = 3  # type: ignore[assignment]
    assert thing.name == "it"
    thing.name = None
    assert thing.name is None


@pytest.mark.parametrize("thing", THINGS, ids=lambda thing: thing.kind)
def test_the_distance_is_that_to_the_nearest_point(thing: carom.Segment | carom.Ball | carom.Compound) -> None:
    assert thing.closest_point((0, 0)) == (3, 0)
    assert thing.distance((0, 0)) == 3
    with pytest.raises(carom.InvalidArgument, match="p must be a pair"):
        thing.distance(1)  # type: ignore[arg-type]


def test_a_name_is_not_changed_while_the_world_is_in_use() -> None:
    world = carom.World()
    wall = world.add(carom.Segment((0, 0), (1, 0)))
    del world._turn.free
    with pytest.raises(carom.WorldBusy):
        wall.name = "wall"
