"""Every shipped scene goes the same way, bit for bit: compiled and interpreted, whatever the hash seed."""

import hashlib

import pytest

import carom
from tests import fresh
from tests.worlds import bits

STEPS = 600
#: Fewer where a step takes the interpreter long.
FEWER_STEPS = {"galton": 60, "gas": 80, "pinball": 150}

#: Fewer balls where a scene has many, and walls. A heap takes the interpreter minutes: on the board there are fewer.
FEWER = {"ellipse": {"tolerance": 1e-6}, "galton": {"balls": 30}, "gas": {"balls": 100}}
DT = {"galton": 1 / 400}

#: Scenes that take the interpreter half a minute and more.
LONG = {"galton", "gas", "pinball"}
SCENES = [pytest.param(name, marks=pytest.mark.slow if name in LONG else ()) for name in carom.scenes.names()]

CODE = """
import sys
from tests.determinism.test_world_scenes import outcome
for scene in sys.argv[1:]:
    print(scene, *outcome(scene))
"""


def built(scene: str) -> carom.World:
    """The world of a shipped scene, with fewer balls and walls where there are many."""
    world: carom.World = getattr(carom.scenes, scene)(**FEWER.get(scene, {})).build()
    return world


def outcome(scene: str) -> tuple[str, str]:
    """The digest of a scene's world after all steps, and a hash of everything that happened."""
    world = built(scene)
    dt = DT.get(scene, 1 / 60)
    steps = FEWER_STEPS.get(scene, STEPS)
    hits = world.run(steps * dt, dt)
    assert round(world.time / dt) == steps
    assert len(hits) > 0
    return world.digest(), hashlib.sha256(bits(hits)).hexdigest()


@pytest.mark.slow
@pytest.mark.compiled
@pytest.mark.parametrize("scene", SCENES)
def test_compiled_and_interpreted(scene: str) -> None:
    printed = fresh.printed(CODE, scene, NUMBA_DISABLE_JIT="1", PYTHONHASHSEED="random")
    assert tuple(printed.split()[1:]) == outcome(scene)


@pytest.mark.slow
@pytest.mark.compiled
def test_from_run_to_run_and_whatever_the_hash_seed() -> None:
    here = {scene: outcome(scene) for scene in carom.scenes.names()}
    for seed in ("0", "1", "4242"):
        lines = fresh.printed(CODE, *carom.scenes.names(), PYTHONHASHSEED=seed).splitlines()
        assert {line.split()[0]: tuple(line.split()[1:]) for line in lines} == here
