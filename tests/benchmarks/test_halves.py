"""The bare gas in two halves is the bare gas: every ball is in its cell, and no pair is overlooked or met twice."""

import numpy as np
import pytest

from benchmarks import bare, halves
from benchmarks.gas import gas


def test_halves_come_to_what_the_whole_comes_to(monkeypatch: pytest.MonkeyPatch) -> None:
    parts = (halves.move_half, halves.share_cells, halves.sort_half, halves.bounce_lines)
    monkeypatch.setattr(halves, "compiled", lambda: {part.__name__: part for part in parts})
    whole, split = bare.Bare(gas(300), bare.step_gas), halves.Halves(300)
    for _ in range(8):
        whole.step()
        assert split.step() > 0.0
    assert (np.sort(split.members) == np.arange(300)).all()
    assert (np.diff(split.cells[split.members].astype(int)) >= 0).all()
    # Which line comes last makes a difference only where a ball is pushed by two others in one step.
    assert np.abs(split.balls - whole.balls).max() < 1e-9
    assert (split.balls[:, 2:] != halves.Halves(300).balls[:, 2:]).any(axis=1).sum() > 20
