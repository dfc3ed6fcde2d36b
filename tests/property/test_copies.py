"""Copies keep together: whatever refers to a world's members, in any order, refers to those of the copied world."""

import copy
import pickle
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import carom
from carom.world.views import Balls, Shapes

COPIED: dict[str, Callable[[Any], Any]] = {"deepcopy": copy.deepcopy} | {
    f"pickle {n}": lambda thing, n=n: pickle.loads(pickle.dumps(thing, n)) for n in range(2, 6)
}

each_way = pytest.mark.parametrize("way", COPIED)


class Holder:
    """A user's class: an environment, a game."""

    def __init__(self, **held: Any) -> None:
        self.__dict__.update(held)


class Enemy(carom.Ball):
    """A user's ball, with attributes of its own."""

    def __init__(self, *arguments: Any, **options: Any) -> None:
        super().__init__(*arguments, **options)
        self.lives = 3
        self.friends: list[Any] = []


class Marked(carom.Circle):
    """A user's shape, with a slot of its own."""

    __slots__ = ("mark",)


class Mill(carom.Compound):
    """A user's compound, with attributes of its own."""


class Brick(carom.Group):
    """A user's group, with attributes of its own."""


class Arena(carom.World):
    """A user's world, which knows its boss."""

    __slots__ = ("slotted",)


def arena() -> Arena:
    """A world with one of everything in it, which has been stepped, and what has left it."""
    world = Arena(gravity=(0, -3), bounds=(-20, -20, 20, 20), substeps=2)
    world.add(carom.Segment((-5, 0), (5, 0), elasticity=0.8))
    world.add(carom.Gate((-2, 3), (2, 3), direction=(0, -1)))
    marked = world.add(Marked((2, 1), 0.5, solid=True, motion="kinematic", velocity=(0.1, 0)))
    marked.mark = "here"
    world.add(carom.Circle((0, 1), 2, sensor=True, solid=True))
    vane = carom.Segment((-4, 2), (-3, 2))
    world.add(Mill([vane, carom.Point((-3, 2))], (-4, 2), angular_velocity=1.0, elasticity=0.5, name="mill"))
    world.add(Brick([carom.Segment((8, 0), (9, 0)), carom.Point((9, 0))], once=True, name="brick"))
    world.boss = world.add(Enemy((0, 0.6), 0.5, velocity=(1, -1), name="boss"))
    world.slotted = [world.boss]
    world.add(carom.Ball((0.5, 1.6), 0.5, velocity=(-1, 0)))
    world.add_balls([(-1.5, 0.7), (-3.5, 2.4), (15, 15)], (0, -1), 0.25)
    world.run(0.2, 0.05)
    return world


def things_of(world: Arena, draw: Any) -> list[Any]:
    """What a user may hold of a world."""
    gone = world.add(carom.Ball((0, 0.2), 0.3, name="gone"))
    hits = world.step(0.05)
    if draw(st.booleans()):
        world.remove(gone)
    (mill,) = [shape for shape in world.shapes if isinstance(shape, carom.Compound)]
    brick = world.shapes["brick"]
    pool = [world, world, *world.balls[:4], gone, *world.shapes, mill.shapes[0], mill.center_point, brick.shapes[1]]
    pool += [hits, hits[:1]]
    pool += [world.contacts(), *world.contacts()[:1], world.ray_cast([(0, 9), (50, 9)], (0, -9))]
    pool += [world.nearest((0, 0)), world.nearest([(0, 0)]), world.balls, world.shapes, world.statistics, *hits[:1]]
    pool += [world.aim(world.boss, (1, 0)), world.aim([world.boss], (1, 0))]
    return pool


def hang(draw: Any, pool: list[Any]) -> None:
    """Hang things of the pool on others."""
    owners = [thing for thing in pool if isinstance(thing, (carom.Shape, carom.Ball, carom.Compound, carom.Group))]
    for owner in draw(st.lists(st.sampled_from(owners), max_size=4)):
        owner.user = [draw(st.sampled_from(pool)), "shared"]
    for enemy in owners:
        if isinstance(enemy, Enemy) and draw(st.booleans()):
            enemy.friends = [draw(st.sampled_from(pool))]


def packed(draw: Any, chosen: list[Any]) -> Any:
    """Things in containers of several kinds."""
    items: list[Any] = []
    for thing in chosen:
        kind = draw(st.sampled_from(("bare", "list", "dict", "class", "again")))
        box = {
            "bare": thing,
            "list": [thing],
            "dict": {"key": thing},
            "class": Holder(it=thing),
            "again": (thing, items),
        }
        items.append(box[kind] if kind != "again" else thing)
        if kind == "again":
            items.append(thing)
    return draw(st.sampled_from((items, Holder(items=items), dict(enumerate(items)))))


def references(thing: Any) -> list[Any]:
    """What a copy of a thing takes along."""
    if isinstance(thing, carom.World):
        members = [thing._objects[key] for key in sorted(thing._objects)]
        added = [thing._added[key] for key in sorted(thing._added)]
        known = [thing._departed._known[key] for key in sorted(thing._departed._known)]
        return [*members, *added, *known, thing.boss, thing.slotted]
    if isinstance(thing, carom.Compound):
        return [thing.user, thing.center_point, *thing.shapes, vars(thing)]
    if isinstance(thing, carom.Group):
        return [thing.user, *thing.shapes, vars(thing)]
    if isinstance(thing, (carom.Shape, carom.Ball)):
        return [thing.user, getattr(thing, "friends", None)]
    if isinstance(thing, (Balls, Shapes, type(arena().statistics))):
        return [thing._world]
    if isinstance(thing, dict):
        return [*thing.keys(), *thing.values()]
    if isinstance(thing, (list, tuple)):
        return list(thing)
    if isinstance(thing, Holder):
        return list(vars(thing).values())
    if type(thing).__name__ in ("Hit", "Contact", "Neighbor", "CastHit", "Aim"):
        return [getattr(thing, name) for name in ("ball", "shape") if hasattr(thing, name)]
    return []


def reached(thing: Any) -> dict[int, Any]:
    """Everything that a copy of a thing takes along, by its id."""
    found: dict[int, Any] = {}
    waiting = [thing]
    while waiting:
        one = waiting.pop()
        if id(one) not in found:
            found[id(one)] = one
            waiting += references(one)
    return found


def check(thing: Any, twin: Any, pickled: bool) -> None:
    """Everything that a copy took along stands to everything else as in the original."""
    taken = reached(thing)
    twins: dict[int, Any] = {}
    waiting = [(thing, twin)]
    while waiting:
        one, other = waiting.pop()
        if one is None or isinstance(one, (str, int, float)):
            assert one == other
            continue
        assert type(one) is type(other)
        if id(one) in twins:
            assert twins[id(one)] is other
            continue
        twins[id(one)] = other
        assert other is not one or isinstance(one, tuple)
        waiting += zip(references(one), references(other), strict=True)
        if isinstance(one, (carom.Shape, carom.Ball, carom.Compound, carom.Group)):
            home = one.world if id(one.world) in taken else None
            assert (other.world is None) == (home is None)
            assert (one.name, getattr(one, "lives", 0), getattr(one, "mark", "")) == (
                (other.name, getattr(other, "lives", 0), getattr(other, "mark", ""))
            )
            if home is not None:
                waiting.append((home, other.world))
                assert other.id == one.id
            if isinstance(one, carom.Shape) and id(one.compound) in taken:
                waiting.append((one.compound, other.compound))
        elif isinstance(one, np.ndarray):
            check_rows(one, other, taken, pickled, waiting)
    for one in taken.values():
        if isinstance(one, carom.World):
            check_worlds(one, twins[id(one)])


def check_rows(one: Any, other: Any, taken: dict[int, Any], pickled: bool, waiting: list[Any]) -> None:
    """Hits or answers lead to the members of the copied world; without it, to none, or to those of the same world."""
    assert np.asarray(one).tobytes() == np.asarray(other).tobytes()
    if id(one._world) in taken:
        waiting += zip(one, other, strict=True)
    elif pickled:
        for _ in np.asarray(one):
            with pytest.raises(carom.LostObject, match="do not know their world"):
                list(other)
    else:
        assert [references(item) for item in other] == [references(item) for item in one]


def check_worlds(world: Arena, twin: Arena) -> None:
    """Two worlds are in the same state, hold their own objects, and step on to the same bits."""
    assert twin is not world
    assert twin.digest() == world.digest()
    assert all(twin.object(ball.id) is ball and ball.world is twin for ball in twin.balls)
    twin.boss.velocity = world.boss.velocity = (2, 1)
    assert twin.balls.velocity.tolist() == world.balls.velocity.tolist()
    assert np.asarray(twin.run(0.2, 0.05)).tobytes() == np.asarray(world.run(0.2, 0.05)).tobytes()
    assert twin.digest() == world.digest()


@pytest.mark.slow
@each_way
@settings(max_examples=20)
@given(data=st.data())
def test_whatever_refers_to_members_refers_to_those_of_the_copied_world(way: str, data: st.DataObject) -> None:
    pool = things_of(arena(), data.draw)
    if data.draw(st.booleans()):
        pool += things_of(arena(), data.draw)
    hang(data.draw, pool)
    chosen = data.draw(st.lists(st.sampled_from(pool), min_size=1, max_size=6))
    thing = packed(data.draw, chosen)
    check(thing, COPIED[way](thing), way != "deepcopy")


@each_way
@pytest.mark.parametrize("order", [(0, 1), (1, 0)], ids=["world first", "ball first"])
def test_a_world_and_its_ball(way: str, order: tuple[int, int]) -> None:
    world = arena()
    pair = (world, world.boss)
    twins = COPIED[way]([pair[place] for place in order])
    twin, ball = twins[order.index(0)], twins[order.index(1)]
    assert ball.world is twin
    assert twin.object(ball.id) is ball
    ball.position = (7, 7)
    assert (7, 7) in map(tuple, twin.balls.position.tolist())
    assert world.boss.position != (7, 7)


@each_way
def test_a_ball_that_only_its_own_data_ties_to_the_world(way: str) -> None:
    world = arena()
    world.boss.user = {"home": world}
    ball = COPIED[way](world.boss)
    assert ball.world is ball.user["home"]
    assert ball.world.boss is ball
    assert (ball.lives, ball.name) == (3, "boss")


@each_way
def test_what_is_copied_alone_stays_alone(way: str) -> None:
    world = arena()
    for member in (*world.balls, *world.shapes):
        twin = COPIED[way](member)
        assert twin.world is twin.id is None
        assert type(twin) is type(member)
    (mill,) = [shape for shape in world.shapes if isinstance(shape, Mill)]
    assert COPIED[way](mill.shapes[0]).compound is None


def test_a_shallow_copy_of_a_world_has_objects_of_its_own_and_shares_what_users_hung_on_them() -> None:
    world = arena()
    world.boss.user = ["shared"]
    twin = copy.copy(world)
    assert (twin.digest(), world.boss.world) == (world.digest(), world)
    boss = twin.object(world.boss.id or 0)
    assert isinstance(boss, Enemy)
    assert boss.world is twin
    assert boss.user is world.boss.user
    assert [type(shape) for shape in twin.shapes] == [type(shape) for shape in world.shapes]
    assert all(shape.world is twin for shape in twin.shapes)
    assert all(shape.world is world for shape in world.shapes)


def test_the_hits_of_a_copied_world_know_what_has_left_it() -> None:
    world = carom.World(detection="discrete")
    world.add(carom.Segment((-5, 0), (5, 0)))
    world.add_balls([(0, 0.9)], (0, -1), 1.0)
    hits = world.step(0.1)
    world.remove(hits[0].ball)
    hits_twin, world_twin = pickle.loads(pickle.dumps((hits, world)))
    assert hits_twin[0].ball.position == hits[0].ball.position
    assert hits_twin[0].ball is not hits[0].ball
    assert hits_twin[0].shape is world_twin.shapes[0]


def test_balls_that_nobody_asked_for_are_not_made_by_a_copy() -> None:
    world = carom.World(detection="discrete")
    world.add_balls(np.zeros((1000, 2)), radius=1.0)
    twin = copy.deepcopy(world)
    assert (len(twin.balls), len(world._objects), len(twin._objects)) == (1000, 0, 0)
