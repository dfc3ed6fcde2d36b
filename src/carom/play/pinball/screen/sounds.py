"""The sounds of the pinball table, all of them made by the program, and which one an event has."""

from __future__ import annotations

from collections.abc import Iterable
from typing import NamedTuple

import numpy as np

from carom.play.pinball.rules.events import Event, EventKind
from carom.play.sound import RATE, Speaker, Wave, faded, joined, mixed, noise, tone

#: Overtones of a bell, of a reed, of a buzzer.
BELL = (1.0, 0.1, 0.45, 0.05, 0.25)
REED = (1.0, 0.5, 0.33, 0.25, 0.2)
BUZZ = (1.0, 0.0, 0.6, 0.0, 0.5, 0.0, 0.4)
#: Sounds that begin in one frame at most.
AT_ONCE = 4
#: The speed of the impact, in units/s, that is as loud as can be; softer ones by the power of that part of it.
LOUDEST, POWER = 55.0, 0.8
#: How loud the demonstration is.
DEMONSTRATION = 0.3


class Voice(NamedTuple):
    """The sound of an event: its name, how loud it is, and whether the speed of the impact says how loud."""

    name: str
    volume: float
    by_speed: bool = False


VOICES: dict[EventKind, Voice] = {
    EventKind.BOUNCE: Voice("tick", 0.5, by_speed=True),
    EventKind.BUMPER: Voice("bumper", 0.9, by_speed=True),
    EventKind.SLINGSHOT: Voice("slingshot", 0.8, by_speed=True),
    EventKind.TARGET: Voice("target", 0.9, by_speed=True),
    EventKind.FLIPPER_HIT: Voice("knock", 0.7, by_speed=True),
    EventKind.LAUNCH: Voice("launch", 0.9, by_speed=True),
    EventKind.BANK: Voice("bank", 0.8),
    EventKind.LANE: Voice("lane", 0.5),
    EventKind.LANES: Voice("lanes", 0.7),
    EventKind.ORBIT: Voice("orbit", 0.7),
    EventKind.INLANE: Voice("inlane", 0.45),
    EventKind.OUTLANE: Voice("outlane", 0.6),
    EventKind.SPINNER: Voice("spinner", 0.35),
    EventKind.SAUCER: Voice("saucer", 0.8),
    EventKind.KICKOUT: Voice("slingshot", 0.7),
    EventKind.GATE: Voice("gate", 0.3),
    EventKind.FLIPPER: Voice("flipper", 0.5),
    EventKind.SERVE: Voice("serve", 0.5),
    EventKind.DRAIN: Voice("drain", 0.7),
    EventKind.SAVE: Voice("save", 0.8),
    EventKind.EXTRA: Voice("extra", 0.9),
    EventKind.MULTIBALL: Voice("multiball", 1.0),
    EventKind.MODE: Voice("lanes", 0.8),
    EventKind.MORE: Voice("save", 0.7),
    EventKind.SHOT: Voice("orbit", 0.6),
    EventKind.FEAT: Voice("extra", 0.8),
    EventKind.NUDGE: Voice("nudge", 0.6),
    EventKind.WARNING: Voice("warning", 0.7),
    EventKind.TILT: Voice("tilt", 0.9),
    EventKind.BONUS: Voice("bonus", 0.4),
    EventKind.KNOCK: Voice("replay", 1.0),
    EventKind.FREED: Voice("nudge", 0.5),
    EventKind.GAME_START: Voice("start", 0.7),
    EventKind.GAME_OVER: Voice("over", 0.8),
}


def note(number: float) -> float:
    """The frequency of a note, in semitones from the A of 440 Hz."""
    return float(440.0 * 2.0 ** (number / 12.0))


def tune(
    numbers: Iterable[float], seconds: float, overtones: tuple[float, ...] = REED, last: float = 0.0, fall: float = 6.0
) -> Wave:
    """Notes one after the other, the last one held for some seconds more."""
    notes = list(numbers)
    return joined(
        *(tone(note(number), seconds, fall=fall, overtones=overtones) for number in notes[:-1]),
        tone(note(notes[-1]), seconds + last, fall=fall / 2.0, overtones=overtones),
    )


def chord(numbers: Iterable[float], seconds: float, fall: float = 4.0, overtones: tuple[float, ...] = BELL) -> Wave:
    """Notes at once."""
    return mixed(*(tone(note(number), seconds, fall=fall, overtones=overtones) for number in numbers))


def whoosh(seconds: float) -> Wave:
    """Wind that comes and goes, and a tone that rises in it."""
    times = np.arange(round(seconds * RATE)) / RATE
    swell = np.sin(np.pi * times / seconds) ** 2
    return mixed(0.7 * noise(seconds, dull=0.35, seed=5) * swell, 0.45 * tone(260.0, seconds, to=1150.0) * swell)


def make() -> dict[str, Wave]:
    """Every sound by its name."""
    return {**_struck(), **_crossed(), **_told()}


def _struck() -> dict[str, Wave]:
    """The sounds of what balls strike, and of coils."""
    return {
        "tick": mixed(0.8 * noise(0.03, fall=130.0, dull=0.3), 0.5 * tone(1900.0, 0.04, fall=110.0)),
        "bumper": mixed(
            tone(120.0, 0.22, fall=20.0, to=48.0),
            0.5 * noise(0.05, fall=80.0, dull=0.4),
            0.55 * tone(note(12), 0.5, fall=9.0, overtones=BELL),
        ),
        "slingshot": mixed(
            0.8 * noise(0.07, fall=55.0, dull=0.25), tone(260.0, 0.15, fall=24.0, to=90.0, overtones=REED)
        ),
        "target": mixed(
            0.7 * noise(0.04, fall=90.0, dull=0.3), tone(620.0, 0.16, fall=30.0), 0.4 * tone(note(19), 0.3, fall=12.0)
        ),
        "knock": mixed(0.5 * noise(0.04, fall=90.0, dull=0.5), tone(210.0, 0.1, fall=45.0)),
        "flipper": mixed(0.8 * noise(0.035, fall=90.0, dull=0.5), tone(85.0, 0.1, fall=38.0, to=60.0, overtones=REED)),
        "launch": mixed(
            tone(90.0, 0.35, fall=9.0, to=320.0, overtones=REED), 0.8 * noise(0.12, fall=30.0, dull=0.5, seed=3)
        ),
        "serve": joined(
            mixed(noise(0.05, fall=60.0, dull=0.6), tone(110.0, 0.09, fall=35.0)),
            0.5 * mixed(noise(0.04, fall=80.0, dull=0.6), tone(140.0, 0.07, fall=45.0)),
        ),
        "nudge": mixed(tone(62.0, 0.2, fall=18.0), 0.4 * noise(0.12, fall=28.0, dull=0.9)),
        "replay": mixed(noise(0.09, fall=45.0, dull=0.3), tone(150.0, 0.3, fall=18.0, to=80.0, overtones=REED)),
        "gate": 0.7 * mixed(tone(2600.0, 0.05, fall=80.0), tone(3300.0, 0.05, fall=90.0)),
    }


def _crossed() -> dict[str, Wave]:
    """The sounds of what balls roll over, and where they go."""
    return {
        "lane": tone(note(19), 0.5, fall=8.0, overtones=BELL),
        "lanes": tune((7, 12, 16, 19, 24), 0.075, BELL, last=0.5),
        "orbit": whoosh(0.55),
        "inlane": tune((14, 21), 0.07, BELL, last=0.2),
        "outlane": tune((2, -3, -8), 0.09, REED, last=0.15),
        "spinner": mixed(tone(1400.0, 0.05, fall=60.0), 0.6 * noise(0.02, fall=150.0)),
        "saucer": mixed(
            tone(95.0, 0.16, fall=22.0, to=60.0), tone(note(-5), 0.9, fall=2.5, to=note(19), overtones=BELL)
        ),
        "drain": mixed(
            tone(330.0, 0.9, fall=2.2, to=58.0, overtones=REED), 0.3 * noise(0.9, fall=4.0, dull=0.9, seed=9)
        ),
        "save": tune((7, 12, 19), 0.09, REED, last=0.35),
    }


def _told() -> dict[str, Wave]:
    """The sounds of what the rules tell."""
    return {
        "bank": mixed(tune((4, 7, 11, 16), 0.08, BELL, last=0.5), chord((-8, -1, 4), 0.9)),
        "jackpot": mixed(
            tune((12, 16, 19, 24, 19, 24, 28, 31, 36), 0.065, BELL, last=0.7), chord((0, 7, 12, 16), 1.3, fall=2.5)
        ),
        "multiball": mixed(
            joined(tune((0, 0, 0, 5, 9, 12), 0.11, REED), tune((9, 12, 17, 21, 24), 0.09, REED, last=0.8)),
            joined(chord((-12, -5), 0.66, overtones=REED), chord((-7, -3, 0, 5), 1.25, fall=2.0, overtones=REED)),
        ),
        "extra": tune((12, 12, 19, 16, 19, 24), 0.1, BELL, last=0.6),
        "warning": joined(
            tone(196.0, 0.12, overtones=BUZZ), faded(np.zeros(2000), 0.0), tone(196.0, 0.16, overtones=BUZZ)
        ),
        "tilt": tone(220.0, 1.1, fall=1.2, to=55.0, overtones=BUZZ),
        "bonus": tone(note(24), 0.09, fall=28.0, overtones=BELL),
        "start": mixed(tune((0, 4, 7, 12, 16, 19, 24), 0.07, REED, last=0.5), chord((-12, -5, 0), 0.9)),
        "over": joined(tune((12, 11, 9, 7), 0.17, REED), tune((5, 4), 0.2, REED), chord((0, -5, -12), 1.2, fall=2.5)),
    }


def volume_of(speed: float) -> float:
    """How loud an impact of a speed is, from 0 to 1."""
    return float(min(1.0, max(0.0, speed) / LOUDEST) ** POWER)


def heard(events: Iterable[Event]) -> list[tuple[str, float]]:
    """The sounds of the events of one frame with their volumes: each once, the loudest, and no more than a few."""
    loudest: dict[str, float] = {}
    for event in events:
        voice = VOICES[event.kind]
        name = "jackpot" if event.part == "jackpot" else voice.name
        volume = voice.volume * (volume_of(event.speed) if voice.by_speed else 1.0)
        loudest[name] = max(volume, loudest.get(name, 0.0))
    return sorted(loudest.items(), key=lambda entry: -entry[1])[:AT_ONCE]


def play(speaker: Speaker, events: Iterable[Event], demonstration: bool) -> None:
    """Play the sounds of the events of a frame, softly while the table demonstrates itself."""
    share = DEMONSTRATION if demonstration else 1.0
    for name, volume in heard(events):
        speaker.play(name, share * volume)
