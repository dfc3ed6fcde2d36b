"""Sounds that the program makes itself, and the speaker that plays them."""

from __future__ import annotations

from typing import TYPE_CHECKING, TypeAlias

import numpy as np
import pygame
from numpy.typing import NDArray

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping

#: A sound: mono, from -1 to 1, `RATE` values a second.
Wave: TypeAlias = NDArray[np.float64]

#: Values a second.
RATE = 44_100
#: Values that the sound card takes at a time: 12 ms, so that a sound is heard when its impact is seen.
CHUNK = 512
#: How many sounds are heard at once.
VOICES = 24
#: Quieter sounds than this are not heard, and take no voice.
FAINTEST = 0.02


class Speaker:
    """Plays sounds; without a sound card it says so once and is silent.

    Args:
        sounds: The sounds by name.
        tell: Told in one line why there is no sound.
    """

    def __init__(self, sounds: Mapping[str, Wave], tell: Callable[[str], None]) -> None:
        self.muted = False
        self._sounds: dict[str, pygame.mixer.Sound] = {}
        try:
            pygame.mixer.init(RATE, -16, 1, CHUNK, allowedchanges=0)
            pygame.mixer.set_num_channels(VOICES)
            self._sounds = {name: pygame.mixer.Sound(buffer=samples(wave)) for name, wave in sounds.items()}
        except pygame.error as error:
            tell(f"no sound: {error}")

    @property
    def silent(self) -> bool:
        """Whether there is no sound card, or it is muted."""
        return self.muted or not self._sounds

    def play(self, name: str, volume: float = 1.0) -> None:
        """Play a sound, as loud as `volume` from 0 to 1 says, if a voice is free."""
        if self.silent or volume < FAINTEST:
            return
        channel = self._sounds[name].play()
        if channel is not None:
            channel.set_volume(min(1.0, volume))

    def stop(self) -> None:
        """End all sounds."""
        if self._sounds:
            pygame.mixer.stop()


def samples(wave: Wave) -> bytes:
    """A sound as 16-bit numbers."""
    return np.round(32_767.0 * np.clip(wave, -1.0, 1.0)).astype("<i2").tobytes()


def tone(
    frequency: float,
    seconds: float,
    *,
    fall: float = 0.0,
    overtones: tuple[float, ...] = (1.0,),
    to: float | None = None,
) -> Wave:
    """A tone that fades.

    Args:
        frequency: Of its fundamental, in hertz.
        seconds: How long it is.
        fall: How fast it fades: it is e times fainter after 1 / `fall` seconds.
        overtones: How strong the fundamental and each of its multiples are.
        to: The frequency that it glides to, if it does.
    """
    times = np.arange(round(seconds * RATE)) / RATE
    end = frequency if to is None else to
    phase = 2.0 * np.pi * (frequency * times + 0.5 * (end - frequency) * times * times / seconds)
    wave = sum(strength * np.sin((k + 1) * phase) for k, strength in enumerate(overtones))
    return faded(np.asarray(wave) / sum(overtones), fall)


def noise(seconds: float, *, fall: float = 0.0, dull: float = 0.0, seed: int = 1) -> Wave:
    """Noise that fades, the duller the nearer `dull` is to 1; the same for the same `seed`."""
    wave = np.random.default_rng(seed).uniform(-1.0, 1.0, round(seconds * RATE))
    if dull > 0.0:
        # A moving mean takes the high frequencies away.
        width = max(1, round(dull * dull * 0.004 * RATE))
        wave = np.convolve(wave, np.full(width, 1.0 / width), mode="same")
        wave /= np.abs(wave).max()
    return faded(wave, fall)


def faded(wave: Wave, fall: float) -> Wave:
    """A sound that begins within a millisecond, fades, and ends without a click."""
    count = len(wave)
    times = np.arange(count) / RATE
    edge = np.minimum(1.0, np.minimum(times / 0.001, times[::-1] / 0.004))
    return wave * np.exp(-fall * times) * edge


def mixed(*waves: Wave) -> Wave:
    """Sounds at once, as loud as the loudest of them."""
    longest = max(len(wave) for wave in waves)
    together = np.sum([np.pad(wave, (0, longest - len(wave))) for wave in waves], axis=0)
    loudest = max(float(np.abs(wave).max()) for wave in waves)
    return np.asarray(together * loudest / max(1e-9, float(np.abs(together).max())))


def joined(*waves: Wave) -> Wave:
    """Sounds one after the other."""
    return np.concatenate(waves)
