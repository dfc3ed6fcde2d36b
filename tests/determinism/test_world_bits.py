"""The same bits from the same world: again, in other processes, with less room, in one run or in many steps."""

from typing import Any

import pytest

import carom
from tests import fresh
from tests.worlds import bits, crowded, starve

WAYS = [(detection, phase) for detection in ("discrete", "continuous") for phase in ("grid", "quadtree", "brute")]

CODE = """
import sys
from tests.determinism.test_world_bits import WAYS, gone
for detection, broad_phase in WAYS:
    print(gone(detection=detection, broad_phase=broad_phase).digest())
"""


def gone(seconds: float = 2.0, **settings: Any) -> carom.World:
    """A crowded world after some time."""
    world = crowded(**settings)
    world.run(seconds)
    return world


@pytest.fixture(scope="module")
def digests() -> list[str]:
    """The digests of the crowded world in all ways, here."""
    return [gone(detection=detection, broad_phase=broad_phase).digest() for detection, broad_phase in WAYS]


def test_every_way_gives_the_same_bits_again(digests: list[str]) -> None:
    assert [gone(detection=detection, broad_phase=phase).digest() for detection, phase in WAYS] == digests


@pytest.mark.slow
@pytest.mark.parametrize("seed", ["0", "77"])
def test_every_way_gives_the_same_bits_in_another_process(seed: str, digests: list[str]) -> None:
    assert fresh.printed(CODE, PYTHONHASHSEED=seed).split() == digests


@pytest.mark.slow
@pytest.mark.compiled
def test_every_way_gives_the_same_bits_interpreted(digests: list[str]) -> None:
    assert fresh.printed(CODE, NUMBA_DISABLE_JIT="1", PYTHONHASHSEED="random").split() == digests


@pytest.mark.parametrize(("detection", "broad_phase"), WAYS)
def test_a_world_that_has_to_grow_gives_the_same_bits(detection: str, broad_phase: str) -> None:
    settings: dict[str, Any] = {"detection": detection, "broad_phase": broad_phase, "remove_strays": True}
    roomy, tight = crowded(30, **settings), crowded(30, **settings)
    for _ in range(60):
        starve(tight)
        assert bits(tight.step(1 / 60)) == bits(roomy.step(1 / 60))
        assert tight.digest() == roomy.digest()
    assert roomy.statistics.collisions > 0


def test_a_world_that_has_to_grow_for_many_hits_at_once_gives_the_same_bits() -> None:
    roomy, tight = crowded(80, sleep_speed=0.0), crowded(80, sleep_speed=0.0)
    starve(tight)
    assert bits(tight.run(1.0)) == bits(roomy.run(1.0))
    assert tight.digest() == roomy.digest()


@pytest.mark.parametrize(("detection", "broad_phase"), WAYS)
def test_looking_at_a_world_changes_nothing(detection: str, broad_phase: str) -> None:
    seen, unseen = (crowded(detection=detection, broad_phase=broad_phase) for _ in range(2))
    for _ in range(30):
        hits = seen.step(1 / 60)
        looks = [hit.ball.position for hit in hits], [shape.aabb for shape in seen.shapes], seen.statistics.as_dict()
        assert looks
        assert [ball.radius for ball in seen.balls] == seen.balls.radius.tolist()
        assert seen.snapshot()
        unseen.step(1 / 60)
    assert seen.digest() == unseen.digest()
