"""The panel beside the stage: name, facts, legend, notes."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from textwrap import wrap
from typing import TYPE_CHECKING, TypeAlias

from carom.draw.paint.painter import Lettering, Style
from carom.draw.parts.frame import PANEL_WIDTH

if TYPE_CHECKING:
    from carom.draw.paint.painter import Painter, Vector
    from carom.draw.parts.frame import Frame

    #: Draws a sample of a mark, `GLYPH_WIDTH` wide, its middle at a pixel.
    Glyph: TypeAlias = Callable[[Painter, Frame, Vector], None]

#: Pixels: the legend's samples, and from them to their words.
GLYPH_WIDTH = 28.0
GLYPH_GAP = 12.0
#: Pixels from one line to the next: facts and legend, shares, caption, notes.
ROW, SHARE_ROW, CAPTION_ROW, NOTE_ROW = 22.0, 25.0, 17.0, 15.0
#: Pixels: how far the bar of a share is below its words, and how thick it is.
BAR_DROP, BAR_WIDTH = 6.5, 2.0
#: Pixels from the last line of a part to the rule below it.
RULE_GAP = 16.0
#: Mean width of a character, in heights of a letter: to break lines without knowing the reader's font.
CHARACTER_WIDTH = 0.55

NAME = Lettering("text", 24.0, bold=True)
CAPTION = Lettering("muted", 12.5)
LABEL = Lettering("muted", 13.0)
VALUE = Lettering("text", 13.0, bold=True, anchor="end")
ENTRY = Lettering("text", 13.0)
SHARE = Lettering("text", 12.0)
BAR = Style("hit", width=BAR_WIDTH, opacity=0.7)
BAR_GROUND = Style("rule", width=BAR_WIDTH)
NOTE = Lettering("muted", 11.0)
RULE = Style("rule", width=1.0)


@dataclass(frozen=True, slots=True)
class Line:
    """A line of the panel: the pixels from the line above to its baseline, and what is drawn there."""

    advance: float
    words: str = ""
    lettering: Lettering = ENTRY
    offset: float = 0.0  # pixels from the panel's left edge to the words
    value: str = ""  # at the panel's right edge
    glyph: Glyph | None = None
    share: float | None = None  # of a bar below the line
    rule: bool = False
    fact: bool = False

    def draw(self, painter: Painter, frame: Frame, baseline: float) -> None:
        """Draw the line at a height in pixels."""
        left = frame.panel_left
        if self.rule:
            _stripe(painter, frame, baseline, 1.0, RULE)
        if self.words:
            painter.text(frame.world(left + self.offset, baseline), self.words, self.lettering)
        if self.value:
            painter.text(frame.world(left + PANEL_WIDTH, baseline), self.value, VALUE)
        if self.glyph is not None:
            self.glyph(painter, frame, (left + 0.5 * GLYPH_WIDTH, baseline - 0.35 * ENTRY.size))
        if self.share is not None:
            _stripe(painter, frame, baseline + BAR_DROP, 1.0, BAR_GROUND)
            _stripe(painter, frame, baseline + BAR_DROP, self.share, BAR)


@dataclass(frozen=True, slots=True)
class Panel:
    """What the panel says: name, caption, facts (label and value), shares, legend entries (words and sample), notes.

    Shares are labels with counts, the largest first; each has a bar.
    """

    name: str
    caption: str = ""
    facts: tuple[tuple[str, str], ...] = ()
    shares: tuple[tuple[str, int], ...] = ()
    entries: tuple[tuple[str, Glyph], ...] = ()
    notes: tuple[str, ...] = ()

    @property
    def height(self) -> float:
        """How many pixels the panel needs, from its top to its last line."""
        return sum(line.advance for line in self._lines())

    def draw_still(self, painter: Painter, frame: Frame, top: float) -> None:
        """Draw the panel without its facts, its upper edge at pixel `top`."""
        self._draw(painter, frame, top, facts=False)

    def draw_facts(self, painter: Painter, frame: Frame, top: float) -> None:
        """Draw the facts of the panel whose upper edge is at pixel `top`."""
        self._draw(painter, frame, top, facts=True)

    def _draw(self, painter: Painter, frame: Frame, top: float, *, facts: bool) -> None:
        """Draw the lines that are facts, or all others."""
        for line in self._lines():
            top += line.advance
            if line.fact == facts:
                line.draw(painter, frame, top)

    def _lines(self) -> list[Line]:
        """All lines, from top to bottom, a rule between any two parts."""
        head = [Line(NAME.size, shortened(self.name, NAME), NAME)]
        caption = broken(self.caption, CAPTION)
        head += [Line(CAPTION_ROW if row else 1.4 * CAPTION_ROW, words, CAPTION) for row, words in enumerate(caption)]
        facts = [Line(ROW, label, LABEL, value=value, fact=True) for label, value in self.facts]
        shares = [
            Line(SHARE_ROW, shortened(label, SHARE), SHARE, value=f"{count:,}", share=count / self.shares[0][1])
            for label, count in self.shares
        ]
        offset = GLYPH_WIDTH + GLYPH_GAP
        entries = [Line(ROW, words, ENTRY, offset, glyph=glyph) for words, glyph in self.entries]
        notes = [Line(NOTE_ROW, words, NOTE) for note in self.notes for words in broken(note, NOTE)]
        below = [part for part in (facts, shares, entries, notes) if part]
        return [*head, *(line for part in below for line in (Line(RULE_GAP, rule=True), Line(0.5 * RULE_GAP), *part))]


def _stripe(painter: Painter, frame: Frame, y: float, share: float, style: Style) -> None:
    """Draw a line at a height in pixels, over a share (0 to 1) of the panel's width."""
    ends = (frame.world(frame.panel_left + x, y) for x in (0.0, share * PANEL_WIDTH))
    painter.segment(next(ends), next(ends), style)


def room(lettering: Lettering) -> int:
    """How many characters of some lettering a line of the panel holds, more or less."""
    return int(PANEL_WIDTH / (CHARACTER_WIDTH * lettering.size))


def broken(words: str, lettering: Lettering) -> list[str]:
    """`words` as lines that the panel holds."""
    return wrap(words, room(lettering))


def shortened(words: str, lettering: Lettering) -> str:
    """`words`, their end replaced by an ellipsis where the panel cannot hold it."""
    longest = room(lettering)
    return words if len(words) <= longest else words[: longest - 1] + "…"
