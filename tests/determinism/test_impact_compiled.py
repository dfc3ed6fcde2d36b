"""Compiled, times of impact, rays, touches of turning shapes and gaps are the same bits as interpreted."""

from collections.abc import Callable
from math import cos, pi, sin
from random import Random
from typing import Any

import pytest

from carom.geometry import (
    advance,
    arc,
    circle,
    figures,
    gap,
    impact,
    impact_fall,
    impact_straight,
    overlap,
    path,
    ray,
    reach,
    response,
    roots,
    turning,
    vector,
)
from tests.determinism.both_ways import functions, register, result_bits
from tests.flat import arguments, fields

numba = pytest.importorskip("numba")

CASES = 3000
#: In the order of their imports, so that what a function calls is known to the compiler before it.
MODULES = (
    vector,
    figures,
    path,
    circle,
    arc,
    overlap,
    roots,
    response,
    reach,
    gap,
    impact_straight,
    impact_fall,
    impact,
    ray,
    turning,
    advance,
)
KINDS = ("point", "segment", "circle", "arc", "ball")
DOORS = [
    roots.falling_time,
    roots.quadratic_roots,
    response.rebounded,
    gap.placed,
    *[
        function
        for module in (impact, ray, advance, gap)
        for function in functions(module)
        if function.__name__ in {f"{name}_{kind}" for name in ("impact", "ray", "advance", "gap") for kind in KINDS}
    ],
]


@pytest.fixture(scope="module", autouse=True)
def registered() -> None:
    """Make every function known to the compiler, for when another calls it."""
    register(MODULES)


def scene(random: Random) -> dict[str, Any]:
    """Numbers by the names of arguments: a shape, and a ball that is near it at some time of its flight."""
    duration = 10.0 ** random.uniform(-3.0, 1.0)
    turn, end, extent = random.uniform(0.0, 2.0 * pi), random.uniform(0.0, 2.0 * pi), random.uniform(0.1, 5.0)
    cx, cy, radius = random.uniform(-5.0, 5.0), random.uniform(-5.0, 5.0), random.uniform(0.01, 2.0)
    tx, ty = cos(turn), sin(turn)
    # some way along the segment, or from the centre to the circle, and off it by about the radius
    along, off = random.uniform(-0.2, 1.2) * extent, radius * random.choice((1.0, random.uniform(-1.2, 1.2)))
    meet_x, meet_y = cx + along * tx - off * ty, cy + along * ty + off * tx
    vx, vy = random.gauss(0.0, 5.0 / duration), random.gauss(0.0, 5.0 / duration)
    gx, gy = random.choice(((0.0, 0.0), (0.0, -9.8), (random.gauss(0.0, 9.0), random.gauss(0.0, 9.0))))
    before = -duration * random.choice((0.0, random.random()))
    ball = {
        "x": meet_x + vx * before + 0.5 * gx * before * before,
        "y": meet_y + vy * before + 0.5 * gy * before * before,
        "vx": vx + gx * before,
        "vy": vy + gy * before,
        "gx": gx,
        "gy": gy,
        "radius": radius,
        "duration": duration,
    }
    ends = (cx + extent * tx, cy + extent * ty, cx + extent * cos(end), cy + extent * sin(end))
    shape = dict(zip(("ax", "ay", "bx", "by"), ends, strict=True))
    turns = {"pivot_x": cx + 1.0, "pivot_y": cy, "pivot_vx": 0.1, "pivot_vy": 0.0, "spin": random.gauss(0.0, 1.0)}
    other = {"first.x": cx, "first.y": cy, "first.vx": 0.5, "first.vy": 0.0, "first.gx": 0.0, "first.gy": 0.0}
    rest = {"reach": extent + radius, "dx": vx * duration, "dy": vy * duration, "solid": random.random() < 0.5}
    names = {"cx": cx, "cy": cy, "qx": cx, "qy": cy, "r": extent, "tx": tx, "ty": ty, "extent": extent}
    polynomial = {name: random.gauss(0.0, 3.0) for name in ("c0", "c1", "c2", "c3", "height", "rate", "acceleration")}
    box = {"left": cx - 9.0, "bottom": cy - 9.0, "right": cx + 9.0, "top": cy + 9.0, "end": duration}
    slow = {"speed": abs(vx), "deceleration": random.random(), "gap": 1e-6, "nx": tx, "ny": ty, "scale": extent}
    bounce = {"surface_vx": 0.1, "surface_vy": 0.0, "px": -tx, "py": -ty, "e": 0.9, "kick": 1.0, "total": False}
    return (
        box
        | slow
        | bounce
        | shape
        | ball
        | turns
        | other
        | rest
        | names
        | polynomial
        | {"slop": 1e-9 * radius, "wx": vx, "wy": vy}
    )


@pytest.mark.slow
@pytest.mark.parametrize("function", DOORS, ids=lambda function: function.__name__)
def test_compiled_and_interpreted_bits_are_equal(function: Callable[..., Any]) -> None:
    random = Random(function.__name__)
    compiled = numba.njit(function)
    names = list(fields(function))
    found = 0
    for _ in range(CASES):
        numbers = scene(random)
        numbers |= {"segment.ax": numbers["cx"], "segment.ay": numbers["cy"]}
        values = (numbers.get(name, numbers.get(name.rpartition(".")[2])) for name in names)
        given = arguments(function, values)
        result = function(*given)
        assert list(result_bits(compiled(*given))) == list(result_bits(result)), given
        found += result is not None
    assert found > CASES // 50
