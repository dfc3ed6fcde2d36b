"""Ticks: the pitch of the shape, as loud as the impact is fast."""

import numpy as np
import pytest

import carom
from carom.play.toy.sounds import LOUDEST, MOST, PITCHES, tick, ticks


class Ear:
    """Stands in for a speaker, and remembers what was played."""

    def __init__(self, *, silent: bool = False) -> None:
        self.silent = silent
        self.heard: list[tuple[str, float]] = []

    def play(self, name: str, volume: float) -> None:
        """Hear a sound."""
        self.heard.append((name, volume))


def bounces(speeds: list[float]) -> carom.Hits:
    """The hits of balls that fall on segments, one on each."""
    world = carom.World(substeps=1)
    for place, speed in enumerate(speeds):
        world.add(carom.Segment((3 * place, 0), (3 * place + 2, 0)))
        world.add(carom.Ball((3 * place + 1, 0.45), radius=0.5, velocity=(0, -speed)))
    return world.step(1e-4)


def test_there_is_a_tone_for_each_kind_of_shape_and_no_two_are_alike() -> None:
    waves = ticks()
    assert set(waves) == set(PITCHES) == {"point", "segment", "gate", "circle", "arc", "ball"}
    assert all(np.abs(wave).max() <= 1.0 for wave in waves.values())
    assert len(set(PITCHES.values())) == len(PITCHES)


def test_a_bounce_is_heard_the_louder_the_faster() -> None:
    ear = Ear()
    assert tick(ear, [bounces([10.0, 20.0, 80.0])]) == 3  # type: ignore[arg-type]
    assert [name for name, _ in ear.heard] == ["segment"] * 3
    assert [volume for _, volume in ear.heard] == pytest.approx([LOUDEST, 0.5 * LOUDEST, 0.25 * LOUDEST])


def test_only_the_loudest_of_many_are_heard() -> None:
    ear = Ear()
    assert tick(ear, [bounces([float(speed) for speed in range(5, 5 + 2 * MOST)])]) == MOST  # type: ignore[arg-type]


def test_slow_impacts_and_silence_are_not_heard() -> None:
    assert tick(Ear(), [bounces([0.2])]) == 0  # type: ignore[arg-type]
    assert tick(Ear(silent=True), [bounces([20.0])]) == 0  # type: ignore[arg-type]
