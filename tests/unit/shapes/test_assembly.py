"""Assemblies: what compounds and groups do alike."""

import copy
import pickle
from collections.abc import Callable
from typing import Any

import pytest

import carom
from tests.worlds import row_bits

MAKERS: dict[str, Callable[..., Any]] = {
    "compound": lambda shapes, **options: carom.Compound(shapes, (0, 0), **options),
    "group": carom.Group,
}
BOTH = pytest.mark.parametrize(("kind", "make"), MAKERS.items(), ids=MAKERS)


def parts() -> list[carom.Shape]:
    """Parts, each with a surface of its own."""
    return [carom.Segment((0, 0), (4, 0), elasticity=0.5, layer=2), carom.Circle((6, 0), 1, kick=2.0)]


@BOTH
def test_a_shape_is_part_of_one_thing(kind: str, make: Any) -> None:
    whole, free = make(parts()), carom.Point((9, 9))
    assert all(part in whole and getattr(part, kind) is whole for part in whole.shapes)
    assert free not in whole
    for other in MAKERS.values():
        with pytest.raises(carom.InvalidArgument, match=rf"shapes\[1\] must not be part of a {kind} already"):
            other([free, whole.shapes[0]])
    with pytest.raises(carom.InvalidArgument, match=f"shape must not be in another world than the {kind}"):
        whole.add(carom.World().add(carom.Point((9, 9))))
    assert (free.compound, free.group) == (None, None)


@BOTH
@pytest.mark.parametrize(
    ("name", "value"),
    [("elasticity", 0.25), ("kick", 3.0), ("sensor", True), ("once", True), ("layer", 4), ("collides_with", 6)],
)
def test_what_is_set_holds_for_all_parts_and_those_added_later(kind: str, make: Any, name: str, value: Any) -> None:
    own = [getattr(part, name) for part in parts()]
    whole = make(parts())
    assert getattr(whole, name) is None
    assert [getattr(part, name) for part in whole.shapes] == own
    setattr(whole, name, value)
    late = whole.add(carom.Point((1, 1)))
    assert [getattr(part, name) for part in whole.shapes] == [value] * 3
    setattr(whole, name, None)
    assert getattr(whole, name) is None
    assert getattr(late, name) == value
    assert [getattr(part, name) for part in make(parts(), **{name: value}).shapes] == [value] * 2


@BOTH
def test_it_comes_into_a_world_and_leaves_it_as_one(kind: str, make: Any) -> None:
    world, whole = carom.World(), make(parts(), name="whole")
    assert world.add(whole) is whole
    assert (whole.world, whole.id, len(world.shapes), world.shapes[0]) == (world, whole._parts[0].id, 1, whole)
    late = whole.add(carom.Point((9, 9)))
    lone = world.add(carom.Point((8, 8)))
    assert late.world is world
    assert whole.add(lone) is lone
    assert (list(world.shapes), lone in world.shapes) == ([whole], False)
    for part in (late, lone, whole.shapes[0]):
        with pytest.raises(carom.InvalidArgument, match=f"must not be part of a {kind}: remove the {kind}"):
            world.remove(part)
    world.remove(whole)
    world.remove(whole)
    assert (len(world.shapes), world._arrays.shapes.count, whole.world, late.world) == (0, 0, None, None)
    with pytest.raises(carom.InvalidArgument, match=f"part of a {kind} that is not in the world: add the {kind}"):
        world.add(late)
    world.add(whole)
    assert len(whole.shapes) == 4


@BOTH
@pytest.mark.parametrize("copied", [copy.copy, copy.deepcopy, lambda whole: pickle.loads(pickle.dumps(whole))])
def test_copies_have_parts_of_their_own(kind: str, make: Any, copied: Any) -> None:
    whole = make(parts(), name="whole", user=[1], elasticity=0.75)
    carom.World().add(whole)
    twin = copied(whole)
    assert row_bits(twin) == row_bits(copied(twin))
    assert (twin.name, twin.user, twin.elasticity, twin.world) == ("whole", [1], 0.75, None)
    assert all(getattr(part, kind) is twin for part in twin.shapes)
    assert all(getattr(part, kind) is whole for part in whole.shapes)


@BOTH
def test_its_box_distance_and_contacts_are_those_of_its_parts(kind: str, make: Any) -> None:
    whole = make([carom.Segment((0, 0), (4, 0)), carom.Circle((9, 1), 1), carom.Point((4, 0))])
    assert tuple(whole.aabb) == (0.0, 0.0, 10.0, 2.0)
    assert (whole.closest_point((4.5, 0)), whole.distance((4, -3))) == ((4.0, 0.0), 3.0)
    contact = whole.detect(carom.Ball((4, 0.5), 1))
    assert contact is not None
    assert contact.shape is whole.shapes[2]
    assert whole.detect(carom.Ball((2, 9), 1)) is None
