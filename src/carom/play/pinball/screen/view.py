"""The table as it is played: its art, its lamps, what moves on it, and what flashes."""

from __future__ import annotations

from itertools import pairwise
from math import hypot, pi

import pygame

from carom.play.letters import Letters
from carom.play.pen import Pen
from carom.play.pinball.art import pictures as art
from carom.play.pinball.art.paint import CREAM, GOLD, NIGHT
from carom.play.pinball.art.sprites import FLIPPER_PICTURES, SPINNER_PICTURES
from carom.play.pinball.rules.controls import Phase
from carom.play.pinball.rules.game import BALLS, Pinball
from carom.play.pinball.rules.lamps import LampState
from carom.play.pinball.screen.effects import POINTS, SPARK, Effects

#: Seconds of half a blink, and how far light runs up the table in a second of a show of lamps, in units.
BLINK_TIME, RUNS = 0.16, 60.0
#: From this speed on a ball has a tail, in units/s; places behind it that the tail goes through.
TAIL_FROM, TAIL = 24.0, 5
#: How far the plunger is drawn, in units, and where its tip is at rest.
DRAW, TIP = 0.62, (19.3, 0.62)
#: Where the balls that are left wait behind the apron's window: the first, and the way to the next.
WAITING, NEXT = (16.9, 2.02), (-1.2, 0.2)
ADD = pygame.BLEND_RGB_ADD


class TableView:
    """Draws the table of a game, `times` as large as pictures of `art.SIZE`."""

    def __init__(self, game: Pinball, letters: Letters, times: int = 1, effects: Effects | None = None) -> None:
        self.art = art.Art(game.world, times)
        self.effects = Effects() if effects is None else effects
        self._times = times
        self._game = game
        self._letters = letters
        self._tails: dict[int, list[tuple[float, float]]] = {}

    def draw(self, surface: pygame.Surface) -> None:
        """Draw the table into a surface of its size."""
        surface.blit(self.art.ground, (0, 0))
        self._draw_lamps(surface)
        self._draw_parts(surface)
        self._draw_balls(surface)
        self._draw_flippers(surface)
        self._draw_flashes(surface)
        self._draw_apron(surface)
        self._draw_points(surface)

    def _lit(self, name: str, y: float) -> bool:
        """Whether the lamp at a height of the table is lit now, with blinking, and shows of lamps."""
        show = self.effects.show
        if show is not None:
            return (show * RUNS + y) % 20.0 < 8.0
        state = self._game.lamps[name]
        if state is LampState.BLINK:
            return int(self.effects.time / BLINK_TIME) % 2 == 0
        return state is LampState.ON

    def _draw_lamps(self, surface: pygame.Surface) -> None:
        """Draw the lamps in the playfield that are lit."""
        for name, light in self.art.lights.items():
            if self._lit(name, light.lens_at[1] / self.art.scale):
                surface.blit(light.shine, light.shine_at, special_flags=ADD)
                surface.blit(light.lens, light.lens_at)

    def _draw_parts(self, surface: pygame.Surface) -> None:
        """Draw bumpers, drop targets, spinner and plunger."""
        pictures = self.art
        for name, (up, down, corner) in pictures.targets.items():
            surface.blit(down if name in self._game.table.down else up, corner)
        for name, (x, y) in pictures.bumper_places.items():
            kicks = self.effects.kicks(name)
            lit = kicks or self._lit(name, y / pictures.scale)
            if lit:
                centered(surface, pictures.shine[name], (x, y), ADD)
            if kicks:
                centered(surface, pictures.shine[name], (x, y), ADD)
            centered(surface, pictures.bumpers[name][2 if kicks else int(lit)], (x, y))
        turn = self._game.table.spinner.orientation % pi
        picture = pictures.spinner[round(turn / pi * SPINNER_PICTURES) % SPINNER_PICTURES]
        centered(surface, picture, pictures.pivots["spinner"])
        x, y = pictures.pixel((TIP[0], TIP[1] - DRAW * self._game.plunger_pull))
        surface.blit(pictures.plunger, (round(x) - pictures.plunger.get_width() // 2, round(y)))

    def _draw_balls(self, surface: pygame.Surface) -> None:
        """Draw the balls, their shadows, and the tails of fast ones."""
        pictures = self.art
        tails: dict[int, list[tuple[float, float]]] = {}
        places = []
        for ball in self._game.world.balls:
            x, y = pictures.pixel(ball.position)
            places.append((x, y))
            centered(surface, pictures.shadow, (x + 3.0 * self._times, y + 5.0 * self._times))
            tail = [(x, y), *self._tails.get(ball.id or 0, ())][: TAIL + 1]
            tails[ball.id or 0] = tail
            if hypot(*ball.velocity) > TAIL_FROM:
                self._draw_tail(surface, tail)
        for place in places:
            centered(surface, pictures.ball, place)
        self._tails = tails

    def _draw_tail(self, surface: pygame.Surface, tail: list[tuple[float, float]]) -> None:
        """Draw the tail of a fast ball through where it was in the last frames."""
        lights = iter(self.art.tail)
        for (x, y), (back_x, back_y) in pairwise(tail):
            for share in (0.25, 0.6, 0.95):
                light = next(lights, None)
                if light is not None:
                    centered(surface, light, (x + (back_x - x) * share, y + (back_y - y) * share), ADD)

    def _draw_flippers(self, surface: pygame.Surface) -> None:
        """Draw the flippers as far up as they are."""
        table = self._game.table
        for flipper in (table.left, table.right):
            name = flipper.shape.name or ""
            number = round(flipper.angle / flipper.reach * (FLIPPER_PICTURES - 1))
            picture = self.art.flippers[name][min(max(number, 0), FLIPPER_PICTURES - 1)]
            centered(surface, picture, self.art.pivots[name])

    def _draw_flashes(self, surface: pygame.Surface) -> None:
        """Draw the flashes of slingshots, of the saucer and of hard impacts."""
        for name, place in self.art.kickers.items():
            if self.effects.kicks(name):
                centered(surface, self.art.kick, place, ADD)
        for spark in self.effects.sparks:
            if self.effects.time - spark.since < SPARK:
                centered(surface, self.art.spark, self.art.pixel(spark.place), ADD)

    def _draw_apron(self, surface: pygame.Surface) -> None:
        """Draw the balls that wait behind the window, and the apron over them."""
        game = self._game
        left = BALLS if game.phase in (Phase.OVER, Phase.ENTRY) else BALLS - game.ball_number
        for number in range(left):
            place = (WAITING[0] + number * NEXT[0], WAITING[1] + number * NEXT[1])
            centered(surface, self.art.ball, self.art.pixel(place))
        surface.blit(self.art.apron, self.art.apron_at)

    def _draw_points(self, surface: pygame.Surface) -> None:
        """Draw the points that float up from where they were made."""
        pen = Pen(surface, self._letters, self._times)
        for spark in self.effects.points:
            since = (self.effects.time - spark.since) / POINTS
            x, y = art.pixel(spark.place)
            x, y = min(max(x, 44.0), art.SIZE[0] - 50.0), y - 16.0 - 34.0 * since
            colour = CREAM if int(since * 8.0) % 2 else GOLD
            pen.words(spark.words, (x + 1.0, y + 2.0), 16, NIGHT, anchor="middle")
            pen.words(spark.words, (x, y), 16, colour, anchor="middle")


def centered(surface: pygame.Surface, picture: pygame.Surface, place: tuple[float, float], flags: int = 0) -> None:
    """Lay a picture over a surface, its middle at a place."""
    corner = (round(place[0] - picture.get_width() / 2.0), round(place[1] - picture.get_height() / 2.0))
    surface.blit(picture, corner, special_flags=flags)
