"""`World`: holds shapes and balls, steps them, and says what happened."""

from __future__ import annotations

from collections.abc import Callable
from threading import get_ident
from typing import Any, Literal, Self, overload

import numpy as np

from carom import checks
from carom.compiler import door
from carom.compiler.door import At
from carom.compiler.kernels import Kernel
from carom.errors import ImpactLimit, InvalidArgument, NonFiniteState
from carom.pictured import Pictured
from carom.rows.hit import HIT
from carom.rows.relation import NO_RELATION
from carom.rows.state import (
    BEGIN,
    CHANGED,
    DISCRETE,
    DONE,
    HAS_STRAYS,
    NEEDS_PAIRS,
    NEEDS_ROOM,
    NO_CHANGE,
    PAUSE,
    STATE,
)
from carom.spelling import Spelled, spelled
from carom.turns import alone, busy, having
from carom.typing import BroadPhase, Detection, Keep, Pair, Restitution
from carom.world.copies import shallow, state_of, take_state
from carom.world.counts import Counts
from carom.world.endings import Until, ending_of
from carom.world.hits import Hits
from carom.world.kernels.continuous.film import step_continuous
from carom.world.kernels.continuous.frames import undo
from carom.world.kernels.continuous.showing import call_back_flown
from carom.world.kernels.step.discrete import step_discrete
from carom.world.kernels.step.rollback import call_back, roll_back
from carom.world.members import NO_BALLS, Members
from carom.world.queries import Queries
from carom.world.refusal import refusal
from carom.world.running import keeper, run_steps
from carom.world.settings import SETTINGS, Settings, Sides
from carom.world.sizes import step_size
from carom.world.snapshot import digest_of, read_snapshot, write_snapshot
from carom.world.statistics import Statistics
from carom.world.tables import Arrays, clear_kernel_place
from carom.world.views import note_lent, see_lent

#: The kernel of each detection's step.
STEP_KERNELS = (step_discrete, step_continuous)

#: Words of a state, as Python reads and writes them: in far less time than fields of a record.
STEPS_LEFT, HITS, DETECTION = (
    STATE.fields[name][1] // 8  # type: ignore[index]
    for name in ("steps_left", "hits", "detection")
)

#: Steps of a run at most; far beyond what can be waited for.
MOST_STEPS = 2**62


@spelled
class World(Settings, Members, Queries, Pictured, Spelled):
    """Shapes and balls that collide.

    Every setting is a keyword argument and an attribute that can be changed while the world runs; `Settings` lists them
    with their meanings. A mistake raises `InvalidArgument` (a `ValueError`) that names the setting and the value.

    >>> import carom
    >>> world = carom.World(gravity=(0, -10))
    >>> floor = world.add(carom.Segment((-5, 0), (5, 0), elasticity=0.5))
    >>> ball = world.add(carom.Ball((0, 1.5), radius=0.5))
    >>> hits = world.run(0.5)
    >>> hits[0].shape is floor, hits[0].ball is ball
    (True, True)
    """

    def __init__(
        self,
        *,
        gravity: Pair = (0.0, 0.0),
        detection: Detection = "continuous",
        substeps: int = 4,
        iterations: int = 6,
        broad_phase: BroadPhase = "grid",
        levels: int = 6,
        restitution: Restitution = "normal",
        friction: float = 0.0,
        sleep_speed: float = 0.0,
        sleep_time: float = 0.5,
        rest_speed: float | None = None,
        max_speed: float | None = None,
        max_impacts: int | None = None,
        bounds: Sides | None = None,
        remove_strays: bool = False,
    ) -> None:
        given = locals()
        self._arrays = Arrays()
        states: Any = self._arrays.states
        self._states = self._arrays.states
        self._halves, self._words = memoryview(states.view(np.int32)), memoryview(states.view(np.int64))
        self._states[0]["free_relation"] = NO_RELATION
        self._states[0]["next_id"] = 1
        self._forget_objects()
        for name in SETTINGS:
            setattr(self, name, given[name])

    # -- time --------------------------------------------------------------------------------------------------------

    @property
    def time(self) -> float:
        """Seconds since the world was made."""
        return float(self._states[0]["time"])

    @property
    def statistics(self) -> Statistics:
        """Counters of what the world has done."""
        return Statistics(self)

    def step(self, dt: float) -> Hits:
        """Every hit of one step of `dt` seconds (not negative), in order of time.

        Raises:
            InvalidArgument: `dt` is negative or not finite, or a column of `balls` was given what a ball may not have.
            NonFiniteState: The state holds NaN or infinity; it is as it was before the step.
            WorldBusy: The world is in use, in another thread or by what has called this.
        """
        length = checks.non_negative("dt", dt)
        # What `having` does, without the call: a step of one ball takes a millionth of a second.
        turn = self._turn
        try:
            del turn.free
        except AttributeError:
            raise busy() from None
        try:
            self._departed.forget_oldest()
            if self._quick is None or length != self._dt:
                return self._advance(1, length)
            kernel, address = self._quick
            words = self._words
            words[STEPS_LEFT] = 1
            status = kernel(address)
            if status != DONE:
                return self._go_on(status)
            return self._take_hits() if words[HITS] else self._no_hits
        finally:
            turn.free = None

    @overload
    def run(
        self,
        seconds: float,
        dt: float = 1 / 60,
        progress: Callable[[float, float], Any] | None = None,
        *,
        until: Until = None,
        until_each: int | None = None,
        keep: Literal["all", "none"] = "all",
    ) -> Hits: ...
    @overload
    def run(
        self,
        seconds: float,
        dt: float = 1 / 60,
        progress: Callable[[float, float], Any] | None = None,
        *,
        until: Until = None,
        until_each: int | None = None,
        keep: Literal["counts"],
    ) -> Counts: ...
    @spelled
    def run(
        self,
        seconds: float,
        dt: float = 1 / 60,
        progress: Callable[[float, float], Any] | None = None,
        *,
        until: Until = None,
        until_each: int | None = None,
        keep: Keep = "all",
    ) -> Hits | Counts:
        """Every hit of `round(seconds / dt)` steps, or of those until something happens.

        It ends with the step in which a condition comes true, the same one in every run from the same state. The hits
        of that step are all there, so there may be more than were waited for. `world.time` says when that was.

        Args:
            seconds: How long at most, in seconds of the world's time; not negative.
            dt: The length of a step; positive.
            progress: Called with the seconds done and the seconds in all, a few times a second. It may look at the
                world, ask it and change it, which acts at once; to step it is refused.
            until: Ends the run. A number: so many hits, of every kind and all balls together. A shape, compound,
                group or ball, or a name: a ball has bounced off it or come into it. A function: called after every step
                with the hits of that step, it returns whether the run is over; it may do what `progress` may.
            until_each: Ends the run when every ball in the world has had so many hits since it began. A hit of two
                balls is one of each.
            keep: "all": every hit is returned. "counts": the hits are counted by what was hit, and no more is kept than
                the counts and when each pair last met. "none": no hits are returned or kept.

        Raises:
            As `step`; the steps before the one that failed have been made, and what is kept of their hits is in the
            exception's `hits`. What a function of yours raises, and Ctrl-C, ends the run after a whole step: the hits
            that it keeps ("all") are returned by the next step or run, whether or not `until` has seen them. To what
            ends that run they count for nothing.
        """
        total = checks.non_negative("seconds", seconds)
        length = checks.positive("dt", dt)
        checks.callable_or_none("progress", progress)
        if total / length > MOST_STEPS:
            raise checks.refuse("seconds", f"must be less than {MOST_STEPS} steps of dt={dt!r}", seconds)
        kept = keeper(self, keep)
        if self._watcher == get_ident():
            raise busy()
        ending = ending_of(self, until, until_each)
        return having(self, run_steps, self, round(total / length), length, progress, ending, kept)

    def _advance(self, steps: int, dt: float) -> Hits:
        """The hits of a number of steps, made without coming back to Python but for more room and for strays."""
        # First of all, for the block whose address it holds may go, and Ctrl-C may come.
        self._quick = None
        self._arrays.owed = 0
        if self._lent is not None:
            see_lent(self)
        state = self._states[0]
        if self._block is None:
            self._arrays.prepare()
            self._block = self._arrays.block()
        if dt != self._dt:
            state["dt"] = self._dt = dt
        state["steps_left"] = steps
        self._removed = []
        self._left = NO_BALLS
        return self._go_on(None)

    def _go_on(self, status: int | None) -> Hits:
        """The hits of the steps that are left, given what the kernel said; None before it was called."""
        kernel = door.enter(STEP_KERNELS[self._states[0]["detection"]], step_size)
        try:
            while status != DONE:
                if status is not None:
                    self._serve(status)
                status = kernel(self._block)
        except BaseException as error:
            self._give_up(error)
            raise
        finally:
            if self._lent is not None:
                note_lent(self)
        if not self._removed:
            self._quick = self._way_in(kernel)
            return self._take_hits() if self._words[HITS] else self._no_hits
        rows = self._take_hits()
        gone = np.concatenate(self._removed)
        self._left = gone
        rows._gone = gone
        return rows

    def _way_in(self, kernel: Kernel) -> tuple[Kernel, int] | None:
        """What a step like the last one is made with, a compiled kernel and an address; None where more must be done.

        It serves until another `dt` is wanted, the block is forgotten, or a column is lent.
        """
        if self._block is None or self._lent is not None or not isinstance(kernel, At):
            return None
        return kernel.at, self._block.address

    def _give_up(self, error: BaseException) -> None:
        """Undo a step that was interrupted, and forget where it was."""
        state = self._states[0]
        if not isinstance(error, (NonFiniteState, InvalidArgument, ImpactLimit)):
            self._roll_back()
        clear_kernel_place(state)
        self._forget_block()

    def _take_hits(self) -> Hits:
        """A copy of the hits recorded so far, in order of time, which are then forgotten."""
        count = self._words[HITS]
        rows = Hits((count,), HIT, self._arrays.hit_bytes(count))
        rows._link = self._link
        self._words[HITS] = 0
        # A ball in flight finds out that it has left a sensor only later. In the discrete mode nothing does.
        if count > 1 and self._words[DETECTION] != DISCRETE and (np.diff(rows["time"]) < 0.0).any():
            rows = rows[np.argsort(rows["time"], kind="stable")]
        return rows

    def _serve(self, status: int) -> None:
        """Do what a kernel that came back needs before it can go on, or raise."""
        if status == PAUSE:
            return
        if status in (NEEDS_ROOM, NEEDS_PAIRS):
            self._arrays.extend(status)
        elif status == HAS_STRAYS:
            rows = self._arrays.balls.used
            strays = rows["stray"] != 0
            self._removed.append(rows[strays].copy())
            none = self._none_of(self._arrays.shape_table.count)
            self._remove(strays, none, CHANGED if self._words[DETECTION] == DISCRETE else NO_CHANGE)
            self._arrays.prepare()
        else:
            error = refusal(status, self._arrays)
            error.hits = self._take_hits()
            raise error
        self._block = self._arrays.block()

    def _roll_back(self) -> None:
        """Undo the part of a step that was interrupted in the interpreter."""
        arrays = self._arrays
        tables = (
            arrays.states, arrays.balls.rows, arrays.shape_table.rows, arrays.order, arrays.saved, arrays.relations
        )  # fmt: skip
        begins, discrete = arrays.states[0]["stage"] == BEGIN, arrays.states[0]["detection"] == DISCRETE
        if begins and discrete:
            call_back(arrays.states[0], arrays.balls.rows, arrays.saved)
        elif begins:
            call_back_flown(arrays.states[0], arrays.balls.rows, arrays.flights)
        elif discrete:
            roll_back(*tables)
        else:
            undo(*tables, arrays.flights)

    # -- state -------------------------------------------------------------------------------------------------------

    @alone
    def snapshot(self) -> bytes:
        """The whole state as bytes; `restore` makes the very same world of them. Holds names, but not `user`."""
        return write_snapshot(self)

    @alone
    def restore(self, snapshot: bytes) -> None:
        """Make this world what it was when the snapshot was taken, to the bit.

        Objects whose ids are in it stay, those that are missing are made, the others are detached.

        Raises:
            SnapshotError: The bytes are no snapshot, or damaged; the world is as it was.
        """
        read_snapshot(self, snapshot)

    @alone
    def digest(self) -> str:
        """A hash of the whole state, as 32 hexadecimal digits: equal where the snapshots are."""
        return digest_of(self)

    @alone
    def __getstate__(self) -> dict[str, Any]:
        """The snapshot, the objects of members, what leads hits here, and what a subclass of the user's adds."""
        return state_of(self, vars(World()))

    def __setstate__(self, state: dict[str, Any]) -> None:
        """Make this the world that was pickled or copied, of the members that were pickled or copied with it."""
        World.__init__(self)
        take_state(self, state)

    def __copy__(self) -> Self:
        twin = type(self).__new__(type(self))
        twin.__setstate__(shallow(self.__getstate__()))
        return twin

    def __repr__(self) -> str:
        return f"<World at {self.time:g} s: {len(self.shapes)} shapes, {len(self.balls)} balls>"
