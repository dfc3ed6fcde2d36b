"""What the table says in words: how the game stands, what the shot would do, what happened last."""

from __future__ import annotations

from typing import TYPE_CHECKING

from carom.play.pool.game import Impact, Mark, Phase, Pool
from carom.play.pool.layout import BAD, GOLD, GOOD, IVORY, Colour
from carom.play.pool.preview import reaches, rest_before_impact, scratch
from carom.play.pool.session import Mode, Session

if TYPE_CHECKING:
    from carom.play.pool.preview import Preview


def headline(session: Session) -> tuple[str, Colour]:
    """The state of the game in a few words, and their colour."""
    pool = session.pool
    if Mode.PAUSE in session.modes:
        return "Paused", GOLD
    if pool.phase is Phase.WON:
        return "You win", GOOD
    if pool.phase is Phase.LOST:
        return "You lose", BAD
    if pool.phase is Phase.ROLL:
        return ("The eight is down", GOLD) if pool.eight.name in pool.potted else ("The balls roll", IVORY)
    if session.draw:
        return "Let go to shoot", GOLD
    return ("Pot the eight" if pool.shots == 0 else "Shoot again"), IVORY


def detail(session: Session) -> str:
    """A sentence below it: the impacts, the steps, or what the shot would do."""
    pool = session.pool
    if pool.over:
        return ending(pool)
    if pool.phase is Phase.ROLL and Mode.STEPS in session.modes:
        return f"{pool.age:.3f} s after the shot   ·   N: the next frame, B: on to the next impact, S: let them roll"
    if pool.phase is Phase.ROLL and Mode.IMPACTS in session.modes and pool.marks:
        return impact_line(pool.marks[-1])
    if pool.phase is Phase.ROLL:
        return "Now the cue ball must stay on the table" if pool.eight.name in pool.potted else "Hold Space to hurry"
    if session.dragging:
        return "Let the cue ball go where it is to lie on the base line"
    return outlook(pool, session.preview(), session.strength)


def outlook(pool: Pool, shown: Preview | None, power: float) -> str:
    """What a shot would do."""
    if shown is None:
        return "Nothing is in the way"
    if rest_before_impact(pool, shown, power) is not None:
        return "The cue ball stops before it meets anything"
    fall = scratch(pool, shown, power)
    if shown.eight is None:
        after = "" if shown.pocket else "meets a cushion first" + (", then it " if fall else "")
        return f"The cue ball {after}" + (f"falls into the {fall}" if fall else "")
    where = "meets a cushion" if shown.eight.pocket is None else f"goes to the {shown.eight.pocket}"
    if not reaches(pool, shown, shown.eight, shown.aim.other_speed, power):
        where = "stops before a cushion" if shown.eight.pocket is None else f"stops before the {shown.eight.pocket}"
    return f"The eight {where}" + (f", but the cue ball falls into the {fall}" if fall else "")


def ending(pool: Pool) -> str:
    """Why the game is over."""
    if pool.phase is Phase.LOST:
        both = ", and the eight fell too" if pool.eight.name in pool.potted else ""
        return f"The cue ball fell into the {pool.potted[pool.cue.name or ''].pocket}{both}"
    shots = "one shot" if pool.shots == 1 else f"{pool.shots} shots"
    return f"The eight fell into the {pool.potted[pool.eight.name or ''].pocket} after {shots}"


def impact_line(mark: Mark) -> str:
    """An impact in a sentence."""
    name = mark.balls[0][0]
    what = {
        Impact.BALLS: "the cue ball and the eight",
        Impact.CUSHION: f"the {name} and a cushion",
        Impact.POCKET: f"the {name} and the inside of a pocket",
    }[mark.impact]
    return f"Impact {mark.number}, {mark.time:.3f} s after the shot: {what}"


def tally(session: Session) -> str:
    """Shots and games."""
    shots = "1 shot" if session.pool.shots == 1 else f"{session.pool.shots} shots"
    return f"position {session.number + 1}  ·  {shots}  ·  won {session.won}  ·  lost {session.lost}"
