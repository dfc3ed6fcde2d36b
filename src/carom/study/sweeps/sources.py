"""What is run: a scene with values set by path, or what a function makes of the parameters; and what a seed does.

A seed is handed to a function that takes one: `parameters["seed"]` of a user's function, the argument `seed` of a
shipped scene that has it. All other scenes it spreads: the start of every ball is moved by up to `SPREAD` of its radius
along each axis, evenly, so that runs differ as the tries of a careful hand do.
"""

from __future__ import annotations

import inspect
import os
from dataclasses import dataclass
from functools import cached_property, lru_cache
from itertools import pairwise
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from carom.errors import InvalidArgument
from carom.scene import Scene, scenes
from carom.spelling import hint
from carom.study.sweeps.grid import SEED
from carom.study.sweeps.paths import Steps, check_values, is_path, places_of, refuse_path, with_values
from carom.study.sweeps.references import function_of, is_reference, reference_of, source_text
from carom.study.sweeps.values import text_of

if TYPE_CHECKING:
    from collections.abc import Sequence

    from carom.study.sweeps.grid import Run

#: How far a seed moves the start of a ball along each axis at most, in its radii.
SPREAD = 1e-3
#: Where the shipped scenes are.
SHIPPED = "carom.scene.shipped:"


@dataclass(frozen=True)
class Source:
    """A scene, or the reference of the function that makes one for each run."""

    scene: Scene | None
    function: str

    @property
    def is_shipped(self) -> bool:
        """Whether the function is that of a shipped scene, whose arguments go by keyword."""
        return self.function.startswith(SHIPPED)

    @cached_property
    def arguments(self) -> tuple[str, ...]:
        """The names of a shipped scene's arguments."""
        return tuple(inspect.signature(function_of(self.function)).parameters) if self.is_shipped else ()

    @property
    def identity(self) -> Any:
        """What tells this from other scenes, as plain values."""
        if self.scene is not None:
            return self.scene.plain()
        return [self.function, "" if self.is_shipped else source_text(self.function)]

    def of(self, run: Run) -> Scene:
        """The scene of a run; raises what the function raises, or `SceneError`."""
        paths = {name: value for name, value in run.parameters.items() if is_path(name)}
        scene = self._base(run)
        scene = with_values(
            scene, [(steps, value) for name, value in paths.items() for steps in places_of(scene, name)]
        )
        return scene if run.seed is None or self.is_seeded else spread(scene, run.seed)

    @property
    def is_seeded(self) -> bool:
        """Whether the function takes a seed; else seeds spread the balls."""
        return self.scene is None and (not self.is_shipped or SEED in self.arguments)

    def likeness(self, run: Run) -> str | None:
        """What is the same in all runs whose scenes differ from that of `run` only in where balls are and how fast.

        None where that cannot be told: a function of the user's may make anything of the parameters.
        """
        if self.scene is None and not self.is_shipped:
            return None
        try:
            scene = self._base(run)
            shared = {name: value for name, value in run.parameters.items() if not _is_motion(scene, name)}
        except Exception:  # noqa: BLE001  # the run will say what is wrong
            return None
        return text_of({**shared, SEED: run.seed} if self.is_seeded else shared)

    def _base(self, run: Run) -> Scene:
        """The scene of a run before values are set by path."""
        if self.scene is not None:
            return self.scene
        own = {name: value for name, value in run.given.items() if not is_path(name)}
        if self.is_shipped:
            return _shipped(self.function, text_of({name: own[name] for name in own if name in self.arguments}))
        made = function_of(self.function)(run.given)
        if not isinstance(made, Scene):
            raise TypeError(f"{self.function} must return a Scene, not a {type(made).__name__}")
        return made

    def check(self, runs: Sequence[Run]) -> None:
        """Raise `InvalidArgument` for a parameter that leads nowhere, or a value that cannot stand there."""
        names = list(runs[0].parameters)
        if self.scene is None and not self.is_shipped:
            return  # the function says which names it knows
        for name in names:
            if not is_path(name) and name not in self.arguments:
                said = hint(name, self.arguments)
                raise InvalidArgument(f"parameters: {name}: is unknown; {said}") if said else refuse_path(name)
        if any(not is_path(name) for name in names):
            return  # each run has a scene of its own
        scene = self._base(runs[0])
        places = {name: places_of(scene, name) for name in names}
        _check_apart([steps for found in places.values() for steps in found])
        for name, found in places.items():
            values = {text_of(run.parameters[name]): run.parameters[name] for run in runs}
            check_values(scene, name, found, values.values())


def source_of(given: Any) -> Source:
    """The source that the argument `scene` of a sweep means: a scene, a file, a shipped name or a function.

    Raises:
        InvalidArgument: It is nothing of the kind, or cannot be imported.
        SceneError: The file holds no good scene.
    """
    if isinstance(given, Scene):
        return Source(given, "")
    name = given if isinstance(given, str) else getattr(given, "__name__", None)
    if name in scenes.__all__ and (isinstance(given, str) or given is getattr(scenes, name)):
        return Source(None, f"{SHIPPED}{name}")
    if isinstance(given, (str, os.PathLike)) and not (isinstance(given, str) and is_reference(given)):
        if isinstance(given, str) and not Path(given).exists():
            said = hint(given, scenes.__all__) or f"shipped are {', '.join(scenes.__all__)}"
            raise InvalidArgument(f"scene {given!r}: no such file, and no shipped scene of that name; {said}")
        return Source(Scene.load(given), "")
    return Source(None, reference_of("scene", given))


def _is_motion(scene: Scene, name: str) -> bool:
    """Whether a parameter sets nothing but places or velocities of balls."""
    return is_path(name) and all(
        steps[0] == "balls" and steps[2] in ("position", "velocity") for steps in places_of(scene, name)
    )


@lru_cache(maxsize=8)
def _shipped(function: str, arguments: str) -> Scene:
    """A shipped scene with some arguments, which are written as JSON."""
    import json

    made: Scene = function_of(function)(**json.loads(arguments))
    return made


def spread(scene: Scene, seed: int) -> Scene:
    """A scene whose balls start off their places, by up to `SPREAD` of their radii along each axis."""
    moved = np.random.default_rng(seed).random((len(scene.balls), 2)).tolist()
    balls = []
    for ball, (right, up) in zip(scene.balls, moved, strict=True):
        x, y = ball.position
        far = SPREAD * ball.radius
        place = (x + far * (2.0 * right - 1.0), y + far * (2.0 * up - 1.0))
        balls.append(ball.model_copy(update={"position": place}))
    return scene.model_copy(update={"balls": tuple(balls)})


def _check_apart(places: list[Steps]) -> None:
    """Raise `InvalidArgument` where two parameters set the same field, or one a part of what another sets."""
    for one, next_one in pairwise(sorted(places, key=lambda steps: [str(step) for step in steps])):
        if next_one[: len(one)] == one:
            raise InvalidArgument(f"parameters: two of them set {'.'.join(map(str, one))}")
