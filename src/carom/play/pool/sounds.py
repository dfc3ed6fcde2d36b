"""The sounds of a table."""

from __future__ import annotations

from carom.play.pool.game import Impact
from carom.play.sound import Wave, joined, mixed, noise, tone

#: kg·cm/s: the impulse of the loudest impact of each kind; softer ones are less loud.
LOUDEST = {Impact.STRIKE: 60.0, Impact.BALLS: 55.0, Impact.CUSHION: 90.0, Impact.POCKET: 60.0}

WON, LOST = "won", "lost"


def waves() -> dict[str, Wave]:
    """All sounds by name: one for each kind of impact, and those of the end."""
    rise = [tone(pitch, 0.16, fall=9.0, overtones=(1.0, 0.4, 0.15)) for pitch in (523.0, 659.0, 784.0)]
    return {
        Impact.STRIKE: mixed(tone(900.0, 0.06, fall=70.0), 0.8 * noise(0.05, fall=90.0, dull=0.3)),
        Impact.BALLS: mixed(tone(2350.0, 0.07, fall=75.0, overtones=(1.0, 0.3)), 0.5 * noise(0.02, fall=220.0, seed=2)),
        Impact.CUSHION: mixed(tone(95.0, 0.16, fall=26.0, to=70.0), 0.6 * noise(0.09, fall=45.0, dull=0.8, seed=3)),
        Impact.POCKET: joined(
            mixed(tone(150.0, 0.12, fall=22.0, to=90.0), 0.8 * noise(0.1, fall=35.0, dull=0.6, seed=4)),
            0.6 * mixed(tone(80.0, 0.3, fall=12.0, to=55.0), 0.5 * noise(0.3, fall=14.0, dull=0.9, seed=5)),
        ),
        WON: 0.6 * joined(*rise, tone(1047.0, 0.7, fall=4.0, overtones=(1.0, 0.4, 0.15))),
        LOST: 0.6 * joined(tone(294.0, 0.25, fall=5.0, to=277.0), tone(233.0, 0.7, fall=4.0, to=196.0)),
    }


def volume(impact: Impact, impulse: float) -> float:
    """How loud an impact is, from 0 to 1: as its impulse, with a square root so that soft ones are heard."""
    return float(min(1.0, impulse / LOUDEST[impact]) ** 0.5)
