"""The panel at the side of the toy: buttons and sliders that act on the desk, and figures between them."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

import pygame
import pygame_gui

from carom.play.letters import Letters
from carom.play.pen import Pen
from carom.play.toy import colours
from carom.play.toy.desk import Desk
from carom.play.toy.items import ROWS, Buttons, Choice, Gauge, Heading, Numbers, Row, Slider
from carom.play.toy.sentences import SENTENCES

#: Pixels: the space at the sides, between buttons, and from where on a row's slider or buttons stand.
SIDE, GAP, LABELS, VALUES = 16, 5, 96, 40
#: Pixels that each kind of row is high, and its buttons or slider in it.
HEIGHTS: Mapping[type, int] = {Gauge: 48, Heading: 28, Numbers: 36, Slider: 22, Choice: 28, Buttons: 29}
BUTTON, TRACK = 24, 14
#: Letters: what a button of a choice is wider than its words.
SPARE = 5
#: Positions that a slider can stand at; more than it has pixels.
POSITIONS = 1000
#: Pixels: how far from a knob the mouse still drags it.
HOLD = 4000
#: Pixels: letters of labels, of figures, of headings.
SMALL, LARGE = 12, 15
MOUSE = {pygame.MOUSEMOTION, pygame.MOUSEBUTTONDOWN, pygame.MOUSEBUTTONUP}


class Manager(pygame_gui.UIManager):
    """Keeps pygame_gui's buttons; told where the mouse is by its events, as the rest of the toy is."""

    pointer: tuple[int, int] = (-1, -1)

    def _update_mouse_position(self) -> None:
        self.mouse_position = self.pointer


class Panel:
    """Buttons, sliders and figures in a column of `size` pixels whose left upper corner is `corner`.

    It is drawn `times` as large; all places are those of a panel that is not.

    Attributes:
        places: Where each button and the knob of each slider is, in the window: a slider by its name, a button by its
            name, one of a choice by name and value.
    """

    def __init__(
        self, desk: Desk, letters: Letters, corner: tuple[int, int], size: tuple[int, int], times: int = 1
    ) -> None:
        self._desk = desk
        self._area = pygame.Rect(corner, size)
        self._times = times
        large = (size[0] * times, size[1] * times)
        self._manager = Manager(large, colours.theme(times))
        self._picture = pygame.Surface(large)
        self._pen = Pen(self._picture, letters, times)
        self._buttons: dict[Any, tuple[str, Any]] = {}
        self._sliders: dict[Any, Slider] = {}
        self._texts: dict[str, str] = {}
        self._share = 0.0
        self._rows: list[tuple[Row, int]] = []
        self._busy = True
        self._lay_out()
        self.agree()

    # -- making it ---------------------------------------------------------------------------------------------------

    def _lay_out(self) -> None:
        """Make the buttons and sliders, row by row."""
        makers: Mapping[type, Callable[[Any, int], None]] = {
            Slider: self._make_slider,
            Choice: self._make_choice,
            Buttons: self._make_buttons,
        }
        y = 0
        for row in ROWS:
            self._rows.append((row, y))
            if type(row) in makers:
                makers[type(row)](row, y)
            y += HEIGHTS[type(row)]

    def _make_slider(self, row: Slider, y: int) -> None:
        width = self._area.width - 2 * SIDE - LABELS - VALUES
        rect = pygame.Rect(SIDE + LABELS, y + (HEIGHTS[Slider] - TRACK) // 2, width, TRACK)
        slider = pygame_gui.elements.UIHorizontalSlider(self._pen.area(rect), 0, (0, POSITIONS), self._manager)
        knob: Any = slider.sliding_button
        knob.set_hold_range((HOLD, HOLD))
        self._sliders[slider] = row

    def _make_choice(self, row: Choice, y: int) -> None:
        left = SIDE + LABELS
        letters = sum(len(words) + SPARE for _, words in row.options)
        unit = (self._area.width - SIDE - left + GAP) / letters
        x = float(left)
        for value, words in row.options:
            width = unit * (len(words) + SPARE)
            self._button((row.name, value), words, round(x), y, round(width) - GAP)
            x += width

    def _make_buttons(self, row: Buttons, y: int) -> None:
        width = (self._area.width - 2 * SIDE + GAP) / len(row.buttons)
        for place, (name, words) in enumerate(row.buttons):
            self._button((name, None), words, round(SIDE + place * width), y, round(width) - GAP)

    def _button(self, meaning: tuple[str, Any], words: str, x: int, y: int, width: int) -> None:
        rect = self._pen.area(pygame.Rect(x, y + 2, width, BUTTON))
        name = "#danger" if meaning[0] in ("clear", "quit") else "#plain"
        self._buttons[pygame_gui.elements.UIButton(rect, words, self._manager, object_id=name)] = meaning

    @property
    def places(self) -> dict[Any, pygame.Rect]:
        """Where buttons and the knobs of sliders are, in the window's pixels."""
        knobs = {row.name: slider.sliding_button.rect for slider, row in self._sliders.items()}
        buttons = {
            name if value is None else (name, value): button.rect for button, (name, value) in self._buttons.items()
        }
        return {
            name: pygame.Rect(*(side // self._times for side in rect)).move(self._area.topleft)
            for name, rect in (knobs | buttons).items()
        }

    # -- what happens ------------------------------------------------------------------------------------------------

    def holds(self, place: tuple[int, int]) -> bool:
        """Whether a place in the window is on the panel."""
        return bool(self._area.collidepoint(place))

    def sentence(self, place: tuple[int, int]) -> str:
        """What the control or the figure at a place in the window means; "" where there is none."""
        if not self.holds(place):
            return ""
        x, y = place[0] - self._area.left, place[1] - self._area.top
        row = next((row for row, top in self._rows if top <= y < top + HEIGHTS[type(row)]), None)
        spot = self._pen.at((x, y))
        on = next((meaning for button, meaning in self._buttons.items() if button.rect.collidepoint(spot)), None)
        if on is not None:
            name, value = on
            return SENTENCES[name if value is None else (name, value)]
        if isinstance(row, Numbers):
            part = int((x - SIDE) * len(row.figures) / (self._area.width - 2 * SIDE))
            return SENTENCES[row.figures[min(max(part, 0), len(row.figures) - 1)][0]]
        if isinstance(row, Slider | Choice):
            return SENTENCES[row.name]
        return SENTENCES["load"] if isinstance(row, Gauge) else ""

    def handle(self, event: pygame.event.Event) -> None:
        """Take an event of the window."""
        if event.type == pygame_gui.UI_BUTTON_PRESSED and event.ui_element in self._buttons:
            self._press(*self._buttons[event.ui_element])
        elif event.type == pygame_gui.UI_HORIZONTAL_SLIDER_MOVED and event.ui_element in self._sliders:
            self._slide(self._sliders[event.ui_element], event.value / POSITIONS)
        elif event.type in MOUSE:
            left, top = self._area.topleft
            place = ((event.pos[0] - left) * self._times, (event.pos[1] - top) * self._times)
            was_in, self._manager.pointer = self._busy, place
            self._busy = self.holds(event.pos) or was_in
            self._manager.process_events(pygame.event.Event(event.type, event.dict | {"pos": place}))

    def _press(self, name: str, value: Any) -> None:
        """Do what a button means."""
        if value is not None:
            self._desk.change(name, value)
        else:
            self._desk.press(name)
        self.agree()

    def _slide(self, row: Slider, part: float) -> None:
        """Set what a slider means."""
        value = row.at(part)
        if value != self._desk.value(row.name):
            self._desk.change(row.name, value)
        self._busy = True

    def agree(self) -> None:
        """Show the desk's settings, which keys may have changed."""
        for button, (name, value) in self._buttons.items():
            on = self._desk.value(name) == value if value is not None else self._desk.is_on(name)
            if on:
                button.select()  # anew where it was selected: a click has drawn it as if it were not
            elif button.is_selected:
                button.unselect()
        for slider, row in self._sliders.items():
            if not slider.sliding_button.held:
                slider.set_current_value(round(POSITIONS * row.part(self._desk.value(row.name))))
        self._busy = True

    def advance(self, seconds: float) -> None:
        """Move what is being dragged, if the mouse is here."""
        if self._busy:
            self._manager.update(seconds)

    def show(self, texts: dict[str, str], share: float) -> None:
        """Show `texts` as the figures, and that frames take `share` of their time."""
        if texts != self._texts or abs(share - self._share) > 0.01:
            self._texts, self._share, self._busy = texts, share, True

    # -- its picture -------------------------------------------------------------------------------------------------

    def draw(self, surface: pygame.Surface) -> None:
        """Draw the panel into the window, anew where something on it may have changed."""
        if self._busy:
            self._redraw()
            self._busy = self._picture.get_rect().collidepoint(self._manager.pointer)
        surface.blit(self._picture, self._pen.area(self._area))

    def _redraw(self) -> None:
        """Draw all rows, then buttons and sliders."""
        self._picture.fill(colours.STAGE)
        self._pen.line(colours.RULE, (0, 0), (0, self._area.height))
        drawers: Mapping[type, Callable[[Any, int], None]] = {
            Gauge: lambda _, y: self._draw_gauge(y),
            Heading: self._draw_heading,
            Numbers: self._draw_numbers,
            Slider: self._draw_slider,
            Choice: lambda row, y: self._label(row.words, y + 5),
        }
        for row, y in self._rows:
            if type(row) in drawers:
                drawers[type(row)](row, y)
        self._manager.draw_ui(self._picture)

    def _label(self, words: str, y: float) -> None:
        self._pen.words(words, (SIDE, y), SMALL, colours.MUTED)

    def _draw_gauge(self, y: int) -> None:
        right = self._area.width - SIDE
        self._pen.words("Collision Math Toy", (SIDE, y + 12), LARGE, colours.TEXT)
        self._pen.words(self._texts.get("load", ""), (right, y + 14), SMALL, colours.MUTED, anchor="end")
        bar = pygame.Rect(SIDE, y + 38, self._area.width - 2 * SIDE, 6)
        self._pen.rect(colours.PAPER, bar, radius=3)
        colour = colours.GOOD if self._share < 0.5 else colours.WARM if self._share < 0.9 else colours.BAD
        filled = pygame.Rect(bar.topleft, (max(6, round(bar.width * min(1.0, self._share))), bar.height))
        self._pen.rect(colour, filled, radius=3)

    def _draw_heading(self, row: Heading, y: int) -> None:
        self._pen.words(row.words, (SIDE, y + 9), SMALL, colours.ACCENT)
        left = SIDE + self._pen.width(row.words, SMALL) + 10
        self._pen.line(colours.RULE, (left, y + 16), (self._area.width - SIDE, y + 16))

    def _draw_numbers(self, row: Numbers, y: int) -> None:
        width = (self._area.width - 2 * SIDE) / len(row.figures)
        for place, (name, words) in enumerate(row.figures):
            x = SIDE + place * width
            text = self._texts.get(name, "")
            colour = colours.BAD if name == "strays" and text.strip("0 ·") else colours.TEXT
            self._pen.words(text, (x, y + 2), LARGE, colour)
            self._pen.words(words, (x, y + 20), SMALL - 2, colours.FAINT)

    def _draw_slider(self, row: Slider, y: int) -> None:
        self._label(row.words, y + 3)
        text = row.text(self._desk.value(row.name))
        right = self._area.width - SIDE
        self._pen.words(text, (right, y + 3), SMALL, colours.TEXT, anchor="end")
