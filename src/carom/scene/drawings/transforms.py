"""The transforms of SVG elements, read by svgelements; what that would pass over is refused before."""

from __future__ import annotations

import re
from functools import lru_cache
from math import isfinite

from svgelements import Matrix as Parsed

from carom.scene.drawings.paths import NUMBER
from carom.scene.drawings.pieces import Matrix

_LIST = rf"\(\s*+(?:{NUMBER}[a-z]*+[\s,]*+)++\)"
_TRANSFORM = re.compile(rf"\s*+(?:(?:matrix|translate|scale|rotate|skewX|skewY|skew)\s*+{_LIST}[\s,]*+)++")


@lru_cache(maxsize=256)
def transform(text: str) -> Matrix:
    """The transform that an attribute writes; raises `ValueError`."""
    if text.strip() in {"", "none"}:
        return Matrix()
    if len(text) > 2000 or _TRANSFORM.fullmatch(text) is None:
        raise ValueError(f"must be matrix, translate, scale, rotate or skew with numbers, not {text[:60]!r}")
    parsed = Parsed(text)
    values = [float(value) for value in (parsed.a, parsed.b, parsed.c, parsed.d, parsed.e, parsed.f)]
    if not all(map(isfinite, values)):
        raise ValueError(f"must be finite, not {text[:60]!r}")
    return Matrix(*values)
