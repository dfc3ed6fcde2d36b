"""The sounds of pinball: every event has one, and the speed of an impact is heard."""

import numpy as np
import pytest

from carom.play.pinball.rules.events import Event, EventKind
from carom.play.pinball.screen import sounds
from carom.play.sound import RATE


class Ear:
    """A speaker that notes what it is to play."""

    def __init__(self) -> None:
        self.heard: list[tuple[str, float]] = []

    def play(self, name: str, volume: float = 1.0) -> None:
        self.heard.append((name, volume))


@pytest.fixture(scope="module")
def waves() -> dict[str, np.ndarray]:
    return sounds.make()


def test_every_event_has_a_sound_that_is_made(waves: dict[str, np.ndarray]) -> None:
    assert set(sounds.VOICES) == set(EventKind)
    assert {voice.name for voice in sounds.VOICES.values()} | {"jackpot"} == set(waves)


def test_sounds_are_clean(waves: dict[str, np.ndarray]) -> None:
    for name, wave in waves.items():
        assert np.isfinite(wave).all(), name
        assert 0.2 < np.abs(wave).max() <= 1.0 + 1e-9, name
        assert 0.02 < len(wave) / RATE < 3.0, name
        assert abs(wave[0]) < 0.05, f"{name} begins with a click"
        assert abs(wave[-1]) < 0.05, f"{name} ends with a click"


def test_sounds_are_the_same_each_time(waves: dict[str, np.ndarray]) -> None:
    again = sounds.make()
    assert all(np.array_equal(again[name], wave) for name, wave in waves.items())


def test_harder_impacts_are_louder() -> None:
    volumes = [sounds.volume_of(speed) for speed in (-1.0, 0.0, 2.0, 20.0, 50.0, 500.0)]
    assert volumes == sorted(volumes)
    assert volumes[0] == 0.0
    assert volumes[-1] == 1.0
    soft, hard = (sounds.heard([Event(EventKind.BUMPER, speed=speed)])[0][1] for speed in (5.0, 40.0))
    assert soft < hard
    told = {sounds.heard([Event(EventKind.MULTIBALL, speed=speed)])[0][1] for speed in (0.0, 40.0)}
    assert len(told) == 1, "what is told has one volume"


def test_few_sounds_begin_at_once_the_loudest_of_each_name() -> None:
    events = [Event(EventKind.BOUNCE, speed=speed) for speed in (3.0, 30.0, 8.0)]
    assert sounds.heard(events) == sounds.heard(events[1:2])
    kinds = (EventKind.MULTIBALL, EventKind.BANK, EventKind.LANE, EventKind.DRAIN, EventKind.GATE, EventKind.TILT)
    loud = sounds.heard([Event(kind) for kind in kinds])
    assert len(loud) == sounds.AT_ONCE
    assert loud[0] == ("multiball", 1.0)
    assert "gate" not in dict(loud)


def test_a_jackpot_has_a_sound_of_its_own() -> None:
    assert sounds.heard([Event(EventKind.BANK, "jackpot")])[0][0] == "jackpot"


def test_a_demonstration_is_soft() -> None:
    game, demonstration = Ear(), Ear()
    events = [Event(EventKind.LANE)]
    sounds.play(game, events, False)
    sounds.play(demonstration, events, True)
    (name, volume), (same, softer) = game.heard[0], demonstration.heard[0]
    assert name == same
    assert softer == pytest.approx(sounds.DEMONSTRATION * volume)
