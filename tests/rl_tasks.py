"""Small tasks for tests of environments, and the slow twin of one: plain Python round one `World`."""

import re
from math import cos, sin, sqrt
from typing import Any

import numpy as np

import carom
from carom.rl import End, Impulse, Observation, Points, Reward, Spread, Task, Travel, Turn
from carom.world.hits import HitKind

SIDE = 10.0


def yard(balls: int = 2) -> carom.Scene:
    """A room with everything that a task may speak of, and some balls in it."""
    corners = [(0.0, 0.0), (SIDE, 0.0), (SIDE, SIDE), (0.0, SIDE)]
    walls: list[Any] = [carom.Segment(corners[k - 1], corners[k], name="wall") for k in (0, 2, 3)]
    flipper = carom.Compound(
        [carom.Circle((2.0, 2.0), 0.3, solid=True), carom.Segment((2.0, 2.3), (4.0, 2.3), name="blade")],
        pivot=(2.0, 2.0),
        turn_limits=(-0.2, 0.8),
        name="flipper",
    )
    return carom.Scene(
        world={"gravity": (0.0, -9.0), "substeps": 1, "bounds": (-1.0, -1.0, 11.0, 11.0)},
        shapes=[
            *walls,
            flipper,
            carom.Segment((5.0, 1.0), (7.0, 1.0), motion="kinematic", name="paddle"),
            carom.Compound([carom.Segment((4.2, 6.0), (5.8, 6.0))], (5.0, 6.0), angular_velocity=3.0, name="spinner"),
            carom.Circle((2.5, 6.5), 0.8, solid=True, kick=2.0, name="bumper 1"),
            carom.Circle((7.5, 6.5), 0.8, solid=True, once=True, name="brick 1"),
            carom.Circle((7.5, 4.0), 0.5, solid=True, once=True, name="brick 2"),
            carom.Segment((0.0, 0.2), (4.0, 0.2), sensor=True, name="drain"),
        ],
        balls=[
            carom.Ball((3.0 + 2.5 * k, 8.5), 0.3, velocity=(1.5 - k, -3.0), name=f"ball {k + 1}") for k in range(balls)
        ],
    )


def yard_task(balls: int = 2, **changes: Any) -> Task:
    """A task in the yard that uses all that there is."""
    given: dict[str, Any] = {
        "scene": yard(balls),
        "actuators": [Turn(shape="flipper", speeds=(-9.0, 12.0)), Travel(shape="paddle", speeds=(-6.0, 0.0, 6.0))],
        "observation": Observation(turning="flipper|spinner", travelling="paddle", lights="bumper.*|brick.*|spinner"),
        "reward": Reward(
            points=(
                Points(shapes="bumper.*|blade", points=1.5),
                Points(shapes="brick.*|bumper 1", points=4.0, balls="ball 1"),
                Points(shapes="spinner", points=-0.25, once=True),
            ),
            second=0.1,
            lost=-3.0,
        ),
        "end": End(drain="drain", cleared="brick.*", seconds=1.0),
        "start": [Spread(position=(0.6, 0.4), angle=0.5), Spread(balls="ball 1", velocity=(2.0, 1.0))],
        "dt": 1 / 30,
        "steps": 2,
    }
    return Task(**given | changes)


def shot_task(**changes: Any) -> Task:
    """A task of continuous actions: a stroke, and a flipper."""
    given: dict[str, Any] = {
        "actuators": [Impulse(ball="ball 1", speed=5.0), Turn(shape="flipper", speed=8.0)],
        "observation": Observation(balls="ball 1"),
        "end": End(actions=4),
        "start": [Spread(position=(1.0, 0.5))],
        "steps": 3,
    }
    return yard_task(2, **given | changes)


def drop_task(**changes: Any) -> Task:
    """A ball that drops past a paddle into a drain: episodes of a few steps, the longest of which are cut off."""
    given: dict[str, Any] = {
        "scene": carom.Scene(
            world={"gravity": (0.0, -9.0), "substeps": 1},
            shapes=[
                carom.Segment((2.0, 1.0), (4.0, 1.0), motion="kinematic", name="paddle"),
                carom.Segment((-4.0, 0.0), (4.0, 0.0), sensor=True, name="drain"),
            ],
            balls=[carom.Ball((0.0, 2.0), 0.3, velocity=(0.5, 0.0), name="ball")],
        ),
        "actuators": [Travel(shape="paddle", speeds=(-8.0, 0.0, 8.0), limits=(-4.0, 1.0))],
        "observation": Observation(travelling="paddle"),
        "reward": Reward(points=(Points(shapes="paddle", points=1.0),), lost=-1.0),
        "end": End(drain="drain", seconds=0.7),
        "start": [Spread(position=(1.0, 1.5))],
        "dt": 0.05,
    }
    return Task(**given | changes)


class NaiveEnv:
    """What a `TaskEnv` is to be, for the tasks above, number by number; copy `k` of those that a seed makes."""

    def __init__(self, task: Task, seed: int, copy: int = 0) -> None:
        self.task = task
        children = np.random.SeedSequence(seed).spawn(copy + 1)
        self.random = np.random.Generator(np.random.PCG64(children[copy]))

    def reset(self) -> list[float]:
        """Begin anew; the observation."""
        self.world = self.task.scene.build()
        self.shapes = {shape.name: shape for shape in self.world.shapes}
        self.balls = list(self.world.balls)
        self.in_play = [True] * len(self.balls)
        self.hit: set[str] = set()
        self.scored: set[tuple[int, int]] = set()
        self.actions = 0
        for spread in self.task.start:
            chosen = [ball for ball in self.balls if re.fullmatch(spread.balls, ball.name or "")]
            for ball, drawn in zip(chosen, self.random.uniform(-1.0, 1.0, (len(chosen), 5)), strict=True):
                x, y, turn, vx, vy = map(float, drawn)
                ball.position = ball.position[0] + x * spread.position[0], ball.position[1] + y * spread.position[1]
                c, s = cos(turn * spread.angle), sin(turn * spread.angle)
                along, beside = ball.velocity
                ball.velocity = (
                    c * along - s * beside + vx * spread.velocity[0],
                    s * along + c * beside + vy * spread.velocity[1],
                )
        return self.observation()

    def step(self, action: Any) -> tuple[list[float], float, bool, bool]:
        """Observation, reward, terminated and truncated."""
        task = self.task
        values = list(np.atleast_1d(action))
        for actuator in task.actuators:
            if isinstance(actuator, Impulse):
                x, y = (min(max(float(values.pop(0)), -1.0), 1.0) for _ in range(2))
                ball = next(ball for ball in self.balls if ball.name == actuator.ball)
                scale = actuator.speed / max(sqrt(x * x + y * y), 1.0)
                if self.in_play[self.balls.index(ball)]:
                    ball.velocity = ball.velocity[0] + x * scale, ball.velocity[1] + y * scale
                continue
            value = values.pop(0)
            speed = actuator.speeds[value] if actuator.speeds else float(value) * (actuator.speed or 0.0)
            if isinstance(actuator, Turn):
                self.shapes[actuator.shape].angular_velocity = speed
            else:
                self.shapes[actuator.shape].velocity = (speed, 0.0)
        hits = [hit for hit in self.world.run(task.steps * task.dt, task.dt) if hit.kind != HitKind.EXIT]
        self.actions += 1
        points, lost = 0.0, set()
        for hit in hits:
            name = self.name_of(hit.shape)
            number = self.balls.index(hit.ball)
            self.hit.add(name)
            points += sum(p.points for p in task.reward.points if not p.once and self.meant(p, hit))
            if task.end.drain and re.fullmatch(task.end.drain, name):
                lost.add(number)
        reward = task.reward.second * (task.steps * task.dt) + points
        for place, rule in enumerate(task.reward.points):
            scorers = {self.balls.index(hit.ball) for hit in hits if rule.once and self.meant(rule, hit)}
            new = {(place, ball) for ball in scorers} - self.scored
            self.scored |= new
            reward += rule.points * len(new)
        left, bottom, right, top = task.scene.world.bounds or (-np.inf, -np.inf, np.inf, np.inf)
        for number, ball in enumerate(self.balls):
            if self.in_play[number]:
                x, y = ball.position
                outside = task.end.bounds and (x < left or x > right or y < bottom or y > top)
                if outside or number in lost:
                    self.in_play[number] = False
                    reward += task.reward.lost
        return self.observation(), reward, self.terminated(), self.truncated()

    def take_out(self) -> None:
        """Take the balls that were lost out of the world, which goes on with the others."""
        for number, ball in enumerate(self.balls):
            if not self.in_play[number] and ball.world is not None and any(self.in_play):
                self.world.remove(ball)

    def terminated(self) -> bool:
        """Whether the episode is over."""
        end = self.task.end
        left = {
            self.name_of(part)
            for shape in self.world.shapes
            for part in (shape.shapes if isinstance(shape, carom.Compound) else [shape])
            if end.cleared and re.fullmatch(end.cleared, self.name_of(part))
        } - self.hit
        cleared = end.cleared is not None and not left
        return not any(self.in_play) or cleared or (end.actions is not None and self.actions >= end.actions)

    def truncated(self) -> bool:
        """Whether it is cut off."""
        end = self.task.end
        return end.seconds is not None and self.actions >= round(end.seconds / (self.task.steps * self.task.dt))

    def meant(self, rule: Points, hit: Any) -> bool:
        """Whether a rule gives points for a hit."""
        is_shape = not isinstance(hit.shape, carom.Ball)
        return bool(
            is_shape and re.fullmatch(rule.shapes, self.name_of(hit.shape)) and re.fullmatch(rule.balls, hit.ball.name)
        )

    def name_of(self, shape: Any) -> str:
        """The name of a shape, or of its compound."""
        compound = getattr(shape, "compound", None)
        return shape.name or (compound.name if compound else "") or ""

    def observation(self) -> list[float]:
        """What is seen, for the box of the yard."""
        seen = self.task.observation
        numbers: list[float] = []
        chosen = [number for number, ball in enumerate(self.balls) if re.fullmatch(seen.balls or "-", ball.name or "")]
        for number in chosen:
            (x, y), (vx, vy) = self.balls[number].position, self.balls[number].velocity
            half = SIDE / 2.0
            there = [(x - half) / half, (y - half) / half, vx / SIDE, vy / SIDE, 1.0][: 5 if len(chosen) > 1 else 4]
            numbers += [one * self.in_play[number] for one in np.array(there, np.float32)]
        if seen.turning:
            flipper, spinner = self.shapes["flipper"], self.shapes["spinner"]
            numbers += [(2.0 * flipper.orientation - (-0.2 + 0.8)) / 1.0, flipper.angular_velocity / 12.0]
            numbers += [sin(spinner.orientation), cos(spinner.orientation), spinner.angular_velocity / 3.0]
        if seen.travelling:
            (x, y), (vx, vy) = self.shapes["paddle"].position, self.shapes["paddle"].velocity
            numbers += [(x - SIDE / 2.0) / (SIDE / 2.0), (y - SIDE / 2.0) / (SIDE / 2.0), vx / 6.0, vy / 6.0]
        if seen.lights:
            numbers += [float(name in self.hit) for name in ("spinner", "bumper 1", "brick 1", "brick 2")]
        return [float(number) for number in np.clip(np.array(numbers, np.float32), -1.0, 1.0)]
