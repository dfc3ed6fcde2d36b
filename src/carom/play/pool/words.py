"""What the table says in words: how the game stands, what the shot would do, what happened last."""

from __future__ import annotations

from typing import TYPE_CHECKING

from carom.play.pool.game import NAMES, Impact, Mark, Phase, Pool
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
        return _rolling(pool)
    if session.draw:
        return "Let go to shoot", GOLD
    if pool.limit is None:
        return ("Pot the eight" if pool.shots == 0 else "Shoot again"), IVORY
    left = f"{_balls(len(pool.targets))} in {_shots(pool.limit - pool.used)}"
    if pool.shots > 0 and pool.in_hand:
        return f"Foul, cue ball in hand: {left}", BAD
    return (f"Pot {left}" if pool.shots == 0 else f"Shoot again: {left}"), IVORY


def _rolling(pool: Pool) -> tuple[str, Colour]:
    """What came of a shot so far, and its colour."""
    if pool.cue.name in pool.potted:
        return "Foul: the cue ball is down", BAD
    down = [name for name in pool.potted if name not in pool.gone]
    if not down:
        return "The balls roll", IVORY
    return (f"The {down[0]} is down" if len(down) == 1 else f"{len(down)} balls are down"), GOLD


def rule(pool: Pool) -> str:
    """The game's rules in a sentence or two."""
    if pool.limit is None:
        return "Pot the eight and keep the cue ball on the table."
    return (
        f"Pot {_balls(len(pool.balls) - 1)}, in any order, in {_shots(pool.limit)}. "
        "A potted cue ball costs one shot more, and comes back to the base line."
    )


def _shots(count: int) -> str:
    """Some shots in words."""
    return "one shot" if count == 1 else f"{count} shots"


def _balls(count: int) -> str:
    """Some balls in words."""
    return "one ball" if count == 1 else f"{count} balls"


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
        only = pool.limit is None and pool.eight.name in pool.potted
        return "Now the cue ball must stay on the table" if only else "Hold Space to hurry"
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
    if shown.struck is None:
        after = "" if shown.pocket else "meets a cushion first" + (", then it " if fall else "")
        return f"The cue ball {after}" + (f"falls into the {fall}" if fall else "")
    way, name = shown.struck, getattr(shown.aim.shape, "name", None)
    end = f"the {way.pocket or way.ball}" if way.pocket or way.ball else "a cushion"
    verb = "goes to" if way.pocket else "meets"
    if not reaches(pool, shown, way, shown.aim.other_speed, power):
        verb = "stops before"
    return f"The {name} {verb} {end}" + (f", but the cue ball falls into the {fall}" if fall else "")


def ending(pool: Pool) -> str:
    """Why the game is over."""
    if pool.limit is not None:
        fouls = {0: "", 1: " and a foul"}.get(pool.fouls, f" and {pool.fouls} fouls")
        left = len(pool.targets)
        still = f", and {_balls(left)} {'is' if left == 1 else 'are'} left" if left else ""
        done = "All balls are down after " if pool.phase is Phase.WON else f"You had {_shots(pool.limit)}: "
        return f"{done}{_shots(pool.shots)}{fouls}{still}"
    if pool.phase is Phase.LOST:
        both = ", and the eight fell too" if pool.eight.name in pool.potted else ""
        return f"The cue ball fell into the {pool.potted[pool.cue.name or ''].pocket}{both}"
    return f"The eight fell into the {pool.potted[pool.eight.name or ''].pocket} after {_shots(pool.shots)}"


def impact_line(mark: Mark) -> str:
    """An impact in a sentence."""
    name = mark.balls[0][0]
    what = {
        Impact.BALLS: " and ".join(f"the {ball}" for ball in sorted((ball for ball, _ in mark.balls), key=NAMES.count)),
        Impact.CUSHION: f"the {name} and a cushion",
        Impact.POCKET: f"the {name} and the inside of a pocket",
    }[mark.impact]
    return f"Impact {mark.number}, {mark.time:.3f} s after the shot: {what}"


def tally(session: Session) -> str:
    """Shots and games; where there are several balls, those that are down and the fouls too."""
    pool = session.pool
    stands = ["1 shot" if pool.shots == 1 else f"{pool.shots} shots"]
    if pool.limit is not None:
        balls = len(pool.balls) - 1
        fouls = "1 foul" if pool.fouls == 1 else f"{pool.fouls} fouls"
        stands = [f"{balls - len(pool.targets)} of {balls} down", f"shots {pool.shots} of {pool.limit}", fouls]
    return "  ·  ".join([f"position {session.number + 1}", *stands, f"won {session.won}", f"lost {session.lost}"])
