"""Cubics along a curve that is known by a function alone."""

from __future__ import annotations

import itertools
from collections.abc import Callable
from typing import Any, TypeAlias

from carom.checks import pair, refuse
from carom.shapes.outlines.cubic import Cubic
from carom.typing import Vector

Curve: TypeAlias = Callable[[float], Any]

#: Pieces that a curve is taken apart into at first and at most, and places where each is compared with the curve.
PIECES, MOST_PIECES, LOOKS = 8, 8192, (0.15, 0.3, 0.5, 0.7, 0.85)

#: Of Ridders' method: the first step, how often it is shortened, and by what factor.
STEP, SHORTER, FACTOR = 0.02, 12, 1.6


def value_of(name: str, curve: Curve, t: float) -> Vector:
    """What a user's function gives for t, a pair of floats; raises where it is none."""
    return pair(f"{name}({t!r})", curve(t))


def slope_by_steps(place: Callable[[float], complex], t: float) -> complex:
    """The derivative of a function on [0, 1] at t, to ten digits or so where it is smooth; takes no place outside.

    Differences over ever shorter steps, to both sides where there is room, extrapolated to no step at all; the one that
    changed least is taken. Source: C. J. F. Ridders, "Accurate computation of F'(x) and F'(x)F''(x)", 1982.
    """
    step = STEP
    sided = 0.0 if step <= t <= 1.0 - step else (1.0 if t < 0.5 else -1.0)
    order = 2 if sided == 0.0 else 1
    here = place(t)
    row: list[complex] = []
    best, least = 0j, float("inf")
    for _ in range(SHORTER):
        if sided:
            new = [(place(t + sided * step) - here) / (sided * step)]
        else:
            new = [(place(t + step) - place(t - step)) / (2.0 * step)]
        for depth, old in enumerate(row):
            weight = FACTOR ** (order * (depth + 1))
            new.append((weight * new[depth] - old) / (weight - 1.0))
            change = max(abs(new[-1] - new[depth]), abs(new[-1] - old))
            if change <= least:
                best, least = new[-1], change
        row = new
        step /= FACTOR
    return best


def cubics_along(place: Callable[[float], complex], slope: Callable[[float], complex], tolerance: float) -> list[Cubic]:
    """Cubics that join smoothly and keep within `tolerance` of a curve on [0, 1], as far as a few looks at each tell.

    Raises:
        InvalidArgument: More of them are needed than `MOST_PIECES`.
    """
    knots = [index / PIECES for index in range(PIECES + 1)]
    ends = {t: (place(t), slope(t)) for t in knots}
    pending = list(itertools.pairwise(knots))[::-1]
    cubics: list[Cubic] = []
    while pending:
        start, end = pending.pop()
        (first, out), (last, into) = ends[start], ends[end]
        third = (end - start) / 3.0
        cubic = Cubic(first, first + third * out, last - third * into, last)
        if all(abs(cubic.point(s) - place(start + s * (end - start))) <= tolerance for s in LOOKS):
            cubics.append(cubic)
            continue
        middle = 0.5 * (start + end)
        if len(cubics) + len(pending) > MOST_PIECES or not start < middle < end:
            raise refuse("curve", f"must be smooth; it cannot be followed to the tolerance near t={middle:.6g}", place)
        ends[middle] = place(middle), slope(middle)
        pending += [(middle, end), (start, middle)]
    return cubics
