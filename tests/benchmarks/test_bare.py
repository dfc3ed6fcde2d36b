"""The bare loop of the gas is a gas, and the one in C is the same."""

from dataclasses import replace

import numpy as np
import pytest

from benchmarks import bare
from benchmarks.gas import RADIUS, gas


def stepped(loop: bare.Loop, by_address: bool = False) -> bare.Bare:
    """A gas of 60 balls after some steps."""
    engine = bare.Bare(gas(60), loop, by_address)
    for _ in range(12):
        engine.step()
    return engine


def test_energy_is_kept_and_every_ball_stays_in_the_box() -> None:
    engine, before = stepped(bare.step_gas), bare.Bare(gas(60), bare.step_gas)
    (position, velocity), (start, first) = engine.state(), before.state()
    assert np.sum(velocity**2) == pytest.approx(np.sum(first**2), rel=1e-12)
    assert (velocity != first).any(axis=1).sum() > 20, "balls have bounced"
    side = gas(60).segments.max()
    assert position.min() >= 0.0
    assert position.max() <= side
    assert np.abs(position - start).max() > RADIUS


def test_no_pair_that_touches_is_overlooked() -> None:
    setup = replace(gas(1_000), time_step=0.1)
    engine = bare.Bare(setup, bare.step_gas)
    moved = setup.position + setup.time_step * setup.velocity
    apart = np.linalg.norm(moved[:, None] - moved[None], axis=2)
    met = np.argwhere(np.triu(apart < 2.0 * RADIUS, k=1))
    assert len(met) > 100
    engine.step()
    position, velocity = engine.state()
    for i, j in met:
        assert (velocity[i] != setup.velocity[i]).any() or (position[i] != moved[i]).any()
        assert (velocity[j] != setup.velocity[j]).any() or (position[j] != moved[j]).any()


def test_in_c_it_gives_the_same_bits() -> None:
    in_c = bare.c_loop()
    if in_c is None:
        pytest.skip("no C compiler is here")
    assert stepped(in_c, by_address=True).balls.tobytes() == stepped(bare.step_gas).balls.tobytes()
