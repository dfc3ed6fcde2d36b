"""The exceptions of carom: one family, so that one `except` clause can catch them all."""

from collections.abc import Sequence
from typing import Any


class CaromError(Exception):
    """Base of every exception that carom raises on purpose.

    `hits` are those of the steps that `World.run` made before the one that failed; None from anywhere else.
    """

    hits: Any = None


class InvalidArgument(CaromError, ValueError):
    """An argument, attribute or setting was refused; the message names it and its value."""


class UnknownName(InvalidArgument, AttributeError, TypeError):
    """No option, argument or attribute of this name can be given; the message says which was meant, or which there are.

    It is an `AttributeError` and a `TypeError` too, for these are what Python raises for unknown names.
    """


class SceneError(CaromError, ValueError):
    """A scene was refused; the message lists every fault with its path."""


class DrawingWarning(UserWarning):
    """A drawing holds what no scene has, such as text and images: it was left out, and the message says what it was."""


class LettersWarning(UserWarning):
    """Raster pictures have other letters than SVG ones, for want of fonts; the message says what brings them."""


class SnapshotError(CaromError, ValueError):
    """A snapshot was damaged, cut, or not made by this library."""


class RecordingError(CaromError, ValueError):
    """A recording was refused: damaged, cut, not made by this library, or of parts that do not fit each other."""


class NonFiniteState(CaromError, ValueError):
    """A world's state holds NaN or infinity; the message names the balls."""


class ImpactLimit(CaromError, RuntimeError):
    """A ball has reached `max_impacts` in a step of the continuous mode, which ended there; the world is whole.

    Attributes:
        balls: The ids of the balls that have reached it.
        time: The world's time, at which the step ended.
        hits: Those of the step until then, or of the run.
    """

    def __init__(self, message: str = "", balls: Sequence[int] = (), time: float = 0.0) -> None:
        super().__init__(message)
        self.balls = list(balls)
        self.time = time


class WorldBusy(CaromError, RuntimeError):
    """A world was stepped, changed or asked while it was in use, by another thread or by what called this."""


class LostObject(CaromError, LookupError):
    """A hit or an answer names what is not at hand: it left the world for good, or the world was not pickled along."""


class MissingExtra(CaromError, ImportError):
    """A package is not installed; the message says what needs it, and what to install."""


class CompileError(CaromError, RuntimeError):
    """Kernels were to be compiled and kept, and cannot be; the message says why."""


class SweepError(CaromError, RuntimeError):
    """A sweep cannot begin or go on; the message says why. What is in its ledger is kept."""


class TaskError(CaromError, ValueError):
    """A task for agents was refused; the message lists every fault with its path."""
