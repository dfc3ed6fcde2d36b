"""The settings of a world: each is validated when set, and kept in the world's state."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any, Generic, Literal, TypeAlias, TypeVar, overload

from numpy.typing import NDArray

from carom import checks
from carom.errors import InvalidArgument
from carom.limits import MOST_IMPACTS, MOST_ITERATIONS, MOST_LEVELS, MOST_SUBSTEPS, REASONS
from carom.rows.state import StateRow
from carom.shapes.aabb import Aabb
from carom.turns import having
from carom.typing import BroadPhase, Detection, Pair, Restitution, Vector

if TYPE_CHECKING:
    from carom.world.world import World

#: What a setting gives back, and what it takes.
T = TypeVar("T")
S = TypeVar("S")
W = TypeVar("W", bound=str)

DETECTIONS: tuple[Detection, ...] = ("discrete", "continuous")
BROAD_PHASES: tuple[BroadPhase, ...] = ("brute", "grid", "quadtree")
RESTITUTIONS: tuple[Restitution, ...] = ("normal", "total")

#: What bounds may be given as: a box, or its left, bottom, right and top.
Sides: TypeAlias = Aabb | Sequence[float] | NDArray[Any]

NONE = -1.0

#: The fields of the state that are a setting each.
Field: TypeAlias = Literal[
    "detection", "substeps", "iterations", "broad_phase", "levels", "total_restitution", "friction", "sleep_speed",
    "sleep_time", "rest_speed", "max_speed", "max_impacts", "remove_strays",
]  # fmt: skip


class Setting(Generic[T, S]):
    """An attribute of `World` that checks a value, then writes it into the state's row, and reads it from there.

    Its default is that of the keyword argument of `World`. One `of_flights` says how balls fly: when it is changed, all
    begin new flights.
    """

    def __init__(
        self,
        check: Callable[[str, Any], T],
        write: Callable[[StateRow, T], None],
        read: Callable[[StateRow], T],
        doc: str,
        of_flights: bool = False,
    ) -> None:
        self.check = check
        self._write = write
        self._read = read
        self.__doc__ = doc
        self._of_flights = of_flights

    def __set_name__(self, owner: type, name: str) -> None:
        self.name = name

    @overload
    def __get__(self, world: None, owner: type) -> Setting[T, S]: ...
    @overload
    def __get__(self, world: World, owner: type) -> T: ...
    def __get__(self, world: World | None, owner: type) -> Any:
        if world is None:
            return self
        return self._read(world._states[0])

    def __set__(self, world: World, value: S) -> None:
        having(world, self._set, world, self.check(self.name, value))

    def _set(self, world: World, value: T) -> None:
        """Write a value that was checked into the state of a world."""
        state: Any = world._states[0]
        before = state.tobytes()
        self._write(state, value)
        if state.tobytes() != before:
            world._changed_all(self._of_flights)


def plain(
    field: Field,
    check: Callable[[str, Any], T],
    read: Callable[[Any], T],
    doc: str,
    written: Callable[[T], Any] = lambda value: value,
    of_flights: bool = False,
) -> Setting[T, T]:
    """A setting that is one field of the state, with how its value is checked, read and, unless as it is, written."""

    def write(state: StateRow, value: T) -> None:
        state[field] = written(value)

    return Setting(check, write, lambda state: read(state[field]), doc, of_flights)


def optional(
    field: Field, check: Callable[[str, Any], float], doc: str, of_flights: bool = False
) -> Setting[float | None, float | None]:
    """A setting that is one number or None."""
    return plain(
        field,
        lambda name, value: None if value is None else check(name, value),
        lambda number: None if number < 0.0 else float(number),
        doc,
        lambda value: NONE if value is None else value,
        of_flights,
    )


def count(field: Field, most: int, doc: str) -> Setting[int, int]:
    """A setting that is a whole number of at least 1."""
    return plain(field, lambda name, value: checks.whole(name, value, 1, most, REASONS[name]), int, doc)


def limit(field: Field, most: int, doc: str) -> Setting[int | None, int | None]:
    """A setting that is a whole number of at least 1, or None."""
    return plain(
        field,
        lambda name, value: None if value is None else checks.whole(name, value, 1, most, REASONS[name]),
        lambda number: None if number == 0 else int(number),
        doc,
        lambda value: 0 if value is None else value,
    )


def choice(field: Field, words: tuple[W, ...], doc: str, of_flights: bool = False) -> Setting[W, W]:
    """A setting that is one of several words."""
    check: Callable[[str, Any], W] = lambda name, value: checks.one_of(name, value, words)  # noqa: E731
    return plain(field, check, words.__getitem__, doc, words.index, of_flights)


def vector(doc: str) -> Setting[Vector, Pair]:
    """A setting that is a pair of numbers."""

    def write(state: StateRow, value: Vector) -> None:
        state["gravity_x"], state["gravity_y"] = value

    return Setting(checks.pair, write, lambda state: (float(state["gravity_x"]), float(state["gravity_y"])), doc, True)


def box(doc: str) -> Setting[Aabb | None, Sides | None]:
    """A setting that is a box or None."""

    def check(name: str, value: Any) -> Aabb | None:
        if value is None or isinstance(value, Aabb):
            return value
        needed = "must be an Aabb, four numbers or None"
        if isinstance(value, (str, bytes, dict, set, frozenset)):
            raise checks.refuse(name, needed, value)
        try:
            left, bottom, right, top = value
        except (TypeError, ValueError):
            raise checks.refuse(name, needed, value) from None
        try:
            return Aabb(left, bottom, right, top)
        except InvalidArgument as error:
            raise InvalidArgument(f"{name}: {error}") from None

    def write(state: StateRow, value: Aabb | None) -> None:
        sides = (0.0, 0.0, 0.0, 0.0) if value is None else (value.left, value.bottom, value.right, value.top)
        state["bounded"] = value is not None
        state["left"], state["bottom"], state["right"], state["top"] = sides

    def read(state: StateRow) -> Aabb | None:
        if not state["bounded"]:
            return None
        return Aabb(float(state["left"]), float(state["bottom"]), float(state["right"]), float(state["top"]))

    return Setting(check, write, read, doc, True)


class Settings:
    """The settings of a world, each an attribute that can be changed while the world runs."""

    gravity = vector("Acceleration (x, y) of all balls, in length/s².")
    detection: Setting[Detection, Detection] = choice(
        "detection",
        DETECTIONS,
        "How collisions are found. `continuous`: times of impact, dealt with in their order; nothing tunnels, paths are"
        " exact. `discrete`: overlaps, looked for after moving; fast, and fast balls may tunnel.",
        of_flights=True,
    )
    substeps = count(
        "substeps", MOST_SUBSTEPS, "Motion iterations per step (discrete; without effect in the continuous mode)."
    )
    iterations = count(
        "iterations",
        MOST_ITERATIONS,
        "Collision iterations per substep at most (discrete; without effect in the continuous mode).",
    )
    broad_phase: Setting[BroadPhase, BroadPhase] = choice(
        "broad_phase", BROAD_PHASES, "How pairs are found; all find the same pairs, faster or slower."
    )
    levels = count("levels", MOST_LEVELS, "Levels of the quadtree, the root included.")
    restitution: Setting[Restitution, Restitution] = choice(
        "total_restitution",
        RESTITUTIONS,
        "What elasticity scales: the normal velocity, or all of it (`total`; static and kinematic shapes).",
    )
    friction = plain(
        "friction",
        checks.non_negative,
        float,
        "Deceleration of every ball that has no friction of its own, in length/s².",
        of_flights=True,
    )
    sleep_speed = plain(
        "sleep_speed", checks.non_negative, float, "Speed below which a ball may fall asleep.", of_flights=True
    )
    sleep_time = plain(
        "sleep_time", checks.non_negative, float, "Seconds below `sleep_speed` before a ball sleeps.", of_flights=True
    )
    rest_speed = optional(
        "rest_speed",
        checks.non_negative,
        "Speed of approach below which an inelastic contact comes to rest; by default twice what gravity adds in a"
        " substep, or, continuous, where a ball that something presses on would rebound by less than a thousandth of"
        " its radius.",
        of_flights=True,
    )
    max_speed = optional("max_speed", checks.positive, "A faster ball is slowed to this after a response.")
    max_impacts = limit(
        "max_impacts",
        MOST_IMPACTS,
        "Impacts of a ball in a step at most (continuous): there the step ends with an `ImpactLimit`. By default there"
        " is no limit.",
    )
    bounds = box("Left, bottom, right and top of a box; a ball wholly outside of it is a stray.")
    remove_strays = plain(
        "remove_strays",
        checks.flag,
        bool,
        "Whether strays are removed when the step ends; in the continuous mode they meet nothing once they have left.",
        of_flights=True,
    )


SETTINGS: tuple[str, ...] = tuple(name for name, value in vars(Settings).items() if isinstance(value, Setting))
