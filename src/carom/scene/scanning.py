"""A look at the text of a file before it is read: whether reading it would take more memory or stack than it is worth.

TOML's reader keeps a table of a thousand bytes for each name with dots and for each heading, and one more for each part
before it; both readers descend once more for each bracket. So their text is counted first. What stands in strings and
comments counts for nothing. A text that is not well formed may be counted wrongly from there on, where no reader goes.
"""

from __future__ import annotations

import re

import numpy as np

from carom.limits import DEEPEST, MOST_KEYS

#: Strings of all kinds, to their ends or, where there is none, as far as they reach; and comments.
_TOML_OPAQUE = re.compile(
    r'"""(?:[^"\\]|\\.|"(?!""))*+(?:"{3,5})?|\'\'\'(?:[^\']|\'(?!\'\'))*+(?:\'{3,5})?'
    r'|"(?:[^"\\\n]|\\.)*+"?|\'[^\'\n]*+\'?|#[^\n]*+',
    re.DOTALL,
)
_JSON_STRING = re.compile(r'"(?:[^"\\]|\\.)*+"?', re.DOTALL)

_PART = r'(?:[\w-]++|"")'
_DOT = r"[ \t]*+\.[ \t]*+"
_DEEP_NAME = re.compile(rf"\.[ \t]*+{_PART}(?:{_DOT}{_PART}){{{DEEPEST - 1}}}")
_DOTTED_NAME = re.compile(rf"\.[ \t]*+{_PART}[ \t]*+=")
_QUOTED_NAME = re.compile(r'""[ \t]*+=')
_NAME = re.compile(r"^[ \t]*+([\w-]++)[ \t]*+=", re.MULTILINE)
#: A line in brackets without a comma; with one, it is a line of a list.
_HEADING = re.compile(r"^[ \t]*+(\[[^,\n]*\])[ \t\r]*+$", re.MULTILINE)

_ALL_BUT_BRACKETS = bytes(set(range(256)) - set(b"[]{}"))


def check_toml(text: str) -> None:
    """Raise `ValueError` where a TOML text is nested too deeply, or has more names than there are."""
    bare = text
    if '"' in text or "'" in text or "#" in text:
        bare = _TOML_OPAQUE.sub(lambda found: "" if found[0][0] == "#" else '""', text)
    _check_depth(bare)
    if _DEEP_NAME.search(bare):
        raise ValueError(f"nested too deeply: a name of more than {DEEPEST} parts")
    headings = _HEADING.findall(bare)
    # What is quoted looks all the same here, so each counts.
    quoted = [heading for heading in headings if '""' in heading]
    names = len(set(_NAME.findall(bare))) + len(set(headings) - set(quoted)) + len(quoted)
    names += len(_DOTTED_NAME.findall(bare)) + len(_QUOTED_NAME.findall(bare))
    if names > MOST_KEYS:
        raise ValueError(f"has more than {MOST_KEYS} different names and names with dots: {names}")


def check_json(text: str) -> None:
    """Raise `ValueError` where a JSON text is nested too deeply."""
    _check_depth(_JSON_STRING.sub("", text))


def _check_depth(bare: str) -> None:
    """Raise `ValueError` where brackets stand in more brackets than they may."""
    brackets = bare.encode("utf-8", "surrogatepass").translate(None, _ALL_BUT_BRACKETS)
    steps = np.where(np.isin(np.frombuffer(brackets, "u1"), (ord("["), ord("{"))), 1, -1).astype("i4")
    depth = np.concatenate([np.zeros(1, "i4"), np.cumsum(steps, dtype="i4")])
    if (depth - np.minimum.accumulate(depth)).max() > DEEPEST:
        raise ValueError(f"nested too deeply: more than {DEEPEST} levels")
