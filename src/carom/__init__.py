"""carom: exact, fast 2D collisions. A library of shapes and contacts, and worlds that step them.

Lengths are in one unit of your choosing, angles in radians counterclockwise from +x, times in seconds; y points up.
Positions and vectors are taken as any pair of numbers and come back as tuples of floats. Every exception that carom
raises on purpose is a `CaromError`; one for bad input is an `InvalidArgument`, which is a `ValueError` too.

>>> import carom
>>> wall = carom.Segment((0, 0), (10, 0), elasticity=0.5)
>>> ball = carom.Ball((5, 0.25), radius=0.5, velocity=(3, -2))
>>> ball.respond(wall.detect(ball))
>>> ball.velocity
(3.0, 1.0)
"""

from importlib import import_module
from typing import TYPE_CHECKING, Any

from carom.errors import (
    CaromError,
    CompileError,
    ImpactLimit,
    InvalidArgument,
    LostObject,
    MissingExtra,
    NonFiniteState,
    RecordingError,
    SceneError,
    SnapshotError,
    SweepError,
    TaskError,
    UnknownName,
    WorldBusy,
)
from carom.rows.shape import Motion
from carom.shapes.aabb import Aabb
from carom.shapes.arc import Arc
from carom.shapes.ball import Ball
from carom.shapes.circle import Circle
from carom.shapes.compound import Compound
from carom.shapes.detection import Contact
from carom.shapes.gate import Gate
from carom.shapes.group import Group
from carom.shapes.helpers import angle_to_vector, normalize, normalize_angle, parallel_component, perp, rotate_point
from carom.shapes.line import Line
from carom.shapes.point import Point
from carom.shapes.segment import Segment
from carom.shapes.shape import Shape

if TYPE_CHECKING:
    from carom import draw, study
    from carom.compiler.child import compiling
    from carom.record import Recorder, Recording
    from carom.scene import Scene, scenes
    from carom.shapes import outlines
    from carom.shapes.guard import guard_points
    from carom.world import Aim, CastHit, HitKind, Hits, Neighbor, World
    from carom.world.ahead import compile
    from carom.worlds import Worlds

__version__ = "0.1.0"

__all__ = [
    "Aabb",
    "Aim",
    "Arc",
    "Ball",
    "CaromError",
    "CastHit",
    "Circle",
    "CompileError",
    "Compound",
    "Contact",
    "Gate",
    "Group",
    "HitKind",
    "Hits",
    "ImpactLimit",
    "InvalidArgument",
    "Line",
    "LostObject",
    "MissingExtra",
    "Motion",
    "Neighbor",
    "NonFiniteState",
    "Point",
    "Recorder",
    "Recording",
    "RecordingError",
    "Scene",
    "SceneError",
    "Segment",
    "Shape",
    "SnapshotError",
    "SweepError",
    "TaskError",
    "UnknownName",
    "World",
    "WorldBusy",
    "Worlds",
    "__version__",
    "angle_to_vector",
    "compile",
    "compiling",
    "draw",
    "guard_points",
    "normalize",
    "normalize_angle",
    "outlines",
    "parallel_component",
    "perp",
    "rotate_point",
    "scenes",
    "study",
]

#: Names that cost time to import (a compiler, a validator), each with the module that it is imported from when used.
_LAZY = {
    "Aim": "carom.world",
    "CastHit": "carom.world",
    "HitKind": "carom.world",
    "Hits": "carom.world",
    "Neighbor": "carom.world",
    "World": "carom.world",
    "Worlds": "carom.worlds",
    "compile": "carom.world.ahead",
    "compiling": "carom.compiler.child",
    "Recorder": "carom.record",
    "Recording": "carom.record",
    "Scene": "carom.scene",
    "scenes": "carom.scene",
    "guard_points": "carom.shapes.guard",
}

#: Modules that are imported when used, each by its full name, so that `import carom` is enough.
_LAZY_MODULES = {"draw": "carom.draw", "outlines": "carom.shapes.outlines", "study": "carom.study"}


if not TYPE_CHECKING:  # type checkers would take any name where they see this

    def __getattr__(name: str) -> Any:
        """A lazy name's value, imported now; called for names that this module does not have."""
        if name not in _LAZY and name not in _LAZY_MODULES:
            raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
        if name in _LAZY_MODULES:
            value = import_module(_LAZY_MODULES[name])
        else:
            value = getattr(import_module(_LAZY[name]), name)
        globals()[name] = value
        return value


def __dir__() -> list[str]:
    """The public names, the lazy ones too."""
    return sorted(__all__)
