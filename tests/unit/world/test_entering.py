"""Many at once: shapes, balls and compounds added and removed by one call, all or none."""

import copy
import gc
import time
from typing import assert_type

import pytest
from hypothesis import given
from hypothesis import strategies as st

import carom
from carom import Ball, Compound, InvalidArgument, Point, Segment, World

Thing = carom.Shape | Ball | Compound


def made(kinds: list[str]) -> list[Thing]:
    """Things of these kinds, each elsewhere."""
    makers = {
        "point": lambda n: Point((n, 1)),
        "segment": lambda n: Segment((n, 2), (n + 1, 3), elasticity=0.5),
        "eye": lambda n: carom.Circle((n, 9), 3, sensor=True, solid=True),
        "ball": lambda n: Ball((n, 9), 0.25, (0, n)),
        "mill": lambda n: Compound([Point((n, 5)), Segment((n, 5), (n, 6))], (n, 5), angular_velocity=n),
    }
    return [makers[kind](float(n)) for n, kind in enumerate(kinds)]


kinds = st.lists(st.sampled_from(["point", "segment", "eye", "ball", "mill"]), max_size=12)


@pytest.mark.slow
@given(kinds)
def test_one_call_does_what_one_call_for_each_does(kinds: list[str]) -> None:
    together, singly = World(), World()
    things, others = made(kinds), made(kinds)
    added = together.add(*things)
    for other in others:
        singly.add(other)
    assert added == (things[0] if len(things) == 1 else tuple(things))
    assert together.digest() == singly.digest()
    assert list(together.shapes) == [thing for thing in things if not isinstance(thing, Ball)]
    assert list(together.balls) == [thing for thing in things if isinstance(thing, Ball)]


@pytest.mark.slow
@given(kinds, st.data())
def test_one_removal_does_what_one_for_each_does(kinds: list[str], data: st.DataObject) -> None:
    together, singly = World(), World()
    things, others = made(kinds), made(kinds)
    together.add(*things)
    singly.add(*others)
    for world in (together, singly):
        world.step(0.125)
    places = data.draw(st.lists(st.integers(0, len(kinds) - 1), unique=True) if kinds else st.just([]))
    together.remove(*[things[place] for place in places])
    for place in places:
        singly.remove(others[place])
    exits = [sorted((hit.ball.position, hit.shape.position) for hit in world.step(0.0)) for world in (together, singly)]
    assert exits[0] == exits[1]
    assert together.digest() == singly.digest()
    kept = [thing for place, thing in enumerate(things) if place not in places]
    assert [*together.shapes, *together.balls] == sorted(kept, key=lambda thing: isinstance(thing, Ball))
    assert all(things[place].world is None for place in places)


def bad_additions() -> list[tuple[str, list[object], str]]:
    """What may not come in, as what it is, the arguments, and what is said of it."""
    inside, part = World().add(Point((0, 0))), Point((1, 1))
    mill, moving = Compound([part], (0, 0)), World().add(Compound([Point((2, 2))], (0, 0)))
    wall, ball = Segment((0, 0), (1, 0)), Ball((5, 5), 1)
    return [
        ("a text", [wall, "ball"], r"shapes\[1\] must be a shape, a compound, a group or a ball, not 'ball'"),
        ("a list", [[wall, ball]], r"shape must be .* \(a list of them is added by add\(\*shapes\)\)"),
        ("of another world", [wall, ball, inside], r"shapes\[2\] must not be in a world already \(copy\.copy\(shape\)"),
        ("a compound of another", [wall, moving], r"shapes\[1\] must not be in a world already"),
        ("its part", [moving.shapes[0], wall], r"shapes\[0\] must not be in a world already"),
        ("a part", [wall, part], r"shapes\[1\] must not be part of a compound .*: add the compound"),
        ("a compound and a part", [mill, part], r"shapes\[1\] must not be part of a compound"),
        ("a part and its compound", [part, mill], r"shapes\[0\] must not be part of a compound"),
        ("a ball twice", [ball, wall, ball], r"shapes\[2\] must not be given twice"),
        ("a compound twice", [mill, mill], r"shapes\[1\] must not be given twice"),
    ]


@pytest.mark.parametrize(("arguments", "words"), [pytest.param(*case[1:], id=case[0]) for case in bad_additions()])
def test_what_may_not_come_in_keeps_all_of_the_call_out(arguments: list[Thing], words: str) -> None:
    world = World()
    world.add(Point((9, 9)))
    before, worlds = world.digest(), [getattr(thing, "world", None) for thing in arguments]
    with pytest.raises(InvalidArgument, match=words):
        world.add(*arguments)
    assert world.digest() == before
    assert [getattr(thing, "world", None) for thing in arguments] == worlds


def test_what_may_not_leave_keeps_all_of_the_call_in() -> None:
    world, part = World(), Point((1, 1))
    wall, ball, _ = world.add(Segment((0, 0), (1, 0)), Ball((5, 5), 1), Compound([part], (0, 0)))
    outside = [Point((0, 0)), World().add(Ball((0, 0), 1)), "ball", None]
    before = world.digest()
    for thing in outside:
        with pytest.raises(InvalidArgument, match=r"shapes\[2\] must be in this world"):
            world.remove(wall, ball, thing)  # type: ignore[arg-type]
    with pytest.raises(InvalidArgument, match=r"shapes\[1\] must not be part of a compound: remove the compound"):
        world.remove(wall, part)
    with pytest.raises(InvalidArgument, match=r"must be in this world \(a list is taken out by remove\(\*shapes\)\)"):
        world.remove([wall, ball])  # type: ignore[arg-type]
    assert world.digest() == before


def test_a_copy_is_what_the_error_says_it_is() -> None:
    world = World()
    wall = world.add(Segment((0, 0), (1, 0), elasticity=0.25))
    second = world.add(copy.copy(wall))
    assert second is not wall
    assert (second.elasticity, second.world, len(world.shapes)) == (0.25, world, 2)


def test_nothing_is_added_and_removed() -> None:
    world = World()
    world.add(Point((0, 0)))
    before = world.digest()
    assert world.add() == ()
    world.remove()
    assert world.digest() == before


def test_what_is_given_twice_is_taken_out_once() -> None:
    world = World()
    wall, ball = world.add(Segment((0, 0), (1, 0)), Ball((5, 5), 1))
    world.remove(ball, ball, wall, ball)
    assert (len(world.shapes), len(world.balls), ball.world) == (0, 0, None)


def test_types_come_back_as_they_went_in() -> None:
    world = World()
    balls = [Ball((n, 0), 0.1) for n in range(5)]
    assert_type(world.add(Point((0, 9))), Point)
    assert_type(world.add(Ball((0, 8), 0.1), Segment((0, 7), (1, 7))), tuple[Ball, Segment])
    assert_type(world.add(*balls), tuple[Ball, ...])
    mixed: list[Segment | Ball] = [Segment((0, 6), (1, 6)), Ball((0, 5), 0.1)]
    assert_type(world.add(*mixed), tuple[Segment | Ball, ...])


@pytest.mark.slow
@pytest.mark.parametrize("kind", ["segment", "ball"])
@pytest.mark.parametrize("way", ["together", "singly", "removed together"])
def test_the_cost_of_each_does_not_grow_with_their_number(kind: str, way: str) -> None:
    def seconds(count: int) -> float:
        world, things = World(), made([kind] * count)
        if way == "removed together":
            world.add(*things)
        # What other tests have left would be looked through in the middle of it.
        gc.collect()
        gc.disable()
        began = time.process_time()
        if way == "singly":
            for thing in things:
                world.add(thing)
        elif way == "together":
            world.add(*things)
        else:
            world.remove(*things)
        taken = time.process_time() - began
        gc.enable()
        return taken

    few, many = min(seconds(1_000) for _ in range(5)), min(seconds(8_000) for _ in range(3))
    assert many < 3 * 8 * few
