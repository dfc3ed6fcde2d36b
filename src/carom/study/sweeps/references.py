"""Functions by name, `module:function`, so that other processes can import what a sweep is to call."""

from __future__ import annotations

import inspect
import sys
from collections.abc import Callable
from importlib import import_module
from pathlib import Path
from typing import Any

from carom.checks import refuse
from carom.errors import InvalidArgument

#: The program's own module is being imported, to see whether its functions can be.
_importing: list[str] = []


def is_reference(text: str) -> bool:
    """Whether a text has the form `module:function`."""
    module, _, function = text.partition(":")
    return all(part.isidentifier() for name in (module, function) for part in name.split("."))


def reference_of(argument: str, given: Any) -> str:
    """The reference of a function, or a reference itself, that leads to a function.

    Raises:
        InvalidArgument: It cannot be imported; the message names the `argument`.
    """
    if isinstance(given, str):
        text = given
    elif callable(given) and hasattr(given, "__qualname__"):
        text = f"{_module_of(argument, given)}:{given.__qualname__}"
    else:
        raise refuse(argument, "must be a function that can be imported, or its name like 'module:function'", given)
    if not is_reference(text):
        raise InvalidArgument(
            f"{argument} must be a function at the top of a module, which other processes can import, not {text}"
        )
    try:
        function_of(text)
    except (ImportError, AttributeError, TypeError) as error:
        raise InvalidArgument(f"{argument} {text} cannot be imported: {error}") from None
    return text


def function_of(text: str) -> Callable[..., Any]:
    """The function that a reference leads to; raises what importing it raises, or `TypeError` where it is none."""
    module, _, name = text.partition(":")
    _importing.append(module)
    try:
        thing: Any = import_module(module)
    finally:
        _importing.pop()
    for part in name.split("."):
        thing = getattr(thing, part)
    if not callable(thing):
        raise TypeError(f"it is a {type(thing).__name__}, not a function")
    function: Callable[..., Any] = thing
    return function


def source_text(text: str) -> str:
    """The source of the function that a reference leads to; "" where there is none to read."""
    try:
        return inspect.getsource(function_of(text))
    except (OSError, TypeError):
        return ""


def refuse_while_importing() -> None:
    """Raise `InvalidArgument` where the caller is a program that is being imported, not run."""
    if _importing:
        raise InvalidArgument(
            f"study.sweep was called while {_importing[-1]} was imported: put the call below if __name__ == '__main__':"
        )


def _module_of(argument: str, function: Any) -> str:
    """The name by which other processes can import the module of a function."""
    if function.__module__ != "__main__":
        return str(function.__module__)
    main = sys.modules["__main__"]
    spec, file = getattr(main, "__spec__", None), getattr(main, "__file__", None)
    if spec is not None:
        return str(spec.name)
    if file is None:
        raise InvalidArgument(
            f"{argument} {function.__qualname__} cannot be imported by other processes: put it into a module of its own"
        )
    return Path(file).stem
