"""`carom toy`: the Collision Math Toy, a table and a panel with which a person sees the mathematics."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from functools import cached_property
from math import radians
from time import perf_counter
from types import MappingProxyType
from typing import Any

import pygame

import carom
from carom.play.controls import Controls
from carom.play.letters import Letters
from carom.play.meter import FrameMeter
from carom.play.pen import Pen
from carom.play.sound import Speaker
from carom.play.toy import beside, colours
from carom.play.toy.desk import STEP, Desk
from carom.play.toy.help import draw_help
from carom.play.toy.keys import BUTTONS, KEYS
from carom.play.toy.panel import Panel
from carom.play.toy.probe import Reading, ball_at, read, shape_at
from carom.play.toy.readout import EDITING, HINTS, draw_reading, draw_sentence
from carom.play.toy.script import load_script
from carom.play.toy.settings import Settings
from carom.play.toy.sounds import tick, ticks
from carom.play.toy.table import Table
from carom.play.toy.view import View
from carom.play.toy.words import figure_texts, load_text
from carom.play.window import RATE, Patience, Ticker, play

#: Pixels: the window, and the panel and the strip in it.
SIZE, PANEL, STRIP = (1280, 800), 364, 92

#: What each edit turns a shape by, in radians; nothing for those that do something else.
EDITS: Mapping[str, float] = MappingProxyType(
    {"add": 0.0, "take away": 0.0, "turn left": radians(5.0), "turn right": radians(-5.0)}
)
#: The mouse's buttons, and for how many seconds it is said where a table was kept.
LEFT, RIGHT, TOLD = 1, 3, 5.0


class Toy:
    """The toy as a game for a window.

    Attributes:
        desk: The tables and all switches.
        views: The tables as they are shown.
        meter: How long frames take.
    """

    title = "carom: Collision Math Toy"
    size = SIZE

    def __init__(self, tell: Callable[[str], None]) -> None:
        self.desk = Desk()
        self._times = 1
        self._letters = Letters(load_script)
        self._stage = pygame.Rect(0, 0, SIZE[0] - PANEL, SIZE[1] - STRIP)
        self._strip = pygame.Rect(0, SIZE[1] - STRIP, SIZE[0] - PANEL, STRIP)
        self._controls: Controls[str] = Controls(KEYS, BUTTONS, tell)
        self._speaker = Speaker(ticks(), tell)
        self._ticker = Ticker(STEP)
        self._patience = Patience()
        self.meter = FrameMeter(RATE)
        self._losses = beside.Losses()
        self._mouse = (-1, -1)
        self._grip: View | None = None
        self._seen: Settings | None = None
        self.views: tuple[View, ...] = ()
        self._told: tuple[View, ...] = ()
        self._told_last, self._told_left = "", 0.0

    @cached_property
    def panel(self) -> Panel:
        """The panel; made when it is first used, for its buttons need an open window."""
        return Panel(self.desk, self._letters, (SIZE[0] - PANEL, 0), (PANEL, SIZE[1]), self._times)

    def magnify(self, times: int) -> None:
        """Draw the picture `times` as large from now on."""
        self._times = times
        self.size = (SIZE[0] * times, SIZE[1] * times)
        for view in self.views:
            view.magnify(times)
        if "panel" in vars(self):
            del self.panel
        self._told = ()

    @property
    def running(self) -> bool:
        """False once the toy is to be closed."""
        return self.desk.running

    @running.setter
    def running(self, running: bool) -> None:
        self.desk.running = running

    # -- input -------------------------------------------------------------------------------------------------------

    def handle(self, event: pygame.event.Event) -> None:
        """Take one event: of keys, controllers and the mouse, and those of the panel's own buttons."""
        event = self._unmagnified(event)
        for name, down in self._controls.read(event):
            if down:
                self._press(name)
        if event.type == pygame.MOUSEBUTTONDOWN and not self.panel.holds(event.pos):
            self._grasp(event)
            return
        if event.type == pygame.MOUSEWHEEL and self.desk.settings.editing:
            self._edit("turn left" if event.y > 0 else "turn right")
        if event.type == pygame.MOUSEMOTION:
            self._point(event.pos)
        elif event.type == pygame.MOUSEBUTTONUP and event.button == 1:
            self._let_go()
        self.panel.handle(event)

    def _unmagnified(self, event: pygame.event.Event) -> pygame.event.Event:
        """An event with its place in a picture that is not magnified."""
        if self._times == 1 or not hasattr(event, "pos"):
            return event
        place = tuple(side // self._times for side in event.pos)
        return pygame.event.Event(event.type, event.dict | {"pos": place})

    def _press(self, name: str) -> None:
        """Do what a key says; the key that quits closes the help first."""
        if name in EDITS:
            self._edit(name)
            return
        self.desk.press("help" if name == "quit" and self.desk.help else name)

    def _grasp(self, event: pygame.event.Event) -> None:
        """Take hold of the ball under the mouse, or of what is edited there; a click closes the help."""
        self._mouse = event.pos
        if self.desk.help:
            self.desk.do("help")
            return
        view = self._view_at(event.pos)
        if self.desk.settings.editing:
            self._grasp_shape(event.button)
        elif view is not None and event.button == 1:
            place = view.place(event.pos)
            ball = ball_at(view.table.world, place, view.reach)
            if ball is not None:
                self._grip = view
                self.desk.hand.take(ball, place)

    def _grasp_shape(self, button: int) -> None:
        """Take hold of what is under the mouse, or add something where nothing is; the right button takes it away."""
        view = self._view_at(self._mouse)
        thing = None if view is None else self._under(view)
        if button == RIGHT:
            self._edit("take away")
        elif button == LEFT and view is not None and thing is not None:
            self._grip = view
            self.desk.editor.take(thing, view.place(self._mouse))
        elif button == LEFT:
            self._edit("add")

    def _edit(self, name: str) -> None:
        """Change the table at the mouse, if it is there and the table is being edited."""
        view, desk = self._view_at(self._mouse), self.desk
        if view is None or not desk.settings.editing:
            return
        thing = self._under(view)
        if name == "add":
            desk.editor.add(desk.tables, desk.settings.kind, view.place(self._mouse), desk.settings.size)
        elif thing is not None and name == "take away":
            desk.editor.remove(desk.tables, thing)
        elif thing is not None:
            desk.editor.turn(desk.tables, thing, EDITS[name])
        self._renew()

    def _under(self, view: View) -> Any:
        """The shape or ball under the mouse, or None."""
        return shape_at(view.table.world, view.place(self._mouse), view.reach)

    def _let_go(self) -> None:
        """Throw the ball that is held, or leave the shape that is dragged where it is."""
        self.desk.hand.throw(self.desk.tables)
        if self.desk.editor.held is not None:
            self.desk.editor.drop(self.desk.tables)
            self._renew()

    def _renew(self) -> None:
        """Show the tables as they were changed."""
        for view in self.views:
            view.renew()

    def _point(self, pixel: tuple[int, int]) -> None:
        """Take the mouse to be somewhere else now."""
        self._mouse = pixel
        if self.desk.hand.ball is not None and self._grip is not None:
            self.desk.hand.move(self._grip.place(pixel))
        if self.desk.editor.held is not None and self._grip is not None:
            self.desk.editor.move(self.desk.tables, self._grip.place(pixel))

    def _view_at(self, pixel: tuple[int, int]) -> View | None:
        """The table that a pixel is on, or None."""
        return next((view for view in self.views if view.area.collidepoint(pixel)), None)

    # -- time --------------------------------------------------------------------------------------------------------

    def advance(self, seconds: float) -> None:
        """Go on by so much time."""
        self._agree()
        self.desk.hand.wait(seconds)
        parts: Sequence[carom.Hits] = ()
        due = self._ticker.due(seconds)
        if self._patience.allows(seconds) and not self._waits():
            began = perf_counter()
            parts = self.desk.advance(due)
            self._patience.took(perf_counter() - began)
        for place, hits in enumerate(parts):
            self.views[place % len(self.views)].note(hits)
        if self.desk.told != self._told_last:
            self._told_last, self._told_left = self.desk.told, TOLD
        self._told_left -= seconds
        self._speaker.muted = self.desk.settings.muted
        tick(self._speaker, parts)
        self._count(seconds)
        self.panel.advance(seconds)

    def _waits(self) -> bool:
        """Whether time stands still for a compiler: interpreted, a continuous step of fast balls takes seconds."""
        return carom.compiling() and any(table.world.detection == "continuous" for table in self.desk.tables)

    def _agree(self) -> None:
        """Show what the desk's settings say, where they have changed."""
        settings, tables = self.desk.settings, self.desk.tables
        if tuple(view.table for view in self.views) != tables:
            self._losses = beside.Losses()
            places = [self._stage] if len(tables) == 1 else beside.areas(self._stage)
            self.views = tuple(View(table, area, self._times) for table, area in zip(tables, places, strict=True))
            self._seen = None
        if settings != self._seen:
            self._seen = replace(settings)
            self.panel.agree()
            for view in self.views:
                view.look(settings)
        if self.desk.cleared:
            self.desk.cleared = False
            for view in self.views:
                view.forget()

    def _count(self, seconds: float) -> None:
        """Read the figures, a few times a second."""
        news = [view.figures.wait(seconds) for view in self.views]
        news.append(self._told is not self.views)
        if len(self.views) > 1:
            self._losses.wait(seconds, tuple(view.table.strays for view in self.views))
        if any(news):
            self._told = self.views
            for view in self.views:
                view.measure()
            self.panel.show(
                figure_texts(self.views, self.desk.lane.waiting) | {"load": load_text(self.meter)}, self.meter.share
            )

    # -- its picture -------------------------------------------------------------------------------------------------

    def draw(self, surface: pygame.Surface) -> None:
        """Draw the frame."""
        pen = Pen(surface, self._letters, self._times)
        if len(self.views) > 1:
            self._draw_beside(pen)
        for view in self.views:
            view.draw(pen)
        self._draw_hand(pen)
        self._draw_strip(pen)
        if self.desk.help:
            draw_help(pen, self._stage)
        self.panel.draw(surface)

    def _draw_strip(self, pen: Pen) -> None:
        """Draw what was kept where, or what the control under the mouse means, or the numbers of the shape there."""
        words = self.desk.told if self._told_left > 0.0 else self.panel.sentence(self._mouse)
        if words:
            draw_sentence(pen, self._strip, words)
        else:
            hints = EDITING if self.desk.settings.editing else HINTS
            draw_reading(pen, self._strip, self._pointed_at(pen), hints)

    def _draw_beside(self, pen: Pen) -> None:
        """Draw what is around two tables."""
        pen.fill(colours.PAPER, self._stage)
        beside.draw_captions(pen, self.views, self.desk.kinds)
        top = self.views[0].area.bottom + 84
        area = pygame.Rect(16, top, self._stage.width - 32, self._stage.bottom - top - 10)
        self._losses.draw(pen, area, self.desk.kinds, waits=self._waits())

    def _draw_hand(self, pen: Pen) -> None:
        """Draw what the hand holds."""
        hand = self.desk.hand
        for view in self.views:
            for ball in hand.held([view.table]):
                view.mark_throw(pen, ball, hand.velocity, hand.target)

    def _pointed_at(self, pen: Pen) -> Reading | None:
        """The numbers of what the mouse points at, which is marked; None where it points at nothing."""
        view = self._view_at(self._mouse)
        if view is None or self.desk.help:
            return None
        held = self.desk.hand.held([view.table])
        shape = held[0] if held else self._under(view)
        if shape is None:
            return None
        view.mark(pen, shape)
        return read(shape, -view.table.world.gravity[1])


def run(*, tell: Callable[[str], None], seconds: float | None = None) -> FrameMeter:
    """The times of all frames of a toy that was played with until it was closed, or `seconds` were over."""

    def ready() -> Toy:
        warm_up()
        return Toy(tell)

    return play(ready, seconds)


def warm_up() -> None:
    """Have both kinds of steps compiled, now or in the background: the table must not stand still for it later."""
    for detection in ("discrete", "continuous"):
        table = Table()
        table.world.detection = detection
        table.step(STEP)
        shape_at(table.world, (0.0, 0.0), 1.0)
