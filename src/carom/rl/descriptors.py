"""What a task is made of, as pydantic models: actuators, observation, reward, end and start.

They are checked as a scene's are; whether they fit a scene is for the task to check, which has one. Shapes and balls
are chosen by regular expressions that match the whole of a name; a part without a name goes by its compound's, what
has none by "".
"""

from __future__ import annotations

import re
from math import pi
from typing import TYPE_CHECKING, Annotated, Any, Literal, Self

from pydantic import AfterValidator, BaseModel, BeforeValidator, Field, ValidationError, model_validator
from pydantic_core import PydanticCustomError

from carom.draw.parts.frame import LEAST_SIDE, MOST_SIDE
from carom.errors import TaskError
from carom.scene.descriptor import Descriptor
from carom.scene.faults import Faults, fault_below, shortened
from carom.scene.fields import NonNegative, Positive, Text, Vector, as_pair, as_tuple


def _expression(text: str) -> str:
    """`text`, unless it is no regular expression."""
    try:
        re.compile(text)
    except re.error as error:
        must = "must be a regular expression, not {value}: {why}"
        raise PydanticCustomError("pattern", must, {"value": shortened(text), "why": str(error)}) from None
    return text


def _extent(pair: tuple[float, float]) -> tuple[float, float]:
    """`pair`, unless one of its numbers is negative."""
    if min(pair) < 0.0:
        raise PydanticCustomError("extent", "must not be negative, not {value}", {"value": pair})
    return pair


Pattern = Annotated[str, AfterValidator(_expression)]
Extent = Annotated[Vector, AfterValidator(_extent)]
Count = Annotated[int, Field(ge=1)]
Side = Annotated[int, Field(ge=LEAST_SIDE, le=MOST_SIDE)]
Size = Annotated[tuple[Side, Side], BeforeValidator(as_pair)]
Speeds = Annotated[tuple[float, ...], BeforeValidator(as_tuple)]


class TaskPart(Descriptor):
    """A part of a task; a mistake in one that is made alone raises `TaskError`, with every fault."""

    if not TYPE_CHECKING:  # type checkers know the fields

        def __init__(self, /, **fields: Any) -> None:
            try:
                BaseModel.__init__(self, **fields)
            except ValidationError as error:
                raise refused(type(self), error) from None

        # So that pydantic makes the parts of a whole as ever, and gives each fault in them its path.
        __init__.__pydantic_base_init__ = True


def refused(model: type[BaseModel], error: ValidationError) -> TaskError:
    """The error to raise for what pydantic found in a `model`."""
    faults = Faults(model)
    faults.add(error)
    return TaskError(str(faults.error()))


class _Driver(TaskPart):
    """What drives a shape or compound at speeds that the action chooses."""

    shape: Text
    """The name of a compound, or of a kinematic shape."""
    speeds: Speeds = ()
    """The speed that each value of the action gives it: the first for 0, and so on."""
    speed: Positive | None = None
    """Instead of `speeds`: the speed for the action 1; -1 is as much the other way, and all between is between."""

    @model_validator(mode="after")
    def _has_one_of_both(self) -> Self:
        """The descriptor itself, unless it says its speeds twice or not at all."""
        if (len(self.speeds) == 0) == (self.speed is None):
            raise fault_below(".speeds", "must be given, or `speed`, and not both")
        if len(self.speeds) == 1:
            raise fault_below(".speeds", f"must be two or more, not {self.speeds}")
        return self

    @property
    def top_speed(self) -> float:
        """The greatest speed that it is driven at."""
        return self.speed if self.speed is not None else max(map(abs, self.speeds))


class Turn(_Driver):
    """Turns a shape or compound about its pivot; speeds in rad/s."""

    kind: Literal["turn"] = "turn"


class Travel(_Driver):
    """Moves a shape or compound along a straight line; speeds in length/s."""

    kind: Literal["travel"] = "travel"
    direction: Vector = (1.0, 0.0)
    """Which way; of any length but 0."""
    limits: Vector | None = None
    """How far it can go from where it starts, back (0 or less) and forth (0 or more)."""

    @model_validator(mode="after")
    def _can_go(self) -> Self:
        """The descriptor itself, unless there is no way to go."""
        if self.direction == (0.0, 0.0):
            raise fault_below(".direction", f"must not be zero, not {self.direction}")
        if self.limits is not None and not self.limits[0] <= 0.0 <= self.limits[1]:
            raise fault_below(".limits", f"must hold 0, not {self.limits}")
        return self


class Impulse(TaskPart):
    """Adds to a ball's velocity what two numbers say, x and y, each from -1 to 1, together no longer than 1."""

    kind: Literal["impulse"] = "impulse"
    ball: Text
    """The name of the ball."""
    speed: Positive
    """What a vector of length 1 adds, in length/s."""


Actuator = Annotated[Turn | Travel | Impulse, Field(discriminator="kind")]


class Observation(TaskPart):
    """What the agent sees: a list of numbers from -1 to 1, or pixels.

    The numbers are, in this order: of each ball x and y, its velocity in x and y, and, where there are several, whether
    it is in play (1 or 0; the others are 0 for one that is not); of each turning shape its orientation, from its lower
    stop to its upper one, or sine and cosine where it has none, and how fast it turns; of each travelling shape x and y
    and its velocity; of each light whether it was hit since the start (1 or 0). Places go from one side of the box
    around all shapes to the other, speeds of shapes to the fastest that an actuator drives them; what is beyond is cut.
    """

    balls: Pattern | None = ".*"
    """Whose places and velocities are seen, by name."""
    speed: Positive | None = None
    """The ball's speed that is 1; by default the world's `max_speed`, or the box's longer side in a second."""
    turning: Pattern | None = None
    """The shapes and compounds whose orientation and angular velocity are seen."""
    travelling: Pattern | None = None
    """The shapes and compounds whose position and velocity are seen."""
    lights: Pattern | None = None
    """The shapes that light up when a ball bounces off them or comes into them; all of one name are one light."""
    pixels: Size | None = None
    """Instead of all that: width and height of a picture of the world, seen as (height, width, 3) bytes."""


class Points(TaskPart):
    """Points for every bounce off shapes, or for coming into sensors."""

    shapes: Pattern
    """The names of the shapes."""
    points: float
    """The points; negative ones are a loss."""
    balls: Pattern = ".*"
    """The names of the balls that score."""
    once: bool = False
    """Whether each ball can have these points only once in an episode."""


class Reward(TaskPart):
    """What a step is worth: the sum of all this."""

    points: Annotated[tuple[Points, ...], BeforeValidator(as_tuple)] = ()
    """For bounces and entries; those of all entries that a shape is meant by are added."""
    second: float = 0.0
    """For each second of the world's time."""
    lost: float = 0.0
    """For each ball that is lost."""


class End(TaskPart):
    """When an episode is over: when no ball is left in play, and for the reasons here, whichever comes first."""

    drain: Pattern | None = None
    """The shapes in which a ball is lost: it is taken out of play when it meets them."""
    bounds: bool = True
    """Whether a ball whose centre leaves the world's bounds is lost."""
    cleared: Pattern | None = None
    """The shapes that end it when all of them were hit; all of one name count as one."""
    actions: Count | None = None
    """How many actions there are."""
    seconds: Positive | None = None
    """How long it is cut off after, in seconds of the world's time: `truncated`, where all else is `terminated`."""


class Spread(TaskPart):
    """How far from the scene's state balls may start: each number evenly spread, drawn anew for every episode."""

    balls: Pattern = ".*"
    """The names of the balls."""
    position: Extent = (0.0, 0.0)
    """How far off in x and y, either way."""
    velocity: Extent = (0.0, 0.0)
    """How far off the velocity is in x and y, either way, in length/s."""
    angle: Annotated[NonNegative, Field(le=pi)] = 0.0
    """How far the velocity is turned, either way, in radians; before `velocity` is added."""
