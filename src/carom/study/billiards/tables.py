"""Closed tables: what a scene's walls enclose, measured exactly, and places to start from."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from math import pi
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from carom.checks import array, flag, positive, refuse, whole
from carom.rows.ball import ALL_LAYERS
from carom.scene import scenes
from carom.scene.scene import Scene
from carom.scene.shape_descriptors import (
    ArcDescriptor,
    CircleDescriptor,
    CompoundDescriptor,
    PointDescriptor,
    SegmentDescriptor,
)
from carom.spelling import spelled
from carom.study.billiards.outline import Floats, Loop, Piece, loops_of, named, unfit

if TYPE_CHECKING:
    from carom.world import World
    from carom.world.boundary import Wall

#: Radius of the balls that stand for points, in the table's size: the greatest coordinate, or the root of its area. So
#: small that no statistical error sees it, so large that walls which join leave no gap for it.
POINT = 1e-5
#: The layer that balls of an ensemble are on, and those that they meet.
BALL_LAYER, OTHER_LAYERS = 2, ALL_LAYERS ^ 2
#: Starts that are tried at least and at most at once, and in all until that is given up; a slow ball under gravity
#: reaches only a small part of a table.
FEWEST_TRIES, LONGEST_TRIAL, MOST_TRIES = 64, 1_000_000, 200_000_000
#: Balls of an ensemble at most.
MOST_ORBITS = 10_000_000


class Starts(NamedTuple):
    """Where orbits begin, `position` of shape (n, 2), and how, `velocity` likewise."""

    position: Floats
    velocity: Floats


@dataclass(frozen=True)
class Table:
    """A closed table: what the walls of a scene enclose; `study.table` makes it.

    Attributes:
        scene: The scene, without its balls.
        loops: The outer wall and then the islands, largest first, each a counterclockwise chain of walls.
    """

    scene: Scene
    loops: tuple[Loop, ...]

    @cached_property
    def pieces(self) -> list[Piece]:
        """The walls of all loops, loop after loop, each in order."""
        return [piece for loop in self.loops for piece in loop.pieces]

    @cached_property
    def area(self) -> float:
        """What a ball that is a point can reach: within the outer wall and outside of the islands."""
        return self.loops[0].area - sum(island.area for island in self.loops[1:])

    @cached_property
    def perimeter(self) -> float:
        """The length of all walls, those of the islands too."""
        return sum(loop.length for loop in self.loops)

    @cached_property
    def size(self) -> float:
        """The greatest coordinate of a wall, or the root of the area where that is more; what rounding goes by."""
        reach = max(max(np.abs(places).max() for places in loop.looks()) for loop in self.loops)
        return max(float(reach), float(np.sqrt(self.area)))

    def contains(self, points: ArrayLike) -> NDArray[np.bool_]:
        """Which of `points`, of shape (n, 2), lie in the table; what is said of a place on a wall is left open."""
        x, y = array("points", points, (-1, 2)).T
        return self._holds(x, y)

    def _holds(self, x: Floats, y: Floats) -> NDArray[np.bool_]:
        """Which places lie in it: those that an odd number of loops enclose."""
        inside = np.zeros(len(x), np.bool_)
        for loop in self.loops:
            inside ^= loop.contains(x, y)
        return inside

    @spelled
    def random_starts(self, n: int, seed: int = 0, *, boundary: bool = False, speed: float = 1.0) -> Starts:
        """Starts of `n` orbits, drawn by NumPy from `seed`, as the invariant measure has them.

        They are uniform in phase space: everywhere in the table as often, in all directions alike. With `boundary=True`
        they leave the wall, uniform in its arc length and in the sine of the angle to its normal. Under gravity all
        have the same energy: `speed` is that at the table's lowest place, and no start is higher than it reaches.

        Raises `InvalidArgument` for what is no number of orbits, seed or speed.
        """
        count, generator = whole("n", n, 1, MOST_ORBITS), np.random.default_rng(whole("seed", seed))
        fastest = positive("speed", speed)
        draw = self._on_walls if flag("boundary", boundary) else self._inside
        places, ways = np.empty((0, 2)), np.empty((0, 2))
        tries, trial = 0, 2 * count + FEWEST_TRIES
        while len(places) < count:
            if tries > MOST_TRIES:
                raise refuse("speed", "must be enough to get somewhere under gravity", speed)
            more_places, more_ways = draw(generator, trial, fastest)
            places, ways = np.concatenate((places, more_places)), np.concatenate((ways, more_ways))
            tries += trial
            # As many as are still missing, at the share that was good so far, and some more.
            trial = min(FEWEST_TRIES + 2 * (count - len(places)) * tries // (len(places) + 1), LONGEST_TRIAL)
        return Starts(places[:count].copy(), ways[:count].copy())

    @spelled
    def ensemble(self, n: int, seed: int = 0, *, boundary: bool = False, speed: float = 1.0) -> World:
        """A world of the continuous mode: the table's walls, and `n` balls at `random_starts` that do not meet.

        The balls stand for points: their radius is a hundred-thousandth of the table's size.
        """
        return self.world_of(self.random_starts(n, seed, boundary=boundary, speed=speed))

    def world_of(self, starts: Starts) -> World:
        """A world of the table's walls and balls at given starts, as `ensemble` makes it."""
        from carom.world import World  # here, so that tables can be measured without a compiler

        world = World()
        self.fill(world, starts)
        return world

    def fill(self, world: World, starts: Starts) -> None:
        """Make a world what `world_of` returns, which takes less where it has been that before."""
        world.restore(self._walls)
        radius = POINT * self.size
        world.add_balls(*starts, radius=radius, layer=BALL_LAYER, collides_with=OTHER_LAYERS)

    @cached_property
    def _walls(self) -> bytes:
        """A snapshot of a world of the table's walls: to restore it takes a tenth of what it takes to build one."""
        world = self.scene.build()
        world.detection, world.bounds = "continuous", None
        return world.snapshot()

    def _speeds(self, places: Floats, fastest: float) -> Floats:
        """How fast a ball is at places that reaches `fastest` at the lowest one; less than 0 where it does not come."""
        gravity = np.array(self.scene.world.gravity)
        lowest = max(float((np.column_stack(loop.looks()) @ gravity).max()) for loop in self.loops)
        squared = fastest * fastest - 2.0 * (lowest - places @ gravity)
        speeds: Floats = np.where(squared > 0.0, np.sqrt(np.abs(squared)), -1.0)
        return speeds

    def _inside(self, generator: np.random.Generator, count: int, fastest: float) -> tuple[Floats, Floats]:
        """Some starts in the table, of as many that are tried.

        In the plane the density of the same energy is even wherever that is enough, for 2 π v dv is d(v²/2).
        """
        x, y = self.loops[0].looks()
        places = generator.uniform((x.min(), y.min()), (x.max(), y.max()), (count, 2))
        angles = generator.uniform(0.0, 2.0 * pi, count)
        speeds = self._speeds(places, fastest)
        good = self._holds(places[:, 0], places[:, 1]) & (speeds > 0.0)
        ways = speeds[:, None] * np.column_stack((np.cos(angles), np.sin(angles)))
        return places[good], ways[good]

    def _on_walls(self, generator: np.random.Generator, count: int, fastest: float) -> tuple[Floats, Floats]:
        """Some starts from the walls, of as many that are tried; the flux through a place goes by the speed there."""
        along, sines = generator.uniform(0.0, self.perimeter, count), generator.uniform(-1.0, 1.0, count)
        kept = generator.random(count)
        places, tangents = self._at(along)
        normals = np.column_stack((-tangents[:, 1], tangents[:, 0]))  # to the left, within; out of an island
        normals[along > self.loops[0].length] *= -1.0
        speeds = self._speeds(places, fastest)
        good = kept * fastest < speeds
        ways = sines[:, None] * tangents + np.sqrt(1.0 - sines * sines)[:, None] * normals
        return (places + POINT * self.size * normals)[good], (speeds[:, None] * ways)[good]

    def _at(self, along: Floats) -> tuple[Floats, Floats]:
        """The places so far along the outline, loop after loop, and the loops' unit tangents there."""
        pieces = self.pieces
        begins = np.cumsum([0.0, *(piece.wall.length for piece in pieces)])
        numbers = np.clip(np.searchsorted(begins, along, side="right") - 1, 0, len(pieces) - 1)
        places, tangents = np.empty((len(along), 2)), np.empty((len(along), 2))
        for number in np.unique(numbers):
            mine = numbers == number
            places[mine], tangents[mine] = pieces[number].at(along[mine] - begins[number])
        return places, tangents


def table(scene: Scene | Table | str) -> Table:
    """The closed table that the walls of a scene make: a `Scene`, the name of a shipped one, or a table as it is.

    Its walls are the segments, arcs and circles that balls bounce off; they must stand still, and every end must join
    one other. One loop is the outer wall; those within it are islands. Sensors, what cannot collide, and the scene's
    balls are left out.

    Raises:
        InvalidArgument: The scene is no closed table; the message says which shape is in the way.

    >>> from carom import scenes, study
    >>> ring = study.table(scenes.annulus(outer=2, inner=1, offset=0.5))
    >>> print(f"{ring.area / pi:.12g} {ring.perimeter / pi:.12g}")
    3 6
    """
    if isinstance(scene, Table):
        return scene
    if isinstance(scene, str):
        scene = scenes.by_name(scene)
    if not isinstance(scene, Scene):
        raise refuse("scene", "must be a Scene, the name of a shipped one, or a Table", scene)
    walls = [(place, _wall(scene, place)) for place in range(len(scene.shapes)) if _is_wall(scene, place)]
    for setting in ("friction", "sleep_speed"):
        if getattr(scene.world, setting) != 0.0:
            raise unfit(scene, f"must have no {setting} to be a table")
    loops = loops_of(scene, walls)
    return Table(scene.model_copy(update={"balls": ()}), loops)


def _is_wall(scene: Scene, place: int) -> bool:
    """Whether a shape of a scene is one that balls of an ensemble bounce off; raises for what no table has."""
    shape: Any = scene.shapes[place]
    if isinstance(shape, CompoundDescriptor):
        raise _unfit(scene, place, "is a compound")
    met = shape.layer & OTHER_LAYERS and shape.collides_with & BALL_LAYER
    if shape.sensor or not shape.can_collide or not met or isinstance(shape, PointDescriptor):
        return False
    if not isinstance(shape, (SegmentDescriptor, ArcDescriptor, CircleDescriptor)):
        raise _unfit(scene, place, f"is a {shape.kind}")
    if shape.motion != "static" and (shape.angular_velocity != 0.0 or shape.velocity != (0.0, 0.0)):
        raise _unfit(scene, place, "moves")
    return True


def _wall(scene: Scene, place: int) -> Wall:
    """The wall that a descriptor describes."""
    wall: Any = scene.shapes[place]
    built: Wall = wall.build()
    return built


def _unfit(scene: Scene, place: int, what: str) -> Exception:
    """The error to raise for a shape that no table has."""
    return unfit(scene, f"must be a closed table; {named(scene, place)} {what}")
