"""`Task`: what an environment is, as one frozen description that files hold and environments are made from."""

from __future__ import annotations

import os
from collections.abc import Iterator
from pathlib import Path
from typing import Annotated, Any, Self

from pydantic import BaseModel, BeforeValidator, ValidationError

from carom.errors import SceneError, TaskError
from carom.rl.descriptors import Actuator, Count, End, Observation, Reward, Spread
from carom.rl.names import Names
from carom.rows.shape import KINEMATIC
from carom.scene import Scene, scenes
from carom.scene.descriptor import Descriptor
from carom.scene.faults import Faults, fault_below
from carom.scene.fields import Positive, Text, Version, as_tuple
from carom.scene.files import Plain, read_plain, write_plain
from carom.shapes.compound import Compound
from carom.world.world import World

VERSION = 1


def _scene(value: Any) -> Any:
    """The scene that a name, a file, a table or a world stands for; anything else as it is, for the field to judge."""
    try:
        if isinstance(value, World):
            return Scene.from_world(value)
        if isinstance(value, dict):
            return Scene(**value)
        if isinstance(value, str) and not Path(value).suffix:
            return scenes.by_name(value)
        if isinstance(value, (str, os.PathLike)):
            return Scene.load(value)
    except SceneError as error:
        raise fault_below("", str(error)) from None
    return value


class Task(Descriptor):
    """What an environment for agents is: a scene, how it is acted on, seen, scored and ended, and where it starts.

    `Task(scene=…, actuators=[…], …)` takes descriptors and tables as they stand in a file. The scene may be given as
    such, by the name of a shipped one or of a file, or as a world, which it then copies. A mistake raises `TaskError`,
    which lists every fault with its path.
    """

    version: Version
    """The version of the file's form: 1."""
    name: Text | None = None
    """What the task is called."""
    scene: Annotated[Scene, BeforeValidator(_scene)]
    """The scene in which it is to be done."""
    actuators: Annotated[tuple[Actuator, ...], BeforeValidator(as_tuple)]
    """What an action does: one number for each, or two for an impulse."""
    observation: Observation = Observation()
    """What the agent sees."""
    reward: Reward = Reward()
    """What a step is worth."""
    end: End = End()
    """When an episode is over."""
    start: Annotated[tuple[Spread, ...], BeforeValidator(as_tuple)] = ()
    """How far from the scene's state an episode may start."""
    dt: Positive = 1 / 60
    """Seconds of a step of the world."""
    steps: Count = 1
    """How many such steps there are to each action."""

    def __init__(self, /, **fields: Any) -> None:
        self._fill({"version": VERSION} | fields)

    def _fill(self, table: Plain) -> None:
        """Set the fields to what `table` holds, or raise `TaskError` with all that is wrong in it."""
        faults = Faults(type(self))
        try:
            BaseModel.__init__(self, **table)
        except ValidationError as error:
            faults.add(error)
        else:
            for path, words in _misfits(self):
                faults.add_words(path, words)
        if faults.count:
            raise TaskError(str(faults.error()))

    @property
    def seconds(self) -> float:
        """Seconds of the world's time from one action to the next."""
        return self.steps * self.dt

    @classmethod
    def load(cls, path: str | os.PathLike[str]) -> Self:
        """The task in a `.toml` or `.json` file; one that names its scene's file names it from its own folder.

        Raises `TaskError` with the file's name and every fault in it.
        """
        try:
            table = read_plain(path)
        except SceneError as error:
            raise TaskError(str(error)) from None
        scene = table.get("scene")
        if isinstance(scene, str) and Path(scene).suffix:
            table["scene"] = str(Path(path).parent / scene)
        task = cls.__new__(cls)
        try:
            task._fill(table)
        except TaskError as error:
            raise TaskError(f"{os.fspath(path)}: {error}") from None
        return task

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write a `.toml` or `.json` file that loads as the same task, with its scene in it.

        The file is complete or as it was before, whatever happens. Raises `TaskError` where it cannot be written.
        """
        try:
            write_plain(path, self.plain())
        except SceneError as error:
            raise TaskError(str(error)) from None


def _misfits(task: Task) -> Iterator[tuple[str, str]]:
    """What of a task does not fit its scene: path and words of each fault."""
    world = task.scene.build()
    if len(world.balls) == 0:
        yield "scene.balls", "must hold a ball"
        return
    names = Names(world)
    if not task.actuators:
        yield "actuators", "must be at least one"
    if len({_is_continuous(actuator) for actuator in task.actuators}) > 1:
        yield "actuators", "must all have `speeds` to choose from, or none of them"
    for place, actuator in enumerate(task.actuators):
        yield from _undrivable(f"actuators[{place}]", actuator, names)
    yield from _meaningless(task, names)


def _is_continuous(actuator: Actuator) -> bool:
    """Whether an actuator takes any number from -1 to 1, rather than one of several values."""
    return actuator.kind == "impulse" or actuator.speed is not None


def _undrivable(path: str, actuator: Actuator, names: Names) -> Iterator[tuple[str, str]]:
    """Why an actuator cannot drive what it names, if it cannot."""
    if actuator.kind == "impulse":
        count = names.balls.count(actuator.ball)
        if count != 1:
            yield f"{path}.ball", f"must be the name of one ball, not that of {count}: {actuator.ball!r}"
        return
    found = [names.shapes[index] for index in names.bearers(actuator.shape)]
    if len(found) != 1:
        said = f"must be the name of one shape or compound, not that of {len(found)}: {actuator.shape!r}"
        yield f"{path}.shape", said
    elif not isinstance(found[0], Compound) and found[0].motion != KINEMATIC:
        yield f"{path}.shape", f"must be that of a compound or a kinematic shape, not {actuator.shape!r}"


def _meaningless(task: Task, names: Names) -> Iterator[tuple[str, str]]:
    """Expressions that mean nothing in the scene: misspelt ones, as a rule."""
    observation, end = task.observation, task.end
    balls = {"observation.balls": observation.balls}
    movers = {"observation.turning": observation.turning, "observation.travelling": observation.travelling}
    hit = {"observation.lights": observation.lights, "end.drain": end.drain, "end.cleared": end.cleared}
    for place, points in enumerate(task.reward.points):
        hit[f"reward.points[{place}].shapes"] = points.shapes
        balls[f"reward.points[{place}].balls"] = points.balls
    balls |= {f"start[{place}].balls": spread.balls for place, spread in enumerate(task.start)}
    kinds = (
        (balls, names.balls_like, "ball"),
        (movers, names.shapes_like, "shape"),
        (hit, lambda pattern: names.columns_like(pattern).any(), "shape"),
    )
    for patterns, bearers, what in kinds:
        for path, pattern in patterns.items():
            if pattern is not None and not bearers(pattern):
                yield path, f"must mean a {what} of the scene, not {pattern!r}"
