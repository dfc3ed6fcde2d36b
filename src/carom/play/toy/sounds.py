"""The toy's ticks: another pitch for each kind of shape, the louder the faster the impact."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import carom
from carom.play.sound import Speaker, Wave, tone

#: The pitch of each kind of shape, in hertz: notes of one chord, the lowest for what is longest.
PITCHES: Mapping[str, float] = {
    "segment": 392.0,
    "arc": 523.3,
    "gate": 587.3,
    "circle": 784.0,
    "point": 1046.5,
    "ball": 1568.0,
}
#: Speed of the loudest impact, how loud that is, and below which speed there is nothing to hear.
LOUDEST_SPEED, LOUDEST, SOFTEST_SPEED = 40.0, 0.6, 0.5
#: Ticks of one frame at most: the loudest.
MOST = 4


def ticks() -> dict[str, Wave]:
    """A short tone for each kind of shape."""
    return {kind: tone(pitch, 0.09, fall=55.0, overtones=(1.0, 0.35, 0.12)) for kind, pitch in PITCHES.items()}


def tick(speaker: Speaker, parts: Sequence[carom.Hits]) -> int:
    """How many ticks were played for the hits of a frame."""
    if speaker.silent:
        return 0
    bounces = [
        hit
        for hits in parts
        for hit in hits
        if hit.kind == carom.HitKind.BOUNCE and hit.speed > SOFTEST_SPEED and hit.shape is not None
    ]
    loudest = sorted(bounces, key=lambda hit: -hit.speed)[:MOST]
    for hit in loudest:
        speaker.play(hit.shape.kind, LOUDEST * min(1.0, hit.speed / LOUDEST_SPEED))
    return len(loudest)
