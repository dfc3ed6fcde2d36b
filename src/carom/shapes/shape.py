"""What points, segments, gates, circles and arcs have in common: a surface, a pose, and motion on rails."""

from __future__ import annotations

import inspect
from typing import TYPE_CHECKING, Any, ClassVar, Literal, TypeAlias, TypedDict, Unpack

import numpy as np

from carom.checks import flag, layers, non_negative, pair, text_or_none
from carom.rows.ball import ALL_LAYERS
from carom.rows.pose import derive, set_initial
from carom.rows.shape import SHAPE, Motion, ShapeRow
from carom.shapes.aabb import Aabb
from carom.shapes.detection import Contact, detect_shape
from carom.shapes.mover import Geometry, Mover
from carom.shapes.rails import write_angular_velocity, write_motion, write_rotating, write_turn_limits, write_velocity
from carom.shapes.table import put_fields
from carom.turns import setting
from carom.typing import MotionName, Pair

if TYPE_CHECKING:
    from carom.shapes.ball import Ball


#: What a compound may say for all parts about their surface.
Surface: TypeAlias = Literal["elasticity", "kick", "sensor", "can_collide", "once", "layer", "collides_with"]


class ShapeOptions(TypedDict, total=False):
    """The keyword arguments that every shape takes: `Shape` has their meaning, `Shape._fill` their defaults."""

    elasticity: float
    kick: float
    sensor: bool
    can_collide: bool
    once: bool
    layer: int
    collides_with: int
    motion: MotionName | Motion
    pivot: Pair | None
    angular_velocity: float
    rotating: bool
    turn_limits: Pair | None
    velocity: Pair
    name: str | None
    user: Any


class Shape(Mover):
    """Base of every shape that is no ball.

    All shapes take these keyword arguments, and have them as attributes:

    - `elasticity=1.0`, `kick=0.0` (a speed added along the normal at every bounce, in length/s), `sensor=False`,
      `can_collide=True`, `once=False` (whether it switches `can_collide` off at its first bounce, as a drop target),
      `layer=1`, `collides_with=` all layers;
    - `motion="static"` or `"kinematic"`, and for kinematic shapes `pivot=None` (default: `position`),
      `angular_velocity=0.0` (rad/s), `rotating=True` (whether that acts), `turn_limits=None` (or `(low, high)`, radians
      of orientation with 0 between them), `velocity=(0, 0)` (of the pivot and the shape with it, in length/s);
    - `name=None`, `user=None` (anything of the user's).

    Setting any geometry, `pivot` included, makes the shape as it stands then the initial one, of orientation 0. Where
    and how a part of a compound moves is set on the compound. A mistake raises `InvalidArgument`, which names the
    argument and its value, before anything has changed.
    """

    __slots__ = ()

    __signature__: ClassVar[inspect.Signature]

    def __init_subclass__(cls) -> None:
        """Spell the options of every shape out in the subclass's signature, for `help` and for tests."""
        super().__init_subclass__()
        if cls.__init__ is object.__init__:  # what shapes of more than one kind derive from
            return
        own = list(inspect.signature(cls.__init__).parameters.values())[1:]
        if own and own[-1].kind is inspect.Parameter.VAR_KEYWORD:
            taken = {parameter.name for parameter in own}
            common = list(inspect.signature(Shape._fill).parameters.values())[2:]
            own[-1:] = [parameter for parameter in common if parameter.name not in taken]
        cls.__signature__ = inspect.Signature(own)

    # -- construction ------------------------------------------------------------------------------------------------

    def _create(self, name: str, value: object, options: ShapeOptions, **geometry: Unpack[Geometry]) -> None:
        """Finish the construction of a shape from the fields of its own geometry.

        Raises `InvalidArgument`, with argument `name` and its `value` to blame, where that geometry is impossible.
        """
        row: ShapeRow = np.zeros(1, SHAPE)[0]
        row["kind"] = self._KIND
        put_fields(row, geometry)
        derive(row)
        self._check(row, name, value)
        label, user = self._fill(row, **options)
        set_initial(row)
        self._begin(row, label, user)

    def _fill(
        self,
        row: ShapeRow,
        *,
        elasticity: float = 1.0,
        kick: float = 0.0,
        sensor: bool = False,
        can_collide: bool = True,
        once: bool = False,
        layer: int = 1,
        collides_with: int = ALL_LAYERS,
        motion: MotionName | Motion = "static",
        pivot: Pair | None = None,
        angular_velocity: float = 0.0,
        rotating: bool = True,
        turn_limits: Pair | None = None,
        velocity: Pair = (0.0, 0.0),
        name: str | None = None,
        user: Any = None,
    ) -> tuple[str | None, Any]:
        """The checked name and the user's own; writes all other options to a row whose geometry is settled."""
        row["elasticity"] = non_negative("elasticity", elasticity)
        row["kick"] = non_negative("kick", kick)
        row["sensor"] = flag("sensor", sensor)
        row["can_collide"] = flag("can_collide", can_collide)
        row["once"] = flag("once", once)
        row["layer"] = layers("layer", layer)
        row["collides_with"] = layers("collides_with", collides_with)
        row["pivot_x"], row["pivot_y"] = (row["cx"], row["cy"]) if pivot is None else pair("pivot", pivot)
        write_motion(row, motion)
        write_rotating(row, rotating)
        write_angular_velocity(row, angular_velocity)
        write_turn_limits(row, turn_limits)
        write_velocity(row, velocity)
        return text_or_none("name", name), user

    # -- surface -----------------------------------------------------------------------------------------------------

    @property
    def kick(self) -> float:
        """The speed that it adds along the normal at every approach that bounces, in length/s; 0 or more."""
        return float(self._row["kick"])

    @kick.setter
    @setting
    def kick(self, value: float) -> None:
        self._put("kick", non_negative("kick", value))

    @property
    def once(self) -> bool:
        """Whether it switches `can_collide` off at its first bounce; setting that anew arms it again."""
        return bool(self._row["once"])

    @once.setter
    @setting
    def once(self, value: bool) -> None:
        self._put("once", flag("once", value))

    @property
    def aabb(self) -> Aabb:
        """The smallest box around it."""
        row = self._row
        return Aabb(float(row["left"]), float(row["bottom"]), float(row["right"]), float(row["top"]))

    def detect(self, ball: Ball) -> Contact | None:
        """The contact with `ball` where they overlap, or None; see `Contact`.

        A shape that is no gate knows no past here: a ball beyond a segment's end or outside an arc's sector is a miss,
        any other overlap a contact. A gate yields one where the ball's centre is on its closed side and the ball
        approaches. The shape's motion counts in the contact's speed. Raises `InvalidArgument` for what is no ball.
        """
        return detect_shape(self, ball)
