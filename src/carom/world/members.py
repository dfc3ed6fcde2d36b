"""What a world holds: its shapes and balls, how they come in and leave, and what it knows of changes from outside."""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Callable, Sequence
from contextlib import suppress
from operator import attrgetter
from typing import TYPE_CHECKING, Any, TypeVar, cast, overload

import numpy as np
from numpy.typing import ArrayLike, NDArray

from carom import checks
from carom.compiler.block import Block
from carom.compiler.kernels import Kernel
from carom.errors import InvalidArgument
from carom.rows.ball import ALL_LAYERS, BALL, OF_WORLD
from carom.rows.relation import NO_RELATION
from carom.rows.shape import BALL_KIND, KINEMATIC, ShapeRow
from carom.rows.state import CHANGED, MOTIONS_CHANGED, STALE, STATE, StateRow
from carom.rows.tables import Rows, Table
from carom.shapes.ball import Ball
from carom.shapes.compound import Compound
from carom.shapes.group import Group
from carom.shapes.shape import Shape
from carom.spelling import spelled
from carom.turns import Turn, alone
from carom.world.departed import Departed
from carom.world.entering import entering, leaving
from carom.world.hits import NO_ROWS, Hits
from carom.world.link import Link
from carom.world.removal import remove_rows
from carom.world.search import Search
from carom.world.tables import Arrays
from carom.world.views import Balls, Shapes, see_lent
from carom.world.waking import begin_anew, will_wake

if TYPE_CHECKING:
    from carom.world.world import World

#: Of more that leave together the list is made anew, which then is quicker than to take each out of it.
MOST_UNLISTED = 64

#: What is listed by its id, which ascends in the order of adding.
ID = attrgetter("id")

R = TypeVar("R")
T = TypeVar("T", bound=Shape | Ball | Compound | Group)
T2 = TypeVar("T2", bound=Shape | Ball | Compound | Group)
T3 = TypeVar("T3", bound=Shape | Ball | Compound | Group)
T4 = TypeVar("T4", bound=Shape | Ball | Compound | Group)

NO_BALLS: Rows = np.zeros(0, BALL)

#: The word of a state, one of 32 bits, that says whether something was changed.
WAKE = STATE.fields["wake"][1] // 4  # type: ignore[index]

#: The word, one of 64 bits, that says whether the kinematic shapes have moved.
MOVING_STALE = STATE.fields["moving_stale"][1] // 8  # type: ignore[index]


class Members:
    """The shapes and balls of a `World`: the objects, and the rows that they are views of."""

    _arrays: Arrays
    _states: Table[StateRow]
    _halves: memoryview[int]
    _words: memoryview[int]
    _search: Search | None

    @property
    def _world(self) -> World:
        """The world that this is the part of."""
        return cast("World", self)

    def _forget_objects(self) -> None:
        """Begin with no objects at all."""
        self._objects: dict[int, Shape | Ball] = {}
        self._added: dict[int, Shape | Compound | Group] = {}
        self._listed: list[Shape | Compound | Group] = []
        self._departed = Departed()
        self._removed: list[Rows] = []
        self._left: Rows = NO_BALLS
        self._block: Block | None = None
        self._quick: tuple[Kernel, int] | None = None
        self._dt = -1.0
        self._lent: Rows | None = None
        self._turn = Turn()
        self._watcher: int | None = None
        self._link = Link(self._world)
        self._no_hits = Hits.of(self._world, NO_ROWS)

    # -- what is in it -----------------------------------------------------------------------------------------------

    @property
    def shapes(self) -> Shapes:
        """The shapes in the order in which they were added."""
        return Shapes(self._world)

    @property
    def balls(self) -> Balls:
        """The balls in the order in which they were added, and their columns as NumPy views."""
        return Balls(self._world)

    @property
    def strays(self) -> list[Ball]:
        """The balls that lie wholly outside `bounds`; with `remove_strays`, those that the last step or run removed.

        In the continuous mode the latter are where they left, by more than rounding: a billionth of their radius.
        """
        if self._world.remove_strays:
            found = [self._object_of_hit(int(ball), self._left) for ball in self._left["id"]]
            return [ball for ball in found if isinstance(ball, Ball)]
        rows = self._arrays.balls.used
        return (
            [self._ball_of(int(ball)) for ball in rows["id"][rows["stray"] != 0]]
            if self._world.bounds is not None
            else []
        )

    @overload
    def add(self, shape: T, /) -> T: ...
    @overload
    def add(self, shape: T, second: T2, /) -> tuple[T, T2]: ...
    @overload
    def add(self, shape: T, second: T2, third: T3, /) -> tuple[T, T2, T3]: ...
    @overload
    def add(self, shape: T, second: T2, third: T3, fourth: T4, /) -> tuple[T, T2, T3, T4]: ...
    @overload
    def add(self, *shapes: T) -> tuple[T, ...]: ...
    @alone
    def add(self, *shapes: Any) -> Any:
        """What was given, now in the world: shapes, compounds, groups and balls, from here on views of their rows here.

        One comes back as it is, several as a tuple, in the order in which they were given and have been added.

        Raises:
            InvalidArgument: One of them is no shape or ball, or is in a world already, or is part of a compound or
                group that is not, or stands there twice. None has been added then.
        """
        self._take_in(shapes)
        return shapes[0] if len(shapes) == 1 else shapes

    def _take_in(self, shapes: Sequence[Any]) -> None:
        """Make rows and objects of what comes in; raises where something may not."""
        members = entering(self, shapes)
        see_lent(self._world)
        first = self._arrays.shape_table.count
        self._enter([member for each in members for member in each])
        for shape, each in zip(shapes, members, strict=True):
            if isinstance(shape, Group):
                shape._tie()
            if isinstance(shape, Compound | Group) or (isinstance(shape, Shape) and shape._whole is None):
                self._added[each[0].id or 0] = shape
                self._listed.append(shape)
        if shapes:
            self._arrays.note_come(first)
            come = self._arrays.shape_table.used["motion"][first:]
            self._rearrange(MOTIONS_CHANGED if (come == KINEMATIC).any() else CHANGED)

    def _take_part(self, shape: Shape) -> None:
        """Take in a shape that has become part of a whole which is here; it is listed no more, if it was."""
        if shape.world is None:
            self._take_in((shape,))
        else:
            self._unlist(shape.id or 0, 1)
        if shape.group is not None:
            shape.group._tie()

    def _list(self) -> list[Shape | Compound | Group]:
        """What was added, in that order, which is that of ids: a list that is made anew only after much has left."""
        if len(self._listed) != len(self._added):
            self._listed = list(self._added.values())
        return self._listed

    def _unlist(self, member_id: int, leaving: int) -> None:
        """List what has an id no more, if it is, of so many that leave together; its parts have their ids yet."""
        listed = self._listed
        if len(listed) == len(self._added) and leaving <= MOST_UNLISTED:
            if member_id in self._added:
                del listed[bisect_left(listed, member_id, key=ID)]
        else:
            self._listed = []
        self._added.pop(member_id, None)

    def _enter(self, members: list[Shape | Ball]) -> None:
        """Give members rows at the ends of their tables."""
        ids: list[int] = self._next_ids(len(members)).tolist()
        for table, of_balls in ((self._arrays.balls, True), (self._arrays.shape_table, False)):
            come = [pair for pair in zip(ids, members, strict=True) if (pair[1]._KIND == BALL_KIND) is of_balls]
            if come:
                first = table.count
                table.append([member._table.rows.tobytes() for _, member in come], [member_id for member_id, _ in come])
                for index, (member_id, member) in enumerate(come, first):
                    member._enter(self, table, index, member_id)  # type: ignore[arg-type]
        self._objects.update(zip(ids, members, strict=True))

    def _next_ids(self, count: int) -> NDArray[np.int64]:
        """Ids that were never used."""
        first = int(self._states[0]["next_id"])
        self._states[0]["next_id"] = first + count
        return np.arange(first, first + count, dtype=np.int64)

    @spelled
    @alone
    def add_balls(
        self,
        position: ArrayLike,
        velocity: ArrayLike = (0.0, 0.0),
        radius: ArrayLike | None = None,
        mass: ArrayLike = 1.0,
        elasticity: ArrayLike = 1.0,
        friction: ArrayLike | None = None,
        layer: ArrayLike = 1,
        collides_with: ArrayLike = ALL_LAYERS,
        sensor: ArrayLike = False,
        can_collide: ArrayLike = True,
    ) -> NDArray[np.int64]:
        """The ids of balls added all at once.

        Args:
            position: Centres, of shape (n, 2).
            velocity: Of shape (n, 2), or one pair for all.
            radius: Of shape (n,), or one number for all; positive. Must be given.
            mass: Likewise.
            elasticity: Likewise, 0 or more.
            friction: Likewise, in length/s²; -1 where it is the world's. None: it is that for all.
            layer: The layers that they are on, masks of 32 bits: of shape (n,), or one for all.
            collides_with: The layers that they meet, likewise.
            sensor: Whether they only report what overlaps them; of shape (n,), or one for all.
            can_collide: Whether they meet anything at all, likewise.

        Raises:
            InvalidArgument: Something has another shape, is not finite, or not what it must be; or a ball's box is not
                finite. None has been added then.
        """
        places = checks.array("position", position, (-1, 2))
        count = len(places)
        rows = np.zeros(count, BALL)
        rows["x"], rows["y"] = places.T
        rows["vx"], rows["vy"] = checks.array("velocity", velocity, (count, 2)).T
        rows["radius"] = checks.array("radius", radius, (count,), above=0.0)
        rows["mass"] = checks.array("mass", mass, (count,), above=0.0)
        rows["elasticity"] = checks.array("elasticity", elasticity, (count,), least=0.0)
        given = OF_WORLD if friction is None else friction
        rows["friction"] = checks.array("friction", given, (count,), least=0.0, besides=OF_WORLD)
        rows["layer"] = checks.masks("layer", layer, count)
        rows["collides_with"] = checks.masks("collides_with", collides_with, count)
        rows["sensor"] = checks.flags("sensor", sensor, count)
        rows["can_collide"] = checks.flags("can_collide", can_collide, count)
        rows["relation"] = NO_RELATION
        with np.errstate(over="ignore"):
            far = ~np.isfinite(np.abs(places).T + rows["radius"]).all(axis=0)
        if far.any():
            first = int(np.argmax(far))
            raise checks.refuse(f"position[{first}]", "must leave the ball's box finite", tuple(places[first].tolist()))
        see_lent(self._world)
        table = self._arrays.balls
        table.reserve(table.count + count, doubling=False)
        rows["id"] = self._next_ids(count)
        table.rows[table.count : table.count + count] = rows
        table.count += count
        self._rearrange(CHANGED)
        return rows["id"].copy()

    @alone
    def remove(self, *shapes: Shape | Compound | Group | Ball) -> None:
        """Take shapes, compounds, groups and balls out of the world; the objects keep their last values.

        A sensor that one of them was inside of, or that was inside of it, gives an `EXIT` at the beginning of the next
        step. Many are taken out at once as fast as one; what is given twice is taken out once. What has left since the
        last step or run, or the one before it, may be given again, and nothing happens: one ball may have several hits,
        and `for hit in hits: world.remove(hit.ball)` is right.

        Raises:
            InvalidArgument: One of them is not in this world, or is part of a compound or group. None has been taken
                out then.
        """
        leavers = leaving(self, shapes)
        tables = (self._arrays.balls, self._arrays.shape_table)
        gone = {table: self._none_of(table.count) for table in tables}
        for members in leavers:
            self._unlist(members[0].id or 0, len(leavers))
            for member in members:
                table = self._arrays.table_of(member)
                gone[table][table.index(member)] = True
        if leavers:
            self._remove(gone[self._arrays.balls], gone[self._arrays.shape_table])

    @staticmethod
    def _none_of(count: int) -> NDArray[np.bool_]:
        """A mask that takes nothing."""
        return np.zeros(count, np.bool_)

    def _remove(self, balls: NDArray[np.bool_], shapes: NDArray[np.bool_], what: int = CHANGED) -> None:
        """Detach the objects of rows and take the rows out, which changes so much for the others."""
        see_lent(self._world)
        for table, gone in ((self._arrays.balls, balls), (self._arrays.shape_table, shapes)):
            for index in np.flatnonzero(gone).tolist():
                member_id = table.id_at(index)
                member = self._objects.pop(member_id, None)
                if member is not None:
                    member._leave()
                    self._departed.add(member_id, member)
        remove_rows(self._arrays, balls, shapes)
        self._rearrange(what)

    def object(self, member_id: int) -> Shape | Ball:
        """The shape or ball with an id: the object that was added, or always the same one for a row of `add_balls`.

        Raises:
            InvalidArgument: There is none in the world.
        """
        checks.whole("member_id", member_id, 0, 2**63 - 1)
        found = self._objects.get(member_id)
        return found if found is not None else self._ball_of(member_id)

    def _ball_of(self, ball_id: int) -> Ball:
        """The object of a ball's row, made now if it was not asked for before."""
        ball = self._objects.get(ball_id)
        if ball is None:
            index = self._arrays.balls.find(ball_id)
            # Of two threads that ask for it at once, both are given the same.
            ball = self._objects.setdefault(ball_id, Ball._of_row(self, self._arrays.balls, ball_id, index))
        assert isinstance(ball, Ball)
        return ball

    def _object_of_hit(self, member_id: int, gone: Rows | None) -> Shape | Ball | None:
        """The object that a hit names, or None if it left and nobody kept it; `gone` are rows that left in that run."""
        found = self._objects.get(member_id)
        if found is None:
            found = self._departed.find(member_id, gone)
        if found is None:
            with suppress(InvalidArgument):
                found = self._ball_of(member_id)
        return found

    @alone
    def _look(self, do: Callable[..., R], *arguments: Any) -> R:
        """What `do` returns, which looks at this world and has it to itself."""
        return do(*arguments)

    # -- changes -----------------------------------------------------------------------------------------------------

    def _note_change(self) -> None:
        """Take note that something was changed from outside, but not where and how a shape lies or moves."""
        if self._halves[WAKE] == 0:
            self._halves[WAKE] = CHANGED

    def _changed(self, member: Shape | Ball) -> None:
        """Take note that a member was, by which the ball, or those that the shape holds, begin new flights."""
        arrays = self._arrays
        index = arrays.table_of(member).index(member)
        begin_anew(arrays, np.array([index]) if member._KIND == BALL_KIND else arrays.held_by(index))
        self._note_change()

    def _set_going(self) -> None:
        """Take note that shapes were set to move otherwise, which are where they were."""
        self._halves[WAKE] = MOTIONS_CHANGED
        self._words[MOVING_STALE] = STALE

    def _moved(self, shape: Shape, before: ShapeRow) -> None:
        """Take note that a shape was laid elsewhere, or set to move otherwise, which was in a row like `before`."""
        row, layout, index = shape._row, self._arrays.layout, shape._table.index(shape)
        begin_anew(self._arrays, self._arrays.held_by(index))
        if row["motion"] == before["motion"] == KINEMATIC:
            self._set_going()
        elif row["motion"] == before["motion"]:
            layout.note_moved(index, before)
            self._rearrange(CHANGED)
        else:
            layout.note_other_motion(index, before, int(row["motion"]))
            self._rearrange(MOTIONS_CHANGED)

    def _changed_all(self, of_flights: bool) -> None:
        """Take note that a setting was changed, by which flights maybe begin anew."""
        if of_flights:
            begin_anew(self._arrays, np.ones(self._arrays.balls.count, np.bool_))
        self._arrays.layout.forget()
        self._rearrange(MOTIONS_CHANGED)

    def _rearrange(self, what: int) -> None:
        """Have the next step look at its tables anew, in which so much was changed."""
        self._halves[WAKE] = max(self._halves[WAKE], what)
        self._search = None
        self._forget_block()

    def _forget_block(self) -> None:
        """Have the next step look for its tables anew, and go the long way to its kernel."""
        self._block = None
        self._dt = -1.0

    def _will_wake(self) -> int:
        """Why the next step begins with waking all balls, or 0: see `will_wake`; a change through a view is seen."""
        see_lent(self._world)
        return will_wake(self._arrays)
