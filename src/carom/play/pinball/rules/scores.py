"""High scores: the ten best with their initials, kept in a file of the user's."""

from __future__ import annotations

import os
import re
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path
from typing import Annotated

import platformdirs
from pydantic import BaseModel, ConfigDict, Field, ValidationError

#: How many scores are kept.
KEPT = 10
#: How many letters stand for a player, and which there are.
INITIALS = 3
LETTERS = "ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789.-"

_DEFAULT = (
    *(("ARC", 1_000_000), ("EDD", 750_000), ("KEP", 500_000), ("LER", 400_000), ("NEW", 300_000)),
    *(("TON", 250_000), ("EUL", 200_000), ("SIN", 150_000), ("BIL", 100_000), ("BAL", 50_000)),
)


#: Initials as the file holds them.
Initials = Annotated[str, Field(pattern=f"^[{re.escape(LETTERS)}]{{{INITIALS}}}$")]


class Score(BaseModel):
    """A score and who made it."""

    model_config = ConfigDict(frozen=True, strict=True, extra="forbid")

    initials: Initials
    """Who made it: three letters."""
    score: Annotated[int, Field(ge=0, lt=10**12)]
    """How much."""


class _File(BaseModel):
    """What the file holds."""

    model_config = ConfigDict(strict=True, extra="forbid")

    version: Annotated[int, Field(ge=1, le=1)]
    scores: Annotated[list[Score], Field(max_length=KEPT)]
    last: Initials = LETTERS[0] * INITIALS


def default_path() -> Path:
    """The file in the user's data folder."""
    return Path(platformdirs.user_data_path("carom")) / "pinball.json"


class HighScores:
    """The ten best scores, best first, and `last`, the initials that were entered last.

    They are kept in memory alone where there is no path.

    >>> scores = HighScores()
    >>> scores.place(800_000), scores.best.score
    (1, 1000000)
    """

    def __init__(
        self, scores: list[Score] | None = None, path: Path | None = None, tell: Callable[[str], None] | None = None
    ) -> None:
        found = [Score(initials=who, score=score) for who, score in _DEFAULT] if scores is None else list(scores)
        self.scores: list[Score] = sorted(found, key=lambda entry: -entry.score)[:KEPT]
        self.last = LETTERS[0] * INITIALS
        self.path = path
        self._tell = tell or (lambda _: None)

    @classmethod
    def load(cls, path: Path | None = None, tell: Callable[[str], None] | None = None) -> HighScores:
        """The scores in the file at `path`, by default in the user's data folder; the default ones where it has none.

        A file that is damaged is kept aside under another name, and said so through `tell`.
        """
        where = default_path() if path is None else path
        say = tell or (lambda _: None)
        try:
            text = where.read_bytes()
        except FileNotFoundError:
            return cls(None, where, say)
        except OSError as error:
            say(f"The high scores in {where} cannot be read ({error.strerror}); the game begins with others.")
            return cls(None, where, say)
        try:
            file = _File.model_validate_json(text)
        except ValidationError:
            aside = _put_aside(where)
            kept = f"they are kept as {aside.name}" if aside else "they stay as they are, and new ones are not kept"
            say(f"The high scores in {where} are damaged; {kept}. The game begins with others.")
            return cls(None, where if aside else None, say)
        found = cls(file.scores, where, say)
        found.last = file.last
        return found

    @property
    def best(self) -> Score:
        """The highest score; nobody's 0 where there is none."""
        return self.scores[0] if self.scores else Score(initials="---", score=0)

    def place(self, score: int) -> int | None:
        """The place, from 0, that a score would take; None where it is not among the ten best, or 0."""
        place = sum(entry.score >= score for entry in self.scores)
        return place if place < KEPT and score > 0 else None

    def add(self, initials: str, score: int) -> int | None:
        """The place, from 0, that a score has taken; None where it is not among the ten best. Writes the file."""
        place = self.place(score)
        if place is not None:
            self.scores.insert(place, Score(initials=initials, score=score))
            del self.scores[KEPT:]
            self.last = initials
            self.save()
        return place

    def save(self) -> None:
        """Write the file, whole or not at all. Where that fails, tell so: the game goes on."""
        if self.path is None:
            return
        content = _File(version=1, scores=self.scores, last=self.last).model_dump_json(indent=2) + "\n"
        beside = self.path.with_name(f".{self.path.name}.{os.getpid()}")
        try:
            self.path.parent.mkdir(parents=True, exist_ok=True)
            beside.write_text(content, encoding="utf-8")
            beside.replace(self.path)
        except OSError as error:
            with suppress(OSError):
                beside.unlink()
            self._tell(f"The high scores cannot be kept in {self.path} ({error.strerror}); they last until you leave.")


def _put_aside(path: Path) -> Path | None:
    """The free name that a damaged file was given; None where it cannot be renamed."""
    names = (path.with_name(f"{path.name}.damaged{'' if n == 1 else n}") for n in range(1, 1000))
    aside = next((name for name in names if not name.exists()), None)
    if aside is None:
        return None
    try:
        path.rename(aside)
    except OSError:
        return None
    return aside
