"""A user's program in which nothing is wrong: type checkers must have nothing to say of it. It is read, never run."""

from collections.abc import Sequence
from pathlib import Path
from typing import assert_type

import numpy as np
from numpy.typing import NDArray

import carom
from carom.typing import BroadPhase, Detection, MotionName, Pair, Restitution, Vector
from carom.world import Aims, CastHits, Contacts, Hit, Neighbors

# -- pairs: tuples, lists and arrays, wherever a pair is taken ---------------------------------------------------------

array = np.array([1.0, 2.0])
whole: NDArray[np.int64] = np.array([1, 2])
numbers = [1, 2]
halves = [0.5, 1.5]
pairs: list[Pair] = [(1, 2), (1.0, 2), [1, 2], [0.5, 2.5], array, whole, numbers, halves, (np.float64(1), np.int64(2))]


def take(pair: Pair) -> Vector:
    """Whatever takes a pair."""
    ball = carom.Ball(pair, 1, velocity=pair)
    ball.position = pair
    ball.center = pair
    ball.velocity = pair
    ball.move(0.1, gravity=pair)
    wall = carom.Segment(pair, pair, motion="kinematic", pivot=pair, velocity=pair, turn_limits=pair)
    wall.start = wall.end = wall.p0 = wall.p1 = pair
    wall.set_ends(pair, pair)
    wall.pivot = wall.velocity = pair
    wall.position = wall.turn_limits = pair
    wall.rotate(pair, 1.0)
    wall.move_to(pair, 0.1, orientation=1.0)
    gate = carom.Gate(pair, pair, direction=pair)
    gate.direction = pair
    arc = carom.Arc(pair, 1, 0, 1)
    arc.angles = pair
    arc.center = pair
    post = carom.Point(pair)
    post.position = pair
    mill = carom.Compound([wall, arc], pair, velocity=pair, turn_limits=pair)
    mill.position = mill.pivot = mill.velocity = mill.turn_limits = pair
    mill.rotate(pair, 1.0)
    near: tuple[Vector, ...] = (wall.closest_point(pair), mill.closest_point(pair), ball.closest_point(pair))
    far: float = wall.distance(pair) + ball.distance(pair)
    flags: bool = arc.in_sector(pair) or arc.contains(pair) or pair in carom.Aabb.at(pair).including(pair)
    table = carom.World(gravity=pair)
    table.gravity = pair
    line = carom.Line.through(pair, carom.rotate_point(pair, pair, 1.0))
    print(near, far, flags, line)
    return carom.normalize(carom.perp(carom.parallel_component(pair, pair)))


turned: Vector = carom.angle_to_vector(carom.normalize_angle(7.0))
units: list[Vector] = [take(pair) for pair in pairs]
ball = carom.Ball(numbers, 1, velocity=array)
wall = carom.Segment([0, 0], np.array([1, 0]), motion="kinematic")
arc = carom.Arc((0, 0), 1, 0, 1)
mill = carom.Compound([arc], (0, 0))
assert_type(ball.position, tuple[float, float])
assert_type(arc.angles, tuple[float, float])
assert_type(carom.Segment((0, 0), (1, 0)).turn_limits, tuple[float, float] | None)
ball.position = np.array([1, 2])
ball.position = [1, 2]
wall.turn_limits = None

# -- words -------------------------------------------------------------------------------------------------------------

detection: Detection = "continuous"
broad_phase: BroadPhase = "quadtree"
restitution: Restitution = "total"
motion: MotionName = "static"
world = carom.World(
    detection=detection, broad_phase=broad_phase, restitution=restitution, bounds=(0, 0, 10, 10), max_speed=None
)
assert_type(world.detection, Detection)
assert_type(world.gravity, tuple[float, float])
assert_type(world.bounds, carom.Aabb | None)
assert_type(world.rest_speed, float | None)
assert_type(wall.motion, carom.Motion)
world.detection = "discrete"
world.broad_phase = "grid"
world.restitution = "normal"
world.bounds = [0, 0, 10, 10]
world.bounds = carom.Aabb(0, 0, 10, 10)
world.bounds = None
world.rest_speed = None
world.substeps = 8
wall.motion = motion
wall.motion = "kinematic"
wall.motion = carom.Motion.KINEMATIC
circle = carom.Circle((0, 0), 1, solid=True, elasticity=0.5, layer=2, name="bumper", user={"score": 10})

# -- worlds, hits and contacts -----------------------------------------------------------------------------------------

assert_type(world.add(wall), carom.Segment)
assert_type(world.add(ball), carom.Ball)
assert_type(world.add(mill), carom.Compound)
ids: NDArray[np.int64] = world.add_balls([(0, 1), (2, 3)], radius=[1, 2])
contact = wall.detect(ball)
if contact:
    ball.respond(contact, restitution="total")
    assert_type(contact.normal, tuple[float, float])

hits = world.run(1.0, dt=1 / 60, progress=lambda done, total: print(done / total))
for hit in world.step(1 / 60):
    assert_type(hit, Hit)
    assert_type(hit.time, float)
    assert_type(hit.ball, carom.Ball)
if hits:
    assert_type(hits[0], Hit)
    assert_type(hits[-1].speed, float)
assert_type(hits[:3], carom.Hits)
assert_type(hits[hits["speed"] > 3.0], carom.Hits)
assert_type(hits[np.array([0, 1])], carom.Hits)
assert_type(hits[[0, 1]], carom.Hits)
fastest: float = max(hits["speed"])
loud = hits["speed"] > 3.0
first: Hit | None = next(iter(hits), None)
bounces: list[Hit] = [hit for hit in hits if hit.kind is carom.HitKind.BOUNCE]
centres: NDArray[np.float64] = world.balls.position
second: carom.Ball = world.balls[1]
some: list[carom.Ball] = world.balls[:2]
thing: carom.Shape | carom.Ball = world.object(3)
state: bytes = world.snapshot()

# -- questions ---------------------------------------------------------------------------------------------------------

many = np.zeros((5, 2))
list_of_pairs: Sequence[tuple[float, float]] = [(0.0, 1.0), (2.0, 3.0)]
assert_type(world.ray_cast((0, 0), (1, 1)), carom.CastHit | None)
assert_type(world.ray_cast([0, 0], [1, 1]), carom.CastHit | None)
assert_type(world.ray_cast((0, 0), many), CastHits)
assert_type(world.ray_cast(list_of_pairs, (0, 0)), CastHits)
assert_type(world.ray_cast([(0, 0), (1, 1)], many, layer=1, sensors=True), CastHits)
assert_type(world.circle_cast((0, 0), 1, (1, 1)), carom.CastHit | None)
assert_type(world.circle_cast((0, 0), [1, 2], (1, 1)), CastHits)
assert_type(world.circle_cast(many, 1, (1, 1)), CastHits)
assert_type(world.nearest((0, 0)), carom.Neighbor | None)
assert_type(world.nearest(many), Neighbors)
assert_type(world.aim(ball, (1, 0)), carom.Aim | None)
assert_type(world.aim(ball, many), Aims)
assert_type(world.contacts(), Contacts)
if world.contacts():
    assert_type(world.contacts()[0], carom.Contact)
for found in world.contacts():
    assert_type(found.setback, float)
casts = world.ray_cast((0, 0), many)
assert_type(casts[0], carom.CastHit | None)
assert_type(casts[1:], CastHits)
assert_type(casts[casts.found], CastHits)
free = casts["fraction"] == 1.0
inside: list[carom.Shape | carom.Ball] = world.overlapping(carom.Aabb(0, 0, 1, 1))
inside = world.overlapping((0, 0, 1, 1))
boxes = world.overlapping([carom.Aabb(0, 0, 1, 1), (0, 0, 1, 1)])["box"]

# -- scenes, recordings, pictures, plots -------------------------------------------------------------------------------

scene = carom.Scene(world={"gravity": (0, -9.8)}, shapes=[wall, mill], balls=[ball], guard=True)
assert_type(scene.build(), carom.World)
assert_type(carom.scenes.galton(rows=3, balls=5), carom.Scene)
recording = carom.Recording.of(world, 1.0, every=2, name="run")
recorder = carom.Recorder(world, name="run")
recorder.note(world.step(1 / 60))
again: carom.Recording = recorder.finish()
room: list[carom.Shape] = carom.outlines.rectangle(0, 0, 4, 3, corner=1.0, elasticity=0.9)
points: list[carom.Point] = carom.guard_points([wall, mill], tolerance=1e-6)
picture: str = carom.draw.svg(carom.draw.picture_of(world, "table", caption="a table"))
pixels: bytes = carom.draw.png(carom.draw.picture_at(recording, 3))
axes = carom.study.plots.energy(recording)
chaos = carom.study.lyapunov("sinai", n=10, hits=100, seed=1, speed=2.0)
assert_type(chaos.seconds, float)
axes = carom.study.plots.spectrum(chaos)
assert_type(carom.study.boundary_map("circle", n=10, hits=10).density(bins=4).error, NDArray[np.float64])
assert_type(carom.study.lyapunov_of(world, seconds=1).hits, int)
assert_type(carom.study.section("wedge", cut=((0, 0), [0, 3]), n=10, hits=100, seed=1).along, NDArray[np.float64])


try:
    done = carom.compile()
    assert_type(done.folder, Path)
    assert_type(done.seconds, dict[str, float])
    assert_type(carom.compiling(), bool)
except carom.CompileError as error:
    print(error)


brick: carom.Group = world.add(carom.Group(carom.outlines.rectangle(0, 0, 2, 1), once=True, name="brick"))
print(brick.can_collide, brick.shapes[0].group)
copies_of_it = carom.Worlds(carom.scenes.pinball(), copies=4, threads=1)
print(copies_of_it.step(1 / 60)["world"], copies_of_it.balls.position.shape)
print(copies_of_it.shapes["left flipper"].orientation.mean())
taken: carom.World = copies_of_it[0]
copies_of_it.load(1, taken)
copies_of_it.store(0, taken)
copies_of_it.reset([0, 1])


class Game(carom.World):
    """A subclass has what it likes."""

    def __init__(self) -> None:
        super().__init__(gravity=(0, -10))
        self.score = 0


game = Game()
game.score += 1
try:
    carom.Ball((0, 0), -1)
except carom.UnknownName as error:
    print(error)
except carom.InvalidArgument as error:
    print(error)
except carom.WorldBusy as error:
    print(error)
except carom.NonFiniteState as error:
    print(error.hits)
except carom.ImpactLimit as error:
    print(error.balls, error.time, error.hits)
except (carom.SceneError, carom.SnapshotError, carom.TaskError, carom.RecordingError, carom.SweepError) as error:
    print(error)
except (carom.MissingExtra, carom.LostObject) as error:
    print(error)
except carom.CaromError as error:
    print(error, carom.__version__)
