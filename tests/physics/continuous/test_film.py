"""One film: what happens is there before anyone looks, so other steps show the same bits at the same times."""

from collections.abc import Callable
from functools import partial
from math import pi
from typing import Any, NamedTuple

import numpy as np
import pytest

from carom import Arc, Ball, Circle, Compound, Gate, Point, Segment, World
from carom.world.removal import relations_in_order
from tests.worlds import Member, box, continuous_world, guarded

SIDE = 8.0
TIMES = (1, 2, 3)

#: Steps that lead to each of the times exactly, in units of 1/1024 s; a second is looked at from 1 to 128 times.
PATTERNS: dict[str, list[int]] = {
    "1/64": [16] * 64,
    "1/128": [8] * 128,
    "uneven": [1, 700, 3, 64, 5, 200, 17, 33, 1],
    "one tick, then the rest": [1, 1023],
}


class Shown(NamedTuple):
    """What is seen of a world at a time."""

    position: list[list[float]]
    velocity: list[list[float]]
    shapes: list[tuple[Any, ...]]
    relations: list[tuple[int, int, int]]
    asleep: list[int]
    hits: list[bytes]


def shown(world: World, hits: list[bytes]) -> Shown:
    """What is seen of a world now, and its hits since it was made."""
    return Shown(
        world.balls.position.tolist(),
        world.balls.velocity.tolist(),
        [(shape.orientation, *shape.position, *shape.velocity) for shape in world.shapes],
        sorted(relations_in_order(world._arrays)),
        world._arrays.balls.used["asleep"].tolist(),
        list(hits),
    )


def film(world: World, steps: list[int]) -> list[Shown]:
    """What is seen at each of the times where each second is cut into steps."""
    assert sum(steps) == 1024
    pictures: list[Shown] = []
    hits: list[bytes] = []
    for time in TIMES:
        for step in steps:
            hits += [hit.tobytes() for hit in np.asarray(world.step(step / 1024))]
        assert world.time == time
        pictures.append(shown(world, hits))
    return pictures


def launched(world: World, count: int, seed: int = 0, elasticity: float = 1.0, radius: float = 0.2) -> World:
    """The world with so many balls in it, on a lattice inside the box, that fly in all directions."""
    random = np.random.default_rng(seed)
    columns = int(np.ceil(np.sqrt(count)))
    places = [(1 + 6 * (k % columns + 0.5) / columns, 1 + 6 * (k // columns + 0.5) / columns) for k in range(count)]
    radii = random.uniform(0.6, 1.0, count) * radius
    world.add_balls(places, velocity=random.uniform(-6, 6, (count, 2)), radius=radii, elasticity=elasticity)
    return world


def room(*furniture: Member, **settings: Any) -> World:
    """A closed box with something in it."""
    return continuous_world(*guarded(box(SIDE, SIDE)), *furniture, **settings)


def bowls() -> list[Member]:
    """Arcs bent either way, a hollow circle, a solid one and a post."""
    cups = [Arc((4, 1.6), 1.3, pi + 0.2, 2 * pi - 0.2), Arc((2, 6.5), 0.8, 0.3, 2.5)]
    return [*guarded(cups), Circle((6.3, 5), 0.6, solid=True), Circle((2, 3.7), 0.5), Point((4.1, 5))]


def sensors() -> list[Member]:
    """A sensor of each kind."""
    eyes = [
        Circle((2, 6), 1.0, solid=True, sensor=True),
        Circle((6, 2), 1.0, sensor=True),
        Segment((3, 3), (6, 4), sensor=True),
        Arc((5, 6), 1.0, 0.4, 3.5, sensor=True),
        Point((4, 2), sensor=True),
    ]
    return [*eyes, Ball((4, 4), 0.7, velocity=(0.4, 0.3), sensor=True), Ball((1, 1), 0.3, velocity=(2, 3), sensor=True)]


def gates() -> list[Member]:
    """Gates that open either way."""
    return [Gate((2, 1), (2, 6), direction=(1, 0)), Gate((1, 4), (7, 4.5), direction=(0, -1))]


def mill(**options: Any) -> Compound:
    """A wheel of a bar, its ends and an arc that turns for ever."""
    parts = guarded([Segment((3, 4), (5, 4.1)), Arc((4, 4), 0.6, 0.5, 2.0)])
    return Compound(parts, pivot=(4, 4), **({"angular_velocity": 1.7} | options))


def turning(kind: str) -> list[Member]:
    """One shape of a kind that turns steadily."""
    turns: dict[str, Any] = {"motion": "kinematic", "pivot": (4, 4), "angular_velocity": 2.3}
    made: dict[str, Callable[[], Member]] = {
        "point": lambda: Point((5, 4), **turns),
        "segment": lambda: Segment((4, 4), (5.5, 4.2), **turns),
        "gate": lambda: Gate((4, 4), (5.5, 4.2), direction=(0, 1), **turns),
        "circle": lambda: Circle((4.6, 4), 0.5, solid=True, **turns),
        "ring": lambda: Circle((4.3, 4), 0.7, **turns),
        "arc": lambda: Arc((4.2, 4), 0.8, 1, 4, **turns),
        "sensor": lambda: Segment((4, 4), (6.5, 4.2), sensor=True, **turns),
        "disc that senses": lambda: Circle((5, 4), 0.8, solid=True, sensor=True, **turns),
    }
    return [made[kind]()]


def flippers() -> list[Member]:
    """Bars that stop at their limits, one soon and one later."""
    return [
        Segment((1, 3), (3, 3), motion="kinematic", pivot=(1, 3), turn_limits=(-0.5, 0.7), angular_velocity=3.0),
        Segment((7, 5), (5, 5), motion="kinematic", pivot=(7, 5), turn_limits=(-0.9, 0.2), angular_velocity=-0.41),
    ]


def sent(world: World) -> World:
    """The world with a lift that is on its way to a place and a bar that turns and travels to another."""
    lift = world.add(Segment((1, 1.5), (3, 1.5), motion="kinematic"))
    bar = world.add(Segment((5, 4), (6, 5), motion="kinematic"))
    lift.move_to((2.3, 4.5), dt=1.3)
    bar.move_to((5, 6), dt=2.7, orientation=1.1)
    return world


def travelling() -> list[Member]:
    """A bar, a disc and a point that travel on for ever."""
    return [
        Segment((1, 2), (3, 2.3), motion="kinematic", velocity=(0.3, 0.7)),
        Circle((6, 6), 0.5, solid=True, motion="kinematic", velocity=(-0.9, -0.4)),
        Point((6, 1), motion="kinematic", velocity=(-0.2, 1.1)),
    ]


def many(world: World) -> World:
    """The world with so many posts and bars in it that the way of a ball is followed from cell to cell."""
    random = np.random.default_rng(5)
    for x, y in random.uniform(0.6, SIDE - 0.6, (40, 2)):
        world.add(Point((x, y)))
    for x, y in random.uniform(1.0, SIDE - 1.0, (10, 2)):
        world.add(Segment((x, y), (x + random.uniform(-0.5, 0.5), y + random.uniform(0.1, 0.5))))
    return world


FALL: dict[str, Any] = {"gravity": (0.3, -9.0)}
RUB: dict[str, Any] = {"friction": 1.3}

#: Worlds before balls are launched in them.
PLACES: dict[str, Callable[[], World]] = {
    "box": room,
    "box, gravity": lambda: room(**FALL),
    "box, friction": lambda: room(**RUB),
    "box, friction and gravity": lambda: room(**FALL, **RUB),
    "box, rest speed": lambda: room(**FALL, rest_speed=0.3),
    "box, sleep": lambda: room(**FALL, sleep_speed=0.3, sleep_time=0.2),
    "box, friction and sleep": lambda: room(**RUB, sleep_speed=0.3, sleep_time=0.2),
    "box, max speed": lambda: room(**FALL, max_speed=7.0),
    "bowls": lambda: room(*bowls()),
    "bowls, gravity": lambda: room(*bowls(), **FALL),
    "bowls, friction": lambda: room(*bowls(), **RUB),
    "bowls, friction and gravity": lambda: room(*bowls(), **FALL, **RUB),
    "sensors": lambda: room(*sensors()),
    "sensors, gravity": lambda: room(*sensors(), **FALL),
    "sensors, friction": lambda: room(*sensors(), **RUB),
    "gates": lambda: room(*gates()),
    "gates, gravity": lambda: room(*gates(), **FALL),
    "mill": lambda: room(mill()),
    "mill, gravity": lambda: room(mill(), **FALL),
    "mill that senses": lambda: room(mill(sensor=True)),
    "flippers": lambda: room(*flippers()),
    "flippers, gravity": lambda: room(*flippers(), **FALL),
    "sent": lambda: sent(room()),
    "sent, gravity": lambda: sent(room(**FALL)),
    "travelling": lambda: room(*travelling()),
    "travelling, gravity": lambda: room(*travelling(), **FALL),
    "many": lambda: many(room()),
    "many, gravity": lambda: many(room(**FALL)),
} | {f"turning {kind}": partial(lambda kind: room(*turning(kind)), kind) for kind in (
    "point", "segment", "gate", "circle", "ring", "arc", "sensor", "disc that senses"
)}  # fmt: skip


def differences(one: list[Shown], other: list[Shown]) -> list[str]:
    """What differs between two films, by the name of what is seen and the time of the first picture."""
    found = []
    for time, first, second in zip(TIMES, one, other, strict=True):
        found += [
            f"{name} at {time}"
            for name in Shown._fields
            if getattr(first, name) != getattr(second, name)
        ]  # fmt: skip
    return found


@pytest.mark.parametrize("elasticity", [1.0, 0.5])
@pytest.mark.parametrize(
    "count",
    [
        1,
        pytest.param(3, marks=pytest.mark.compiled),
        pytest.param(12, marks=pytest.mark.compiled),
        pytest.param(40, marks=[pytest.mark.compiled, pytest.mark.slow]),
    ],
)
@pytest.mark.parametrize("name", PLACES)
def test_other_steps_show_the_same_film(name: str, count: int, elasticity: float) -> None:
    expected = film(launched(PLACES[name](), count, elasticity=elasticity), [1024])
    for pattern, steps in PATTERNS.items():
        found = film(launched(PLACES[name](), count, elasticity=elasticity), steps)
        assert differences(expected, found) == [], pattern
