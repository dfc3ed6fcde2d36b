"""What one may ask a world as it stands: rays, circles, neighbours, boxes, overlaps, and a pool player's line.

Every question can be asked once, or many times in one call with arrays of shape (n, 2), which one compiled loop
answers; a pair where others are arrays stands for all of them. No question changes the world.
"""

from __future__ import annotations

import warnings
from collections.abc import Sequence
from math import isfinite
from typing import TYPE_CHECKING, Any, TypeAlias, cast, overload

import numpy as np
from numpy.typing import NDArray

from carom import checks
from carom.compiler import door
from carom.compiler.kernels import Kernel
from carom.errors import InvalidArgument
from carom.rows.ball import ALL_LAYERS
from carom.rows.query import AIM, CAST_HIT, CONTACT, IN_BOX, NEIGHBOR, QUERY
from carom.rows.tables import Rows
from carom.shapes.aabb import Aabb
from carom.shapes.ball import Ball
from carom.spelling import spelled
from carom.turns import alone
from carom.typing import OnePair, Pairs, Vector
from carom.world.answers import Aim, Aims, CastHit, CastHits, Contacts, InBoxes, Neighbor, Neighbors
from carom.world.foresight import next_impacts, note_times
from carom.world.kernels.queries.aiming import aim_many
from carom.world.kernels.queries.casting import cast_many
from carom.world.kernels.queries.nearest import nearest_many
from carom.world.kernels.queries.overlapping import overlapping_many, overlaps_of_balls
from carom.world.kernels.queries.search_grid import width_of_all
from carom.world.search import Search
from carom.world.sizes import query_size, table_size

if TYPE_CHECKING:
    from carom.shapes.shape import Shape
    from carom.world.world import World

#: What a query sees: its `layer`, its `collides_with`, and whether it sees sensors.
Masks: TypeAlias = tuple[int, int, bool]

#: One number for each of many queries: an array of shape (n,), or a list.
Numbers: TypeAlias = NDArray[Any] | Sequence[float]

#: A box as it is taken: itself, or its left, bottom, right and top.
OneBox: TypeAlias = Aabb | tuple[float, float, float, float]

#: Many boxes: an array of shape (n, 4), or a list of boxes.
Boxes: TypeAlias = NDArray[Any] | Sequence[OneBox]


class Queries:
    """The questions that a `World` answers.

    All take `layer` and `collides_with`, which say what is seen: a shape or ball is, if its layer is in the query's
    `collides_with` and the query's `layer` in its own (both are all layers unless given). Sensors are seen only where
    `sensors` is True; what cannot collide is never seen.
    """

    _search: Search | None = None

    # -- rays and moving circles -------------------------------------------------------------------------------------

    @overload
    def ray_cast(
        self, origin: OnePair, target: OnePair, *, layer: int = ..., collides_with: int = ..., sensors: bool = ...
    ) -> CastHit | None: ...
    @overload
    def ray_cast(
        self,
        origin: Pairs,
        target: OnePair | Pairs,
        *,
        layer: int = ...,
        collides_with: int = ...,
        sensors: bool = ...,
    ) -> CastHits: ...
    @overload
    def ray_cast(
        self, origin: OnePair, target: Pairs, *, layer: int = ..., collides_with: int = ..., sensors: bool = ...
    ) -> CastHits: ...
    @spelled
    def ray_cast(
        self,
        origin: OnePair | Pairs,
        target: OnePair | Pairs,
        *,
        layer: int = ALL_LAYERS,
        collides_with: int = ALL_LAYERS,
        sensors: bool = False,
    ) -> CastHit | CastHits | None:
        """What the ray from `origin` to `target` hits first, or None; for arrays a `CastHits`.

        Segments, arcs and circles that are not solid are hit from both sides, a gate from its closed side alone. A ball
        or solid circle is hit from outside: a ray that starts inside does not see it. A ray that starts on a segment or
        perimeter hits it at once; points have no width and are never hit. Of two at the same place, the one that was
        added first is hit.

        Raises:
            InvalidArgument: `origin` or `target` is no pair or array of finite numbers, or their lengths differ.

        >>> import carom
        >>> world = carom.World()
        >>> wall = world.add(carom.Segment((4, -1), (4, 1)))
        >>> hit = world.ray_cast((0, 0), (8, 0))
        >>> hit.shape is wall, hit.fraction, hit.point, hit.normal
        (True, 0.5, (4.0, 0.0), (-1.0, 0.0))
        """
        return self._cast("origin", origin, 0.0, target, _masks(layer, collides_with, sensors))

    @overload
    def circle_cast(
        self,
        center: OnePair,
        radius: float,
        target: OnePair,
        *,
        layer: int = ...,
        collides_with: int = ...,
        sensors: bool = ...,
    ) -> CastHit | None: ...
    @overload
    def circle_cast(
        self,
        center: Pairs,
        radius: float | Numbers,
        target: OnePair | Pairs,
        *,
        layer: int = ...,
        collides_with: int = ...,
        sensors: bool = ...,
    ) -> CastHits: ...
    @overload
    def circle_cast(
        self,
        center: OnePair,
        radius: float | Numbers,
        target: Pairs,
        *,
        layer: int = ...,
        collides_with: int = ...,
        sensors: bool = ...,
    ) -> CastHits: ...
    @overload
    def circle_cast(
        self,
        center: OnePair,
        radius: Numbers,
        target: OnePair,
        *,
        layer: int = ...,
        collides_with: int = ...,
        sensors: bool = ...,
    ) -> CastHits: ...
    @spelled
    def circle_cast(
        self,
        center: OnePair | Pairs,
        radius: float | Numbers,
        target: OnePair | Pairs,
        *,
        layer: int = ALL_LAYERS,
        collides_with: int = ALL_LAYERS,
        sensors: bool = False,
    ) -> CastHit | CastHits | None:
        """What a circle moved from `center` to `target` touches first, or None; for arrays a `CastHits`.

        It moves as a ball does: points are touched, bare ends of segments and arcs are not, a gate stops it from the
        closed side. A circle that overlaps something at the start touches it there if it goes deeper, and not if it
        leaves. The point is where they touch; the circle's centre is then `fraction` of the way on.

        Args:
            center: Where the circle's centre starts, a pair or an array of shape (n, 2).
            radius: Its radius, positive; a number or an array of shape (n,).
            target: Where its centre is moved to.
            layer: As for all queries, see `Queries`.
            collides_with: Likewise.
            sensors: Likewise.

        Raises:
            InvalidArgument: Something is no finite number, `radius` is not positive, or lengths differ.
        """
        size = _sizes("radius", radius)
        return self._cast("center", center, size, target, _masks(layer, collides_with, sensors))

    @alone
    def _cast(
        self, name: str, start: Any, radius: float | NDArray[np.float64], target: Any, masks: Masks
    ) -> CastHit | CastHits | None:
        """The answer to casts of a radius from `start`, the argument `name`, to `target`."""
        from_, to = _pairs(name, start), _pairs("target", target)
        _check_lengths({name: from_, "radius": radius, "target": to})
        _check_distances(from_, to, target)
        queries, single = _queries(masks, from_, to, radius)
        rows, _ = self._casts(queries)
        hits = CastHits.of(self._world, rows)
        return hits._item(rows[0]) if single else hits

    def _casts(self, queries: Rows) -> tuple[Rows, Rows]:
        """The rows of what casts hit, and which items those are."""
        casts = np.zeros(len(queries), CAST_HIT)
        found = np.zeros(len(queries), "i4")
        self._ask(cast_many, len(queries), queries, casts, found)
        return casts, found

    # -- neighbours and boxes ----------------------------------------------------------------------------------------

    @overload
    def nearest(
        self, point: OnePair, *, layer: int = ..., collides_with: int = ..., sensors: bool = ...
    ) -> Neighbor | None: ...
    @overload
    def nearest(
        self, point: Pairs, *, layer: int = ..., collides_with: int = ..., sensors: bool = ...
    ) -> Neighbors: ...
    @spelled
    @alone
    def nearest(
        self,
        point: OnePair | Pairs,
        *,
        layer: int = ALL_LAYERS,
        collides_with: int = ALL_LAYERS,
        sensors: bool = False,
    ) -> Neighbor | Neighbors | None:
        """The shape or ball nearest to `point`, or None where none can be seen; for an array a `Neighbors`.

        Distances are those to the shape's `closest_point`, ends of segments and arcs included. Inside a ball or solid
        circle they are below 0, so a point in a ball is nearest to that ball. Of two as near, the one added first.

        Raises:
            InvalidArgument: `point` is no pair or array of finite numbers.

        >>> import carom
        >>> world = carom.World()
        >>> ball = world.add(carom.Ball((3, 4), radius=1))
        >>> world.nearest((0, 0)).distance, world.nearest((3, 4)).distance
        (4.0, -1.0)
        """
        queries, single = _queries(_masks(layer, collides_with, sensors), _pairs("point", point))
        rows = np.zeros(len(queries), NEIGHBOR)
        self._ask(nearest_many, len(queries), queries, rows)
        neighbors = Neighbors.of(self._world, rows)
        return neighbors._item(rows[0]) if single else neighbors

    @overload
    def overlapping(
        self, aabb: OneBox, *, layer: int = ..., collides_with: int = ..., sensors: bool = ...
    ) -> list[Shape | Ball]: ...
    @overload
    def overlapping(
        self, aabb: Boxes, *, layer: int = ..., collides_with: int = ..., sensors: bool = ...
    ) -> InBoxes: ...
    @spelled
    @alone
    def overlapping(
        self,
        aabb: OneBox | Boxes,
        *,
        layer: int = ALL_LAYERS,
        collides_with: int = ALL_LAYERS,
        sensors: bool = False,
    ) -> list[Shape | Ball] | InBoxes:
        """The shapes and balls that have a point in common with a box, in the order of their ids; touching counts.

        The shapes themselves count, not their boxes: a circle around the box does not, unless it is solid. For an array
        of shape (n, 4) (left, bottom, right, top), or a list of boxes, the answer is a structured array with a row
        for every box and shape that meet: `box`, the number of the box, and `shape`, an id.

        Raises:
            InvalidArgument: `aabb` is no box or array of boxes.
        """
        boxes, single = _boxes("aabb", aabb)
        queries, _ = _queries(_masks(layer, collides_with, sensors), boxes[:, :2], boxes[:, 2:])
        rows = np.zeros(len(boxes) + 16, IN_BOX)
        rows = self._ask_for_all(overlapping_many, len(queries), queries, rows)
        rows = rows[np.lexsort((rows["shape"], rows["box"]))]
        return (
            [self._world.object(int(member)) for member in rows["shape"]] if single else InBoxes.of(self._world, rows)
        )

    @spelled
    @alone
    def contacts(self, *, layer: int = ALL_LAYERS, collides_with: int = ALL_LAYERS, sensors: bool = False) -> Contacts:
        """Every overlap there is now of a ball with a shape or another ball, as a `Contacts` of `Contact` objects.

        They are what `shape.detect(ball)` says for each pair: masks hold between the two, a gate counts where it would
        stop the ball. Of two balls, the `shape` is the one that was added first. `layer` and `collides_with` leave out
        pairs of which one is not seen.

        >>> import carom
        >>> world = carom.World()
        >>> floor = world.add(carom.Segment((0, 0), (10, 0)))
        >>> ball = world.add(carom.Ball((5, 0.25), radius=0.5))
        >>> [(contact.shape is floor, contact.setback) for contact in world.contacts()]
        [(True, 0.25)]
        """
        queries, _ = _queries(_masks(layer, collides_with, sensors), (0.0, 0.0))
        count = self._world._arrays.balls.count
        rows = np.zeros(count + 16, CONTACT)
        rows = self._ask_for_all(overlaps_of_balls, count, queries, rows)
        return Contacts.of(self._world, rows[np.lexsort((rows["shape"], rows["ball"]))])

    @spelled
    def overlaps(self, *, layer: int = ALL_LAYERS, collides_with: int = ALL_LAYERS, sensors: bool = False) -> Contacts:
        """What `contacts` returns; its old name, which the next release will not have."""
        warnings.warn("World.overlaps() is called World.contacts() now", DeprecationWarning, stacklevel=3)
        return self.contacts(layer=layer, collides_with=collides_with, sensors=sensors)

    # -- a pool player's line ----------------------------------------------------------------------------------------

    @overload
    def aim(self, ball: Ball, direction: OnePair | None = None) -> Aim | None: ...
    @overload
    def aim(self, ball: Ball, direction: Pairs) -> Aims: ...
    @overload
    def aim(self, ball: Sequence[Ball] | NDArray[np.int64], direction: OnePair | Pairs | None = None) -> Aims: ...
    @spelled
    @alone
    def aim(
        self, ball: Ball | Sequence[Ball] | NDArray[np.int64], direction: OnePair | Pairs | None = None
    ) -> Aim | Aims | None:
        """The path of a ball up to its next impact and where both go then, or None if it meets nothing.

        Without a direction, which the continuous mode allows, that is the film's own next impact: what `step` will say,
        to the bit, with gravity, friction and all that moves. With one it is a pool player's line, which is straight.

        It meets what it would meet in a step (masks hold, sensors do not count, a gate stops it from the closed side),
        however far away. Everything else is taken to be at rest, and the ball to come with the velocity `direction`:
        its length matters to nothing but the speeds afterwards, and to the kick of a bumper. Neither gravity nor
        friction acts.

        Args:
            ball: A ball of this world; or a list of balls, or an array of ids of shape (n,).
            direction: Where it is shot, a pair that is not (0, 0); or an array of shape (n, 2). None for as it flies.

        Raises:
            InvalidArgument: `ball` is no ball of this world; `direction` is (0, 0) or off numbers, or None if discrete.

        >>> import carom
        >>> world = carom.World()
        >>> cue, object_ball = world.add(carom.Ball((0, 0), radius=1)), world.add(carom.Ball((10, 0), radius=1))
        >>> line = world.aim(cue, (1, 0))
        >>> line.shape is object_ball, line.ghost, line.direction, line.other_direction
        (True, (8.0, 0.0), None, (1.0, 0.0))
        """
        indices = self._indices(ball)
        if direction is None:
            foreseen = Aims.of(self._world, next_impacts(self._world, np.atleast_1d(indices)))
            return foreseen if isinstance(indices, np.ndarray) else foreseen._item(foreseen.view(np.ndarray)[0])
        ways = _pairs("direction", direction)
        _check_lengths({"ball": indices, "direction": ways})
        if not np.any(ways, axis=-1).all():
            raise checks.refuse("direction", "must not be (0, 0)", direction)
        single = not (isinstance(indices, np.ndarray) or isinstance(ways, np.ndarray))
        rows = np.broadcast_arrays(np.atleast_1d(indices)[:, None], np.atleast_2d(ways))
        indices, ways = rows[0][:, 0].copy(), rows[1].copy()
        queries = self._shots(indices, ways)
        if not np.isfinite(queries["to_x"] + queries["to_y"]).all():
            raise checks.refuse("ball", "must be at a finite place", ball)
        casts, found = self._casts(queries)
        aims = Aims.of(self._world, np.zeros(len(queries), AIM))
        arrays = self._world._arrays
        total, tables = bool(arrays.states[0]["total_restitution"]), (arrays.shapes.used, arrays.balls.used)
        door.load(aim_many, table_size)(queries, casts, found, indices, ways, *tables, total, aims.view(np.ndarray))
        note_times(aims.view(np.ndarray), ways, self._world.time)
        return aims._item(aims.view(np.ndarray)[0]) if single else aims

    def _indices(self, ball: Any) -> int | NDArray[np.int64]:
        """The row of a ball, or those of several."""
        table = self._world._arrays.balls
        if isinstance(ball, Ball):
            if ball.world is not self:
                raise checks.refuse("ball", "must be in this world", ball)
            return table.index(ball)
        if isinstance(ball, np.ndarray) and ball.ndim == 1 and (ball.dtype.kind in "iu" or ball.size == 0):
            ids = table.used["id"]
            if not np.isin(ball, ids).all():
                raise checks.refuse("ball", "must hold ids of balls in this world", ball)
            return np.searchsorted(ids, ball)
        if isinstance(ball, Sequence) and all(isinstance(one, Ball) for one in ball):
            return np.array([self._indices(one) for one in ball], np.int64)
        raise checks.refuse("ball", "must be a Ball, a list of balls or an array of ids", ball)

    def _shots(self, indices: NDArray[np.int64], ways: NDArray[np.float64]) -> Rows:
        """The casts of balls in directions, so long that they leave everything behind."""
        arrays = self._world._arrays
        width = door.load(width_of_all, table_size)(arrays.shapes.used, arrays.balls.used)
        balls, queries = arrays.balls.used[indices], np.zeros(len(indices), QUERY)
        queries["x"], queries["y"], queries["radius"] = balls["x"], balls["y"], balls["radius"]
        # A ball that collides with nothing, or is a sensor, is stopped by nothing.
        solid = (balls["can_collide"] != 0) & (balls["sensor"] == 0)
        queries["layer"], queries["collides_with"] = balls["layer"] * solid, balls["collides_with"]
        units = ways / np.abs(ways).max(axis=1, keepdims=True)
        units *= width / np.sqrt((units * units).sum(axis=1, keepdims=True))
        queries["to_x"], queries["to_y"] = queries["x"] + units[:, 0], queries["y"] + units[:, 1]
        return queries

    # -- asking ------------------------------------------------------------------------------------------------------

    @property
    def _world(self) -> World:
        """The world that is asked: this object."""
        return cast("World", self)

    def _ask(self, kernel: Kernel, count: int, queries: Rows, *answers: Rows) -> int:
        """What a kernel says to some queries, which look around `count` times; it writes to `answers`."""
        arrays = self._world._arrays
        if self._search is None or not self._search.is_of(arrays):
            self._search = Search(arrays)
        grids, stamps = self._search.grids(count), self._search.stamps()
        return int(
            door.load(kernel, query_size)(queries, arrays.shapes.used, arrays.balls.used, *grids, stamps, *answers)
        )

    def _ask_for_all(self, kernel: Kernel, count: int, queries: Rows, rows: Rows) -> Rows:
        """The rows that a kernel finds for queries; it is asked again where it needs more of them than in `rows`."""
        wanted = self._ask(kernel, count, queries, rows)
        if wanted > len(rows):
            rows = np.zeros(wanted, rows.dtype)
            self._ask(kernel, count, queries, rows)
        return rows[:wanted]


def _pairs(name: str, value: Any) -> Vector | NDArray[np.float64]:
    """The pair of an argument, or its pairs as an array of shape (n, 2)."""
    try:
        many = np.ndim(value) > 1 or (isinstance(value, (list, np.ndarray)) and np.size(value) == 0)
    except ValueError:
        raise checks.refuse(name, "must be a pair of numbers or an array of shape (n, 2)", value) from None
    return checks.array(name, value, (-1, 2)) if many else checks.pair(name, value)


def _boxes(name: str, value: Any) -> tuple[NDArray[np.float64], bool]:
    """The boxes of an argument as an array of shape (n, 4), and whether it was one box."""
    try:
        given = (
            value if isinstance(value, np.ndarray) else [tuple(box) if isinstance(box, Aabb) else box for box in value]
        )
        numbers = np.asarray(given, np.float64)
    except (TypeError, ValueError):
        raise checks.refuse(name, "must be an Aabb, four numbers, a list of those or an array", value) from None
    if numbers.shape == (4,):
        return np.array([tuple(Aabb(*given))]), True
    boxes = checks.array(name, numbers, (-1, 4))
    if (boxes[:, 0] > boxes[:, 2]).any() or (boxes[:, 1] > boxes[:, 3]).any():
        raise checks.refuse(name, "must have left <= right and bottom <= top", value)
    return boxes, False


def _sizes(name: str, value: Any) -> float | NDArray[np.float64]:
    """The positive number of an argument, or its numbers as an array of shape (n,)."""
    if isinstance(value, (Sequence, np.ndarray)) and not isinstance(value, str):
        return checks.array(name, value, (-1,), above=0.0)
    return checks.positive(name, value)


def _check_lengths(arguments: dict[str, Any]) -> None:
    """Raise where two of the arguments are arrays of different lengths."""
    lengths = {name: len(value) for name, value in arguments.items() if isinstance(value, np.ndarray)}
    if len(set(lengths.values())) > 1:
        (first, count), *others = lengths.items()
        name, other = next(item for item in others if item[1] != count)
        raise InvalidArgument(f"{name} must be one or as many as {first}, {count}, not {other}")


def _check_distances(start: Any, end: Any, target: object) -> None:
    """Raise where a target is infinitely far away."""
    if isinstance(start, tuple) and isinstance(end, tuple):
        near = isfinite(end[0] - start[0]) and isfinite(end[1] - start[1])
    else:
        with np.errstate(over="ignore"):
            near = bool(np.isfinite(np.subtract(end, start)).all())
    if not near:
        raise checks.refuse("target", "must not be infinitely far away", target)


def _queries(
    masks: Masks, start: Any, end: Any = (0.0, 0.0), radius: float | NDArray[np.float64] = 0.0
) -> tuple[Rows, bool]:
    """The queries that parts make, each one for all or an array, and whether they make one."""
    given = [part for part in (start, end, radius) if isinstance(part, np.ndarray)]
    if not given:
        return np.array([(*start, *end, radius, *masks)], QUERY), True
    queries = np.zeros(len(given[0]), QUERY)
    queries["x"], queries["y"] = np.transpose(start)
    queries["to_x"], queries["to_y"] = np.transpose(end)
    queries["radius"] = radius
    queries["layer"], queries["collides_with"], queries["sensors"] = masks
    return queries, False


def _masks(layer: object, collides_with: object, sensors: object) -> Masks:
    """What a query sees, checked."""
    seen = checks.layers("layer", layer), checks.layers("collides_with", collides_with)
    return *seen, checks.flag("sensors", sensors)
