"""In which order words that are read from the left or from the right are drawn, by the Unicode bidirectional algorithm.

Lines are read from the left, as they are in SVG. Of that algorithm, all but pairs of brackets and characters that embed
or isolate, which names do not have.
"""

from __future__ import annotations

from itertools import groupby
from unicodedata import bidirectional

#: Classes of letters that are read from the right, and of digits.
RIGHTWARD, DIGITS = {"R", "AL"}, {"EN", "AN"}
#: The class of what stands before or behind a number.
BESIDE = "ET"


def pieces(words: str) -> list[tuple[str, bool]]:
    """The pieces of one line as they stand from left to right, each with whether it is read from the right.

    >>> pieces("ball 3")
    [('ball 3', False)]
    """
    classes = [bidirectional(letter) for letter in words]
    if not RIGHTWARD & set(classes):
        return [(words, False)] if words else []
    levels = levels_of(numbered(classes))
    runs = [
        (level, "".join(letter for letter, _ in run))
        for level, run in groupby(zip(words, levels, strict=True), lambda pair: pair[1])
    ]
    for least in range(max(levels), 0, -1):
        runs = turned(runs, least)
    return [(text, level % 2 == 1) for level, text in runs]


def numbered(classes: list[str]) -> list[str]:
    """The classes, what belongs to a number as `EN` or `AN`, and marks on letters as what they are on."""
    found = list(classes)
    strong = "ON"
    for k, name in enumerate(classes):
        before = found[k - 1] if k > 0 else "ON"
        after = classes[k + 1] if k + 1 < len(classes) else "ON"
        strong = name if name in RIGHTWARD or name == "L" else strong
        if name == "NSM":
            found[k] = before
        elif name == "EN" and strong == "AL":
            found[k] = "AN"
        elif before in DIGITS and after in DIGITS and (name == "CS" or (name == "ES" and before == "EN")):
            found[k] = before
    # What stands before or behind a number belongs to it.
    for way in (range(1, len(found)), range(len(found) - 2, -1, -1)):
        for k in way:
            if found[k] == BESIDE and found[k - way.step] == "EN":
                found[k] = "EN"
    return found


def levels_of(classes: list[str]) -> list[int]:
    """How deep each letter is embedded: even where it is read from the left, odd where from the right."""
    sides = []  # of letters and numbers; None for what stands between them
    strong = 0
    for name in classes:
        strong = 1 if name in RIGHTWARD else 0 if name == "L" else strong
        sides.append(strong if name in RIGHTWARD or name in DIGITS or name == "L" else None)
    levels = []
    for k, (name, side) in enumerate(zip(classes, sides, strict=True)):
        if side is None:
            before = next((one for one in reversed(sides[:k]) if one is not None), 0)
            after = next((one for one in sides[k:] if one is not None), 0)
            levels.append(before & after)
        else:
            # A number among letters that are read from the right is read from the left.
            levels.append(2 if name in DIGITS and side == 1 else side)
    return levels


def turned(runs: list[tuple[int, str]], least: int) -> list[tuple[int, str]]:
    """The runs, those that are embedded at least so deep and stand together in the opposite order."""
    found: list[tuple[int, str]] = []
    for deep, group in groupby(runs, lambda run: run[0] >= least):
        together = list(group)
        found += together[::-1] if deep else together
    return found
