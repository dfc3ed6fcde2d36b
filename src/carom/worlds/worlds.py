"""`Worlds`: many copies of one world, which one call steps, each to the bits that it would come to alone."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from carom import checks
from carom.errors import ImpactLimit, InvalidArgument, NonFiniteState, SnapshotError
from carom.rows.shape import KINEMATIC
from carom.rows.state import DISCRETE, DONE, NOT_FINITE, REFUSED, TOO_MANY_IMPACTS
from carom.rows.tables import Rows
from carom.spelling import Spelled, spelled
from carom.turns import Turn, alone
from carom.world.refusal import refusal
from carom.world.snapshot import read
from carom.world.statistics import COUNTERS
from carom.world.world import MOST_STEPS, World
from carom.worlds import keeping
from carom.worlds.balls import CopiesOfBalls
from carom.worlds.hits import CopyHits, gathered
from carom.worlds.memory import RELATIONS, Memory
from carom.worlds.shapes import CopiesOfShapes, columns_of, leaders_of
from carom.worlds.stage import Common, Stage
from carom.worlds.threads import Crew, cores

if TYPE_CHECKING:
    from carom.scene import Scene

#: Copies at most.
MOST_COPIES = 2**24

#: What is counted of each shape, in this order.
COUNTED = np.dtype([("bounces", "i8"), ("entries", "i8")])


@spelled
class Worlds(Spelled):
    """Many copies of one world, stepped by one call on all cores.

    Each copy comes to the very bits that a `World` of its own would, whatever the number of copies and of threads. What
    stands still is there once: static shapes, the index of them, and the settings; of each copy there are its time and
    counters, its balls, its kinematic shapes and which static ones are switched off.

    >>> import carom
    >>> scene = carom.scenes.pinball()
    >>> worlds = carom.Worlds(scene, copies=10)
    >>> worlds.shapes["left flipper"].angular_velocity = 20.0
    >>> hits = worlds.step(1 / 60)
    >>> worlds.balls.position.shape, hits.dtype.names[-1]
    ((10, 3, 2), 'world')
    >>> world = worlds[7]
    >>> world.digest() == worlds.digests()[7]
    True

    Args:
        scene: A `Scene`, a `World` (as it stands, of which it is a copy), or the name of a shipped scene.
        copies: How many; at least 1.
        threads: On how many threads they are stepped; None: as many as there are cores, and one in a process that
            another one has started.
        keep_hits: Whether `step` and `run` return the hits. `counts` counts them in any case.

    Raises:
        InvalidArgument: One of them is not what it may be.
        SceneError: There is no such scene, or it is none.
    """

    def __init__(
        self,
        scene: Scene | World | str,
        copies: int,
        threads: int | None = None,
        keep_hits: bool = True,
    ) -> None:
        count = checks.whole("copies", copies, 1, MOST_COPIES)
        most = cores() if threads is None else checks.whole("threads", threads, 1, 1024)
        checks.flag("keep_hits", keep_hits)
        self._base = keeping.base_of(scene)
        self._origin = read(self._base.snapshot())
        arrays = keeping.fresh(self._origin)
        moving = np.flatnonzero(arrays.shapes.used["motion"] == KINEMATIC)
        switched = np.flatnonzero((arrays.shapes.used["motion"] != KINEMATIC) & (arrays.shapes.used["once"] != 0))
        flying = arrays.states[0]["detection"] != DISCRETE
        room = max(RELATIONS, int(arrays.states[0]["relations_high"]))
        sizes = arrays.balls.count, bool(flying), len(moving), len(switched), room
        memory = Memory(count, *sizes)
        columns = columns_of(self._base)
        self._common = Common(
            memory,
            moving.astype(np.int32),
            leaders_of(self._base, moving),
            switched.astype(np.int32),
            arrays.balls.used["id"].copy(),
            np.full(count, DONE, np.int64),
            columns,
            np.zeros((count, int(columns[0]), 2), np.int64),
            keep_hits,
            _is_any_sent(arrays.shapes.used),
        )
        self._turn = Turn()
        self._watcher: int | None = None
        self._crew = Crew(most)
        self._shares = self._crew.shares(count)
        self._no_hits = gathered(self._base, [])
        self._stages: list[Stage] = []
        self._pending: dict[int, Rows] = {}
        self._spare: World | None = None
        memory.in_play[...] = True
        self._stage().put(0)
        self._start = Memory(1, *sizes)
        self._start.words[0] = memory.words[0]
        memory.words[...] = self._start.words
        # As they were after the last step, since they were given to who may change them.
        self._in_play: NDArray[np.bool_] | None = None
        self._lent: Rows | None = None
        self._owe_again(np.arange(count))

    def __len__(self) -> int:
        """The number of copies."""
        return len(self._common.faults)

    def __repr__(self) -> str:
        return f"<{len(self)} worlds: {len(self._base.shapes)} shapes, {len(self._common.ids)} balls each>"

    # -- time --------------------------------------------------------------------------------------------------------

    @property
    def time(self) -> NDArray[np.float64]:
        """Seconds since each world was made, a read-only view of shape (copies,)."""
        return _shown(self._common.memory.state["time"])

    @property
    def statistics(self) -> Rows:
        """Counters of what each has done, a structured array of shape (copies,) with the fields of `Statistics`."""
        return self._common.memory.state[list(COUNTERS)].copy()

    @property
    def failed(self) -> NDArray[np.int64]:
        """The indices of the copies that are not stepped any more, since their state was not finite or not allowed.

        `reset` and `load` let them take part again.
        """
        return np.flatnonzero(self._common.faults != DONE)

    @alone
    def step(self, dt: float) -> CopyHits:
        """Every hit of one step of `dt` seconds (not negative) of all copies, copy by copy.

        Raises:
            InvalidArgument: `dt` is negative or not finite, or a column of `balls` was given what a ball may not have.
            NonFiniteState: Some copies hold NaN or infinity: they are as they were before the step and are stepped no
                more, see `failed`. All others have made the step, whose hits are in the exception's `hits`.
            ImpactLimit: Balls of some copies had `max_impacts`; there the step ended.
            KeyboardInterrupt: Each copy has made the whole call or nothing of it; the hits are lost.
            WorldBusy: They are in use, in another thread or by what has called this.
        """
        return self._advance(1, checks.non_negative("dt", dt))

    @spelled
    @alone
    def run(self, seconds: float, dt: float = 1 / 60) -> CopyHits:
        """Every hit of `round(seconds / dt)` steps of all copies, copy by copy; raises as `step`."""
        total = checks.non_negative("seconds", seconds)
        length = checks.positive("dt", dt)
        if total / length > MOST_STEPS:
            raise checks.refuse("seconds", f"must be less than {MOST_STEPS} steps of dt={dt!r}", seconds)
        return self._advance(round(total / length), length)

    def _advance(self, steps: int, dt: float) -> CopyHits:
        """The hits of a number of steps."""
        self._see_changes()
        while len(self._stages) < len(self._shares):
            self._stage()
        stages = self._stages[: len(self._shares)]
        for stage, (first, last) in zip(stages, self._shares, strict=True):
            stage.begin(first, last, steps, dt)
        try:
            while not self._crew.work(stages):
                wanted = max(int(stage.job["wanted"]) for stage in stages)
                self._resize(len(self._common.switched), 2 * wanted)
        except BaseException:
            # A stage may have a copy out: the memory still has it as it was.
            self._stages = []
            raise
        if self._in_play is not None:
            self._in_play[...] = self._common.memory.in_play
        hits = self._hits_of(stages)
        if np.count_nonzero(self._common.faults):
            self._tell_faults(hits)
        return hits

    def _hits_of(self, stages: Sequence[Stage]) -> CopyHits:
        """The hits that stages have given, and those that were still to be given."""
        parts = [stage.given() for stage in stages if stage.count]
        if self._pending and self._common.keep_hits:
            parts = [*((rows, np.full(len(rows), copy)) for copy, rows in self._pending.items()), *parts]
        self._pending.clear()
        return gathered(self._base, parts) if parts else self._no_hits

    def _tell_faults(self, hits: CopyHits) -> None:
        """Raise where copies were refused in the last call, which is told once: one kind, with notes of the others."""
        faults, count = self._common.faults, len(self)
        errors: list[InvalidArgument | NonFiniteState | ImpactLimit] = []
        for status in (NOT_FINITE, REFUSED, TOO_MANY_IMPACTS):
            found = np.flatnonzero(faults == status)
            if not len(found):
                continue
            where = f"{_listed(found)} of {count} worlds"
            # One that had too many impacts goes on; the others are left out from now on.
            faults[found] = DONE if status == TOO_MANY_IMPACTS else -status
            if status == NOT_FINITE:
                words = f"{where} are not finite: as they were before the step, and not stepped any more"
                errors.append(NonFiniteState(words))
            else:
                error = refusal(status, self._stage_of(int(found[0])).arrays)
                error.args = (f"{where}: {error}",)
                errors.append(error)
        if errors:
            for other in errors[1:]:
                errors[0].add_note(str(other))
            errors[0].hits = hits
            raise errors[0]

    # -- what is in them ---------------------------------------------------------------------------------------------

    @property
    def balls(self) -> CopiesOfBalls:
        """The balls of all copies, as arrays."""
        return CopiesOfBalls(self)

    @property
    def shapes(self) -> CopiesOfShapes:
        """The shapes, compounds and groups of all copies, by index or name."""
        return CopiesOfShapes(self)

    @property
    def counts(self) -> Rows:
        """Bounces and entries since the start or the last `reset`: fields of an array of shape (copies, shapes).

        The shapes are those of `shapes`, in their order; a compound's and a group's are those of its parts. A copy.
        """
        return self._common.counts.view(COUNTED)[..., 0].copy()

    def hits_by_shape(self) -> dict[str, NDArray[np.int64]]:
        """How often balls have bounced off the shapes of each name and come into them, of shape (copies,) each."""
        totals = self._common.counts.sum(axis=2)
        names = [shape.name for shape in self._base.shapes]
        return {
            name: totals[:, [column for column, other in enumerate(names) if other == name]].sum(axis=1)
            for name in dict.fromkeys(names)
            if name is not None
        }

    def _see_changes(self) -> None:
        """Take note of what was written to the arrays of the balls since the last step."""
        self._see_lent()
        memory = self._common.memory
        if self._in_play is not None:
            for copy in np.flatnonzero((self._in_play != memory.in_play).any(axis=1)).tolist():
                self._change_play(copy, self._in_play[copy])

    def _see_lent(self) -> None:
        """Take note of what was written to the columns of the balls, but for who is in play."""
        if self._lent is not None:
            keeping.wake_changed(self._common.memory, self._lent)
            self._forget_lent()

    def _forget_lent(self) -> None:
        """Take the columns of the balls as they are now for what nobody has written to."""
        if self._lent is not None:
            self._lent = keeping.lent_columns(self._common.memory)

    def _change_play(self, copy: int, before: NDArray[np.bool_]) -> None:
        """Take balls out of play of one copy, and put others in, as the mask says now that was `before`."""
        memory = self._common.memory
        after = memory.in_play[copy].copy()
        memory.in_play[copy] = before
        stage = self._out(copy)
        stage.park(copy, ~after[before])
        stage.wake()
        stage.fill(keeping.with_more(stage.arrays, self._base, memory.balls[copy][after & ~before]))
        self._fill_from(stage, copy, after)

    def _fill_from(self, stage: Stage, copy: int, in_play: NDArray[np.bool_]) -> None:
        """Put back the copy that is out on a stage, whose tables were filled anew, with other balls in play."""
        arrays = stage.arrays
        self._pending.pop(copy, None)
        if arrays.states[0]["hits"]:
            self._pending[copy] = arrays.hits[: arrays.states[0]["hits"]].copy()
        self._common.memory.in_play[copy] = in_play
        if self._in_play is not None:
            self._in_play[copy] = in_play
        while not stage.put(copy):
            self._resize(len(self._common.switched), 2 * int(arrays.states[0]["relations_high"]))

    # -- state -------------------------------------------------------------------------------------------------------

    @spelled
    @alone
    def reset(self, where: ArrayLike | None = None) -> None:
        """Put copies back to the start, to the bit: all of them, or those of a mask or of indices.

        Raises:
            InvalidArgument: `where` is no mask of shape (copies,) and holds no indices of copies.
        """
        which = slice(None) if where is None else keeping.chosen("where", where, len(self))
        common = self._common
        # What was written to other copies must not be taken for what they were.
        self._see_lent()
        common.memory.words[which] = self._start.words[0]
        common.faults[which] = DONE
        common.counts[which] = 0
        if self._in_play is not None:
            self._in_play[which] = common.memory.in_play[which]
        self._forget_lent()
        self._owe_again(np.arange(len(self))[which])

    def _owe_again(self, copies: NDArray[np.int64]) -> None:
        """Let copies have those hits to give, and no others, that the world had when it was copied."""
        owed = self._origin.hits
        if len(owed) or self._pending:
            for copy in copies.tolist():
                self._pending.pop(copy, None)
                if len(owed):
                    self._pending[copy] = owed

    @alone
    def __getitem__(self, copy: int) -> World:
        """A `World` of its own that is what the copy is: it steps on to the same bits."""
        self._see_changes()
        return keeping.world_of(self._base, self._snapshot_of(self._index(copy)))

    @alone
    def store(self, copy: int, world: World) -> None:
        """Make a world of yours what the copy is: `worlds[copy]` makes a new one. Raises if it is no `World`."""
        index = self._index(copy)
        _check_world(world)
        self._see_changes()
        world.restore(self._snapshot_of(index))

    def __iter__(self) -> Iterator[World]:
        return (self[copy] for copy in range(len(self)))

    @alone
    def load(self, copy: int, world: World) -> None:
        """Make a copy what a world is: one of the same scene, which has the same shapes, settings and balls.

        Balls that are not there are not in play. What is counted of the copy stays.

        Raises:
            InvalidArgument: It is no world, or another one: static shapes, settings or balls are not the same.
        """
        index = self._index(copy)
        _check_world(world)
        self._see_changes()
        self._load(index, world.snapshot())
        self._forget_lent()

    @alone
    def digests(self) -> list[str]:
        """For each copy the `digest` that a `World` of its own would have. Takes about a millisecond for each."""
        self._see_changes()
        return [keeping.digest_of(self._base, self._out(copy).arrays) for copy in range(len(self))]

    @alone
    def snapshot(self) -> bytes:
        """The state of all copies as bytes; `restore` makes them the very same again. Takes milliseconds for each."""
        self._see_changes()
        parts = [self._snapshot_of(copy) for copy in range(len(self))]
        return keeping.packed(parts, self._common.counts)

    @alone
    def restore(self, snapshot: bytes) -> None:
        """Make all copies what they were when the snapshot was taken, to the bit.

        Raises:
            SnapshotError: The bytes are no snapshot of as many copies of this scene, or damaged; all is as it was.
        """
        parts, counts = keeping.unpacked(snapshot, self._common.counts.shape)
        self._see_changes()
        before, faults = [self._snapshot_of(copy) for copy in range(len(self))], self._common.faults.copy()
        try:
            for copy, part in enumerate(parts):
                self._load(copy, part)
        except (InvalidArgument, SnapshotError) as error:
            for copy, part in enumerate(before):
                self._load(copy, part)
            self._common.faults[...] = faults
            self._forget_lent()
            raise SnapshotError(f"snapshot must be of copies of the same scene: {error}") from None
        self._common.counts[...] = counts
        self._forget_lent()

    def _scratch(self) -> World:
        """A world like the one that was copied, on which single shapes may be set."""
        if self._spare is None:
            self._spare = keeping.world_of(self._base, self._base.snapshot())
        return self._spare

    def __reduce__(self) -> Any:
        """The world that was copied, and the state of all copies."""
        return _remade, (self._base, len(self), self._crew.most, self._common.keep_hits, self.snapshot())

    def _index(self, copy: Any) -> int:
        """The index of a copy; raises where there is none."""
        index = checks.whole("copy", copy, -len(self), len(self) - 1)
        return index % len(self)

    def _stage(self) -> Stage:
        """One more stage."""
        self._stages.append(Stage(keeping.fresh(self._origin), self._common))
        return self._stages[-1]

    def _stage_of(self, copy: int) -> Stage:
        """A stage on which a copy has been taken out."""
        stage = self._stages[0] if self._stages else self._stage()
        stage.take(copy)
        return stage

    def _out(self, copy: int) -> Stage:
        """The same, with the hits that are still to be given."""
        stage = self._stage_of(copy)
        if copy in self._pending:
            stage.arrays.give_back(self._pending[copy])
            stage.arrange()
        return stage

    def _snapshot_of(self, copy: int) -> bytes:
        """The snapshot of a world that is what a copy is."""
        return keeping.snapshot_of(self._base, self._out(copy).arrays)

    def _load(self, copy: int, snapshot: bytes) -> None:
        """Make a copy what a snapshot of a world says."""
        stage = self._stage_of(copy)
        contents = keeping.contents_of(self._origin, self._common, snapshot)
        switched = keeping.switched_of(self._common, stage.arrays, contents)
        if len(switched):
            self._switch(switched)
            stage = self._stage_of(copy)
        stage.fill(contents)
        self._common.sent |= _is_any_sent(contents.shapes)
        self._common.faults[copy] = DONE
        self._fill_from(stage, copy, np.isin(self._common.ids, contents.balls["id"]))

    def _resize(self, switched: int, relations: int) -> None:
        """Have memory with more room for relations, or switches."""
        common = self._common
        relations = max(relations, int(common.memory.layout[0]["relations_room"]))
        common.memory = common.memory.resized(switched, relations)
        self._start = self._start.resized(switched, relations)
        for stage in self._stages:
            stage.arrange()

    def _switch(self, rows: NDArray[np.signedinteger[Any]]) -> None:
        """Give every copy switches of its own for static shapes, which so far are the same in all."""
        common, shapes = self._common, self._base._arrays.shapes.rows
        first = len(common.switched)
        common.switched = np.concatenate([common.switched, rows.astype(np.int32)])
        self._resize(len(common.switched), 0)
        for memory in (common.memory, self._start):
            memory.switches[:, first:, 0] = shapes["can_collide"][rows]
            memory.switches[:, first:, 1] = shapes["once"][rows]


def _remade(base: World, copies: int, threads: int, keep_hits: bool, snapshot: bytes) -> Worlds:
    """The copies that were pickled or copied."""
    worlds = Worlds(base, copies, threads, keep_hits)
    worlds.restore(snapshot)
    return worlds


def _is_any_sent(shapes: Rows) -> bool:
    """Whether a shape is on its way to where it was sent."""
    return bool((shapes["time_left"] > 0.0).any())


def _check_world(world: Any) -> None:
    """Raise where `world` is none."""
    if not isinstance(world, World):
        raise checks.refuse("world", "must be a World", world)


def _listed(copies: Sequence[int] | NDArray[np.int64]) -> str:
    """The first few indices, for a message."""
    first = ", ".join(str(int(copy)) for copy in copies[:10])
    return first + (f" and {len(copies) - 10} more" if len(copies) > 10 else "")


def _shown(view: NDArray[Any]) -> NDArray[Any]:
    """A view that cannot be written to."""
    view = view.view()
    view.flags.writeable = False
    return view
