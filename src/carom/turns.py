"""One thing at a time: what steps, changes or asks a world has it to itself, and who comes meanwhile is told so.

A world has a token, an attribute. Deleting it is one operation, which no other thread and no handler of a signal comes
between, and costs a few dozen nanoseconds; a lock costs more, and one that is taken as a Ctrl-C arrives is never given
back.
"""

from __future__ import annotations

from _thread import get_ident  # it is that of `threading`, whose import takes a while
from collections.abc import Callable
from functools import wraps
from typing import Any, ParamSpec, TypeVar, cast

from carom.errors import WorldBusy

P = ParamSpec("P")
R = TypeVar("R")
Method = TypeVar("Method", bound=Callable[..., Any])
Setter = TypeVar("Setter", bound=Callable[[Any, Any], None])


class Turn:
    """Whose turn it is to use a world: `free` is there while it is nobody's; who deletes it has the turn."""

    __slots__ = ("free",)

    def __init__(self) -> None:
        self.free: None = None


def busy() -> WorldBusy:
    """The error to raise where a world is in use."""
    return WorldBusy(
        "the world is in use: it is being stepped, changed or asked by another thread, or by what has called this;"
        " a world does one thing at a time (different worlds may be used by as many threads)"
    )


def having(world: Any, do: Callable[P, R], *arguments: P.args, **options: P.kwargs) -> R:
    """What `do` returns, called while nothing else uses the world; raises `WorldBusy` where something does.

    The `progress` of a run, which is called between two steps, does what it likes but step.
    """
    turn: Turn = world._turn
    try:
        del turn.free
    except AttributeError:
        if world._watcher != get_ident():
            raise busy() from None
        return do(*arguments, **options)
    try:
        return do(*arguments, **options)
    finally:
        turn.free = None


def alone(method: Method) -> Method:
    """A method of a world that changes it or looks at all of it: it has the world to itself."""

    @wraps(method)
    def guarded(world: Any, /, *arguments: Any, **options: Any) -> Any:
        return having(world, method, world, *arguments, **options)

    return cast("Method", guarded)


def setting(method: Setter) -> Setter:
    """A setter of a shape, compound, group or ball: as `changing`, but for what it takes to pass arguments on."""

    @wraps(method)
    def guarded(member: Any, value: Any, /) -> None:
        world = member._world
        if world is None:
            method(member, value)
            return
        turn = world._turn
        try:
            del turn.free
        except AttributeError:
            having(world, method, member, value)
            return
        try:
            method(member, value)
        finally:
            turn.free = None

    return cast("Setter", guarded)


def changing(method: Method) -> Method:
    """A method of a shape, compound or ball that changes it: if it is in a world, it has that to itself."""

    @wraps(method)
    def guarded(member: Any, /, *arguments: Any, **options: Any) -> Any:
        world = member._world
        if world is None:
            return method(member, *arguments, **options)
        return having(world, method, member, *arguments, **options)

    return cast("Method", guarded)
