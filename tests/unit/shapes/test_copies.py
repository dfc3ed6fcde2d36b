"""What a user's own subclass adds: copies and pickles keep it."""

import copy
import inspect
import pickle
from typing import Any

from carom import Circle
from carom.shapes.copies import add_attributes, added_attributes


class Bumper(Circle):
    """A user's own kind of circle."""

    def __init__(self, *args: Any, points: int = 100, **options: Any) -> None:
        super().__init__(*args, **options)
        self.points = points


def test_a_users_own_class_keeps_what_it_adds() -> None:
    bumper = Bumper((0, 0), 1, points=500, kick=3)
    assert (bumper.kick, bumper.kind) == (3.0, "circle")
    for twin in (copy.copy(bumper), pickle.loads(pickle.dumps(bumper))):
        assert (type(twin), twin.points, twin.kick) == (Bumper, 500, 3.0)
    assert {"points", "kick", "elasticity"} <= set(inspect.signature(Bumper).parameters)


class Slotted(Circle):
    """One with slots of its own, and an attribute that it guards."""

    __slots__ = ("points", "unset")

    def __init__(self) -> None:
        super().__init__((0, 0), 1)
        object.__setattr__(self, "points", 7)

    def __setattr__(self, name: str, value: object) -> None:
        if name == "points":
            raise AttributeError("points are counted, not set")
        super().__setattr__(name, value)


class Own:
    """Something of the library's, with a slot of its own."""

    __slots__ = ("row",)


class Added(Own):
    """What a user makes of it."""

    __slots__ = ("__dict__", "points", "unset")


def test_what_is_added_is_all_but_what_is_the_librarys_slots_included() -> None:
    plain, thing = Own(), Added()
    plain.row = thing.row = 5
    assert added_attributes(plain, {"row"}) == {}
    thing.points, thing.color = 7, "red"
    assert added_attributes(thing, {"row"}) == {"points": 7, "color": "red"}
    twin = Added()
    add_attributes(twin, added_attributes(thing, {"row"}))
    assert (twin.points, twin.color, hasattr(twin, "row")) == (7, "red", False)


def test_slots_are_filled_past_a_guard_and_empty_ones_stay_empty() -> None:
    for twin in (copy.copy(Slotted()), copy.deepcopy(Slotted())):
        assert twin.points == 7  # type: ignore[attr-defined]
        assert not hasattr(twin, "unset")
