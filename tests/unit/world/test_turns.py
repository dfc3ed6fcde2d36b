"""A world does one thing at a time: whatever else is asked of it meanwhile is refused; different worlds are free."""

import inspect
import subprocess
import sys
import threading
from collections.abc import Callable
from typing import Any

import numpy as np
import pytest

import carom
from carom.world.settings import SETTINGS
from tests.fresh import ROOT
from tests.worlds import crowded, quiet

BOX = carom.Aabb(-1, -1, 1, 1)

#: Calls of every public method of a world that uses it; what is not here only reads a value or hands out a view.
CALLS: dict[str, Callable[[carom.World], Any]] = {
    "add": lambda world: world.add(carom.Point((0, 0))),
    "add_balls": lambda world: world.add_balls([(0, 0)], radius=1.0),
    "aim": lambda world: world.aim(world.balls[0], (1, 0)),
    "circle_cast": lambda world: world.circle_cast((0, 0), 1.0, (1, 1)),
    "contacts": lambda world: world.contacts(),
    "digest": lambda world: world.digest(),
    "nearest": lambda world: world.nearest((0, 0)),
    "overlapping": lambda world: world.overlapping(BOX),
    "ray_cast": lambda world: world.ray_cast((0, 0), (1, 1)),
    "remove": lambda world: world.remove(world.balls[0]),
    "restore": lambda world: world.restore(SNAPSHOT),
    "run": lambda world: world.run(0.1),
    "snapshot": lambda world: world.snapshot(),
    "step": lambda world: world.step(0.1),
}
OLD = {"overlaps"}
READ = {"balls", "object", "shapes", "statistics", "strays", "time"}
LOOKS = {"aim", "circle_cast", "contacts", "digest", "nearest", "overlapping", "ray_cast", "snapshot"}
SNAPSHOT = quiet().snapshot()

#: What changes a shape, ball or compound and is no setter.
METHODS: dict[str, Callable[[Any], Any]] = {
    "add": lambda member: member.add(carom.Point((0, 0))),
    "move": lambda member: member.move(0.1),
    "move_to": lambda member: member.move_to((1, 1), 0.1),
    "reset": lambda member: member.reset(),
    "respond": lambda member: member.respond(carom.Contact(member, carom.Ball((0, 0), 1), (0, 0), (1, 0), 0.1, 0.0)),
    "rotate": lambda member: member.rotate((0, 0), 0.1),
    "set_angles": lambda member: member.set_angles(1, 2),
    "set_ends": lambda member: member.set_ends((0, 0), (1, 1)),
}
HARMLESS = {
    *("aabb", "closest_point", "common_tangent", "common_tangents", "complement", "contains", "detect", "distance"),
    *("in_sector", "parameter", "surface_velocity", "tangent_points"),
}


def one_of_each() -> list[Any]:
    """A shape of every kind, a compound and a ball."""
    return [
        carom.Point((1, 1), motion="kinematic"),
        carom.Segment((0, 0), (1, 0), motion="kinematic"),
        carom.Gate((0, 0), (1, 0), motion="kinematic"),
        carom.Circle((0, 0), 1, motion="kinematic"),
        carom.Arc((0, 0), 1, 0, 1, motion="kinematic"),
        carom.Compound([carom.Point((2, 2))], (0, 0)),
        carom.Group([carom.Point((3, 2)), carom.Circle((4, 4), 1)]),
        carom.Ball((5, 5), 1),
    ]


def refused(world: carom.World, call: Callable[[], Any]) -> None:
    """A call is refused while the world is in use; its row says nothing of it."""
    before = world.digest()
    del world._turn.free
    try:
        with pytest.raises(carom.WorldBusy, match="the world is in use"):
            call()
    finally:
        world._turn.free = None
    assert world.digest() == before


@pytest.mark.parametrize("name", CALLS)
def test_a_world_in_use_refuses_to_be_stepped_changed_or_asked(name: str) -> None:
    world = crowded(2)
    refused(world, lambda: CALLS[name](world))
    CALLS[name](world)


def test_these_are_all_methods_of_a_world() -> None:
    names = {name for name in dir(carom.World) if not name.startswith("_")}
    assert names == {*CALLS, *READ, *OLD, *SETTINGS}


@pytest.mark.parametrize("name", SETTINGS)
def test_a_world_in_use_refuses_every_setting(name: str) -> None:
    world = crowded(2)
    refused(world, lambda: setattr(world, name, getattr(world, name)))


@pytest.mark.parametrize("member", one_of_each(), ids=lambda member: member.kind)
def test_a_world_in_use_refuses_every_change_of_its_members(member: Any) -> None:
    world = carom.World()
    world.add(member)
    for name in dir(type(member)):
        attribute = inspect.getattr_static(type(member), name)
        if name.startswith("_") or name == "user":
            continue
        if isinstance(attribute, property):
            if attribute.fset is not None:
                refused(world, lambda name=name: setattr(member, name, getattr(member, name)))  # type: ignore[misc]
        elif name in METHODS:
            refused(world, lambda name=name: METHODS[name](member))  # type: ignore[misc]
        else:
            assert name in HARMLESS, f"{name}: does it change the world?"
    world.remove(member)
    member.name = "free"


@pytest.mark.parametrize("column", ["position", "velocity", "radius", "mass"])
def test_a_world_in_use_hands_out_no_columns(column: str) -> None:
    world = quiet()
    refused(world, lambda: getattr(world.balls, column))
    refused(world, world.statistics.reset)


def test_values_can_be_read_from_a_world_in_use() -> None:
    world = quiet()
    ball, hits = world.balls[0], world.run(1.0)
    del world._turn.free
    assert (ball.position[0], len(world.balls), len(world.shapes), world.gravity) == (-2.0, 2, 2, (0, 0))
    assert hits[0].ball in list(world.balls)
    world._turn.free = None


@pytest.mark.parametrize("name", CALLS)
def test_progress_does_what_it_likes_but_step_and_other_threads_nothing(name: str) -> None:
    world = quiet()
    seen: list[float] = []

    def progress(done: float, total: float) -> None:
        seen.append(done)
        with pytest.raises(carom.WorldBusy):
            in_a_thread(lambda: CALLS[name](world))
        if name in ("step", "run"):
            with pytest.raises(carom.WorldBusy):
                CALLS[name](world)
        elif len(seen) == 1:
            CALLS[name](world)
        assert world.balls.position.shape[1] == 2

    world.run(0.5, progress=progress)
    assert len(seen) > 1
    world.step(0.1)


def test_progress_that_only_looks_changes_no_bit() -> None:
    world, twin = quiet(), quiet()
    hits = world.run(0.5, progress=lambda done, total: [CALLS[name](world) for name in sorted(LOOKS)])
    assert np.asarray(hits).tobytes() == np.asarray(twin.run(0.5)).tobytes()
    assert world.digest() == twin.digest()


def in_a_thread(call: Callable[[], Any]) -> Any:
    """What a call returns in another thread; what it raises is raised here."""
    answer: list[Any] = []

    def work() -> None:
        try:
            answer.append(call())
        except Exception as error:  # noqa: BLE001  # handed on
            answer.append(error)

    thread = threading.Thread(target=work)
    thread.start()
    thread.join()
    if isinstance(answer[0], Exception):
        raise answer[0]
    return answer[0]


def interrupt(done: float, total: float) -> None:
    """What Ctrl-C does in the middle of a run."""
    raise KeyboardInterrupt


def spoil(column: np.ndarray[Any, Any], value: float) -> None:
    """Write what a step refuses."""
    column[0] = value


ENDS: dict[str, Callable[[carom.World], Any]] = {
    "progress": lambda world: world.run(1.0, progress=interrupt),
    "infinite": lambda world: (spoil(world.balls.position, np.nan), world.step(0.1)),
    "argument": lambda world: (spoil(world.balls.radius, -1.0), world.step(0.1)),
    "query": lambda world: world.overlapping((1, 0, 0, 1)),  # type: ignore[call-overload]
    "add": lambda world: world.add(world.balls[0]),
}


@pytest.mark.parametrize("way", ENDS)
def test_a_world_is_free_again_after_whatever_was_raised(way: str) -> None:
    world = quiet()
    with pytest.raises((KeyboardInterrupt, carom.CaromError)):
        ENDS[way](world)
    world.balls.radius[0], world.balls.position[0] = 0.5, (0, 0)
    world.balls[0].velocity = (0, 1)
    world.step(0.1)


def started(program: str) -> str:
    """What a program prints, which must come to its end."""
    done = subprocess.run(
        [sys.executable, "-c", program], capture_output=True, text=True, timeout=300, cwd=ROOT, check=False
    )
    assert done.returncode == 0, f"{done.returncode}: {done.stderr[-3000:]}"
    return done.stdout


#: Threads that use one world as they like; what was accepted, in its order, is then done to another one alone.
HAMMER = '''
import random, sys, threading, time
import carom
from carom.turns import Turn

sys.setswitchinterval(1e-5)
local = threading.local()
accepted, refused, wrong, kinds = [], 0, [], set()


class Noted(Turn):
    """The turns of a world, which note what was done when one ends."""

    def __setattr__(self, name, value):
        accepted.append(local.did)
        kinds.add(local.did and local.did[0])
        super().__setattr__(name, value)


def room(detection):
    world = carom.World(gravity=(0, -9), detection=detection, substeps=2)
    corners = [(-10, 0), (10, 0), (10, 10), (-10, 10)]
    world.add(*[carom.Segment(corners[n - 1], corners[n]) for n in range(4)])
    world.add(carom.Segment((-2, 5), (2, 5), motion="kinematic", angular_velocity=1.0))
    world.add_balls([(-9 + 0.5 * n, 1 + k) for n in range(36) for k in range(8)], radius=0.2)
    return world


DO = {
    "step": lambda world, number: world.step(0.005),
    "run": lambda world, number: world.run(0.02, 0.005),
    "push": lambda world, number: setattr(world.object(world.balls.id[number % 200]), "velocity", (number % 7, 3)),
    "gravity": lambda world, number: setattr(world, "gravity", (0, -9 - number % 3)),
    "turn": lambda world, number: setattr(world.shapes[4], "angular_velocity", number % 5),
    "place": lambda world, number: setattr(world.shapes[4], "position", (number % 3, 5)),
    "balls": lambda world, number: world.add_balls([(number % 9, 9)], radius=0.1),
    "remove": lambda world, number: world.remove(world.balls[200]),
    "wall": lambda world, number: world.add(carom.Point((number % 9, 4))),
    "ray": lambda world, number: world.ray_cast([(-9, 5), (0, 9)], (9, 5)),
    "near": lambda world, number: world.nearest([(k / 10, 5) for k in range(-90, 90)]),
    "contacts": lambda world, number: world.contacts(),
    "snapshot": lambda world, number: world.snapshot(),
    "columns": lambda world, number: world.balls.radius,
}
#: Only one thread removes, so that what it removes is there.
THREADS = [["step", "run"], ["run"], ["push", "gravity", "turn", "place"], ["balls", "wall"], ["remove", "balls"]]
THREADS += [["ray", "near", "contacts"], ["snapshot", "columns", "step", "ray"]]


def work(world, names, seed, end):
    global refused
    chance = random.Random(seed)
    while time.perf_counter() < end or (not kinds.issuperset(DO) and time.perf_counter() < end + 60.0):
        local.did = chance.choice(names), chance.randrange(1000)
        try:
            DO[local.did[0]](world, local.did[1])
        except carom.WorldBusy:
            refused += 1
            time.sleep(chance.choice((0.0, 1e-4, 1e-3)))
        except BaseException as error:
            wrong.append(repr(error))
            return


for detection in ("discrete", "continuous"):
    accepted.clear()
    kinds.clear()
    world, twin = room(detection), room(detection)
    for name in DO:
        DO[name](room(detection), 1)  # compiles
    local.did = None
    world._turn = Noted()
    end = time.perf_counter() + 2.0
    threads = [threading.Thread(target=work, args=(world, names, n, end)) for n, names in enumerate(THREADS)]
    [thread.start() for thread in threads]
    [thread.join() for thread in threads]
    assert not wrong, wrong[:3]
    local.did = None
    done = [what for what in accepted if what is not None]
    for name, number in done:
        DO[name](twin, number)
    assert world.digest() == twin.digest(), detection
    print(detection, len(done), refused, sorted(kinds - {None}) == sorted(DO))
'''


@pytest.mark.slow
@pytest.mark.compiled
def test_threads_that_use_one_world_are_refused_or_served_and_nothing_is_broken() -> None:
    lines = started(HAMMER).splitlines()
    assert [line.split()[0] for line in lines] == ["discrete", "continuous"]
    for line in lines:
        _, done, turned_away, everything = line.split()
        assert (int(done) > 50, int(turned_away) > 50, everything) == (True, True, "True"), line


#: Worlds in threads of their own, in a fresh process, where all of them wait for the compiler.
TOGETHER = """
import threading
import carom
from tests.worlds import crowded


def played(number):
    world = crowded(30, seed=number, detection=("discrete", "continuous")[number % 2])
    hits = world.run(0.5)
    return world.digest(), hits.tobytes(), world.contacts().tobytes(), world.nearest([(3, 3), (8, 8)]).tobytes()


together = {}
threads = [threading.Thread(target=lambda n=n: together.update({n: played(n)})) for n in range(6)]
[thread.start() for thread in threads]
[thread.join() for thread in threads]
assert together == {n: played(n) for n in range(6)}
"""


@pytest.mark.slow
@pytest.mark.compiled
def test_worlds_in_threads_of_their_own_give_the_bits_that_they_give_in_turn() -> None:
    started(TOGETHER)
