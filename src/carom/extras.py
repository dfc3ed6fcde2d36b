"""Packages that only some of carom needs: imported when they are used, asked for in one line where they are missing."""

from __future__ import annotations

import os
from importlib import import_module
from typing import Any

from carom.errors import MissingExtra

#: pygame greets on stdout when it is imported, unless this is set.
QUIET = "PYGAME_HIDE_SUPPORT_PROMPT"


def needed(module: str, package: str, extra: str, what: str) -> Any:
    """A module of another package, imported now.

    Args:
        module: Its name, `pygame`.
        package: The name that it is installed by, `pygame-ce`.
        extra: The extra of carom that brings it, `draw`.
        what: What needs it, in the plural: `raster pictures`.

    Raises:
        MissingExtra: It is not installed.
    """
    os.environ.setdefault(QUIET, "1")
    try:
        return import_module(module)
    except ImportError:
        raise MissingExtra(f'{what} need {package}: pip install "carom[{extra}]"') from None
