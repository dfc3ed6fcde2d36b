"""The engines, each made from a `Setup` and stepped: carom, and the peers that are installed."""

import importlib.util
from collections.abc import Callable
from math import inf, sqrt
from typing import Any, Protocol

import numpy as np

import carom
from benchmarks.setup import Floats, Setup


class Engine(Protocol):
    """A world that holds a setup's balls and shapes."""

    def step(self) -> None:
        """Move everything by the setup's time step."""

    def state(self) -> tuple[Floats, Floats]:
        """Positions and velocities of the balls."""

    def first_ball(self) -> tuple[float, float]:
        """The position of the first ball, read the way a user would."""


class Carom:
    """carom, discrete or continuous: one substep, the setup's iterations, guard points at ends of segments."""

    def __init__(self, setup: Setup, detection: str = "discrete") -> None:
        each = sqrt(setup.elasticity)
        self.world = carom.World(
            gravity=setup.gravity, detection=detection, substeps=1, iterations=setup.iterations
        )  # fmt: skip
        shapes: list[carom.Shape] = [carom.Segment((ax, ay), (bx, by)) for ax, ay, bx, by in setup.segments]
        if not setup.chained:  # no ball inside of a convex line can touch its corners
            shapes += carom.guard_points(shapes)
        shapes += [carom.Circle((x, y), radius, solid=True) for x, y, radius in setup.circles]
        shapes += [carom.Circle((x, y), radius) for x, y, radius in setup.rings]
        for shape in shapes:
            shape.elasticity = each
            self.world.add(shape)
        self.world.add_balls(setup.position, setup.velocity, radius=setup.radius, elasticity=each)
        self.first = self.world.balls[0]
        self.time_step = setup.time_step

    def step(self) -> None:
        """One step; its hits are not looked at."""
        self.world.step(self.time_step)

    def state(self) -> tuple[Floats, Floats]:
        """Copies of the world's arrays."""
        return self.world.balls.position.copy(), self.world.balls.velocity.copy()

    def first_ball(self) -> tuple[float, float]:
        """The ball's position."""
        return self.first.position


class Pymunk:
    """pymunk: its ten iterations, for with one it loses a tenth of a gas's energy; no friction, no spin."""

    def __init__(self, setup: Setup) -> None:
        import pymunk

        each = sqrt(setup.elasticity)
        self.space = pymunk.Space()
        self.space.gravity = setup.gravity
        fixed: list[pymunk.Shape] = [
            pymunk.Segment(self.space.static_body, (ax, ay), (bx, by), 0.0) for ax, ay, bx, by in setup.segments
        ]
        if setup.chained:
            count = len(setup.segments)
            for i in range(count):
                before, after = setup.segments[i - 1], setup.segments[(i + 1) % count]
                fixed[i].set_neighbors((before[0], before[1]), (after[2], after[3]))
        fixed += [pymunk.Circle(self.space.static_body, radius, (x, y)) for x, y, radius in setup.circles]
        self.bodies = []
        for position, velocity in zip(setup.position, setup.velocity, strict=True):
            body = pymunk.Body(1.0, inf)
            body.position = tuple(position)
            body.velocity = tuple(velocity)
            self.bodies.append(body)
        shapes = fixed + [pymunk.Circle(body, setup.radius) for body in self.bodies]
        for shape in shapes:
            shape.elasticity = each
            shape.friction = 0.0
        self.space.add(*self.bodies, *shapes)
        self.time_step = setup.time_step

    def step(self) -> None:
        """One step."""
        self.space.step(self.time_step)

    def state(self) -> tuple[Floats, Floats]:
        """Read body by body."""
        return np.array([body.position for body in self.bodies]), np.array([body.velocity for body in self.bodies])

    def first_ball(self) -> tuple[float, float]:
        """The body's position."""
        return self.bodies[0].position


class Box2d:
    """Box2D through pyb2d3: one substep, every bounce restituted, no sleep, no friction, one thread."""

    def __init__(self, setup: Setup) -> None:
        import pyb2d3

        self.world = pyb2d3.World(gravity=setup.gravity, restitution_threshold=0.0, maximum_linear_speed=1e6)
        self.world.sleeping_enabled = False
        material = pyb2d3.surface_material(restitution=setup.elasticity, friction=0.0)
        definition = pyb2d3.shape_def(material=material, density=1.0)
        fixed = self.world.create_static_body()
        if setup.chained:
            inwards = setup.segments[::-1, :2]  # a chain's solid side is on the left
            fixed.create_chain(pyb2d3.chain_def(inwards, material=material, is_loop=True))
        else:
            for ax, ay, bx, by in setup.segments:
                fixed.create_shape(definition, pyb2d3.segment((ax, ay), (bx, by)))
        for x, y, radius in setup.circles:
            fixed.create_shape(definition, pyb2d3.circle((x, y), radius))
        ball = pyb2d3.circle((0.0, 0.0), setup.radius)
        self.bodies: list[Any] = []
        for position, velocity in zip(setup.position, setup.velocity, strict=True):
            body = self.world.create_dynamic_body(
                position=tuple(position), linear_velocity=tuple(velocity), fixed_rotation=True
            )
            body.create_shape(definition, ball)
            self.bodies.append(body)
        self.time_step = setup.time_step

    def step(self) -> None:
        """One step."""
        self.world.step(self.time_step, 1)

    def state(self) -> tuple[Floats, Floats]:
        """Read body by body."""
        velocities = [body.linear_velocity for body in self.bodies]
        return np.array([body.position for body in self.bodies]), np.array(velocities)

    def first_ball(self) -> tuple[float, float]:
        """The body's position."""
        position = self.bodies[0].position
        return position.x, position.y


def continuous(setup: Setup) -> Engine:
    """The engine that is carom's continuous world."""
    return Carom(setup, "continuous")


#: The name of carom's continuous world among the engines.
CONTINUOUS = "carom, continuous"


def engines(with_continuous: bool = False) -> dict[str, Callable[[Setup], Engine]]:
    """The engines that can be run here, carom first."""
    found: dict[str, Callable[[Setup], Engine]] = {"carom": Carom}
    if with_continuous:
        found[CONTINUOUS] = continuous
    if importlib.util.find_spec("pymunk"):
        found["pymunk"] = Pymunk
    if importlib.util.find_spec("pyb2d3"):
        found["Box2D"] = Box2d
    return found
