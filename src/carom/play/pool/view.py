"""The table while it is played on: balls, cue, the line of aim, and the marks of the impacts."""

from __future__ import annotations

from itertools import pairwise
from math import hypot
from typing import TYPE_CHECKING

import pygame

from carom.play.letters import Letters
from carom.play.pool.ball_art import RollingBall
from carom.play.pool.game import Phase, Vector
from carom.play.pool.hud import Hud
from carom.play.pool.layout import BAD, GOLD, IVORY, Colour
from carom.play.pool.preview import pocket_at, rest_before_impact, scratch, until_rest
from carom.play.pool.session import Mode, Session
from carom.play.pool.sprites import Cue, put, ring, spot
from carom.play.pool.table_art import cloth_of, pockets
from carom.play.pool.tables import Table

if TYPE_CHECKING:
    from carom.play.meter import FrameMeter
    from carom.play.pool.game import Pool
    from carom.play.pool.preview import Leg, Preview

#: Pixels: dashes and the gaps between them.
DASH, GAP = 9.0, 7.0

#: Pixels from the cue ball to the cue's tip where it is not drawn, and as far as it is drawn back.
REST, DRAWN = 7.0, 110.0

#: Seconds that the cue is seen after a shot, and that a ball takes to sink into a pocket.
FOLLOW, SINK = 0.3, 0.22

#: Seconds: how far ahead the arrows of step mode point.
ARROW = 0.25

#: The least of its size and of its light that a ball keeps in a pocket.
SUNK_SIZE, SUNK_LIGHT = 0.86, 0.34

#: Pixels: a ball that went farther than this between two frames was put somewhere else.
JUMP = 400.0

#: The colour of the line on which the cue ball may be put.
CLOTH_LINE = (190, 226, 214)

#: The colours of what belongs to the balls that are to be potted, and to the cue ball.
BALL_LINE, CUE_LINE = GOLD, IVORY

#: The number on each ball; the cue ball has none.
NUMBERS = {"cue ball": 0, "eight": 8, "one": 1, "two": 2, "three": 3, "four": 4, "five": 5, "six": 6, "seven": 7}


class View:
    """Draws sessions at one table, `times` as large as a picture of `SIZE` is."""

    def __init__(self, session: Session, times: int = 1) -> None:
        world = session.pool.world
        self.layout = cloth_of(world, times)
        radius, rim, self.times = session.pool.cue.radius * self.layout.scale, 5.2 * self.layout.scale, times
        self.hud = Hud(self.layout)
        self.letters = Letters()
        self.table = Table(times)
        self.cue = Cue(times)
        self.balls = {name: RollingBall(radius, number) for name, number in NUMBERS.items()}
        self.radius = radius
        self._places: dict[str, Vector] = {}
        self._shadow = spot(1.4 * radius, (0, 0, 0), 0.62, 0.85)
        self._ghost = ring(radius, 1.6 * times, IVORY, 0.95, 0.13)
        self._faint = ring(radius, 1.2 * times, IVORY, 0.6)
        self._goal, self._danger = ring(rim, 3.0 * times, GOLD, 0.95), ring(rim, 3.0 * times, BAD, 0.95)
        self._cue_mark = ring(radius, 1.8 * times, IVORY, 0.95, 0.16)
        self._mark = ring(radius, 1.8 * times, GOLD, 0.95, 0.2)
        self._pockets = {pocket_at(session.pool, arc.center): self.layout.pixel(arc.center) for arc in pockets(world)}

    def draw(self, surface: pygame.Surface, session: Session, meter: FrameMeter) -> None:
        """Draw the whole picture."""
        self.table.draw(surface)
        shown = session.preview()
        if Mode.IMPACTS in session.modes:
            self._draw_paths(surface, session)
        line = session.pool.base_line
        if line is not None and session.dragging:
            self._dash(surface, self.layout.pixel(line[0]), self.layout.pixel(line[1]), CLOTH_LINE, 0.0, 0.0)
        if shown is not None:
            self._draw_aim(surface, session.pool, shown, session.strength)
        if session.pool.over:
            self._draw_falls(surface, session.pool)
        self._draw_balls(surface, session)
        if Mode.STEPS in session.modes:
            self._draw_velocities(surface, session.pool)
        self._draw_cue(surface, session)
        if Mode.IMPACTS in session.modes:
            self._draw_numbers(surface, session)
        self.hud.draw(surface, session, meter)

    def go_on_from(self, other: View) -> None:
        """Draw the balls turned as another view, of another size, has drawn them last."""
        for name, ball in self.balls.items():
            ball.turn_as(other.balls[name])
        self._places = {}

    # -- balls and cue -----------------------------------------------------------------------------------------------

    def _draw_balls(self, surface: pygame.Surface, session: Session) -> None:
        """Draw the balls, rolled on from where they were in the last frame."""
        pool = session.pool
        for ball in sorted(pool.balls, key=lambda ball: ball.name not in pool.potted):
            name = ball.name or ""
            x, y = self.layout.pixel(ball.position)
            before = self._places.get(name, (x, y))
            self._places[name] = (x, y)
            if pool.shots == 0:
                self.balls[name].reset()
            elif hypot(x - before[0], y - before[1]) < JUMP * self.times:
                self.balls[name].roll(x - before[0], before[1] - y)
            fall = pool.potted.get(name)
            share = 0.0 if fall is None else min((pool.world.time - fall.time) / SINK, 1.0)
            if share < 1.0:
                self._draw_shadow(surface, (x, y))
            size, light = 1.0 - (1.0 - SUNK_SIZE) * share, 1.0 - (1.0 - SUNK_LIGHT) * share
            self.balls[name].draw(surface, (x, y), size, light)

    def _draw_velocities(self, surface: pygame.Surface, pool: Pool) -> None:
        """Draw an arrow from each ball that moves to where it would be in `ARROW` seconds, or to the cushion before."""
        for ball in pool.balls:
            colour = line_of(ball.name or "")
            (x, y), (vx, vy), speed = ball.position, ball.velocity, hypot(*ball.velocity)
            scale, times = self.layout.scale, self.times
            if scale * ARROW * speed < 1.0:
                continue
            start, (along_x, along_y) = self.layout.pixel((x, y)), (vx / speed, -vy / speed)
            to_edge = scale * self.layout.distance_to_edge((x, y), (vx / speed, vy / speed))
            way = min(scale * ARROW * speed, to_edge - self.radius - 2.0 * times)
            if way < 1.0:
                continue
            near, far = self.radius + 2.0 * times, self.radius + 2.0 * times + way
            end = (start[0] + far * along_x, start[1] + far * along_y)
            stroke(surface, (start[0] + near * along_x, start[1] + near * along_y), end, colour, 2 * times)
            for side in (3.5 * times, -3.5 * times):
                back_x, back_y = end[0] - 8.0 * times * along_x, end[1] - 8.0 * times * along_y
                stroke(surface, (back_x - side * along_y, back_y + side * along_x), end, colour, 2 * times)

    def _draw_shadow(self, surface: pygame.Surface, place: Vector) -> None:
        """Draw a ball's shadow, which falls away from the lamp above the middle of the table."""
        x, y = self.layout.center
        away = ((place[0] - x) * 0.008, (place[1] - y) * 0.008)
        put(surface, self._shadow, (place[0] + away[0] + 1.5 * self.times, place[1] + away[1] + 3.5 * self.times))

    def _draw_cue(self, surface: pygame.Surface, session: Session) -> None:
        """Draw the cue behind the cue ball, as far back as the power says, or what is seen of a shot."""
        pool = session.pool
        x, y = session.direction
        towards = (x, -y)
        if pool.phase is Phase.AIM:
            back = self.radius + self.times * (REST + DRAWN * (0.0 if session.draw is None else session.draw))
            ball, bright = self.layout.pixel(pool.cue.position), 1.0
        elif session.since_shot < FOLLOW:
            share = session.since_shot / FOLLOW
            back, bright = self.radius - 14.0 * self.times * min(3.0 * share, 1.0), 1.0 - share * share
            ball = self.layout.pixel(pool.shot_from[0])
        else:
            return
        tip = (ball[0] - back * towards[0], ball[1] - back * towards[1])
        self.cue.draw(surface, tip, towards, bright)

    # -- the line of aim ---------------------------------------------------------------------------------------------

    def _draw_aim(self, surface: pygame.Surface, pool: Pool, shown: Preview, power: float) -> None:
        """Draw the line of aim, the ghost ball, how far both balls go on, and the pockets that they reach."""
        fall, rest = scratch(pool, shown, power), rest_before_impact(pool, shown, power)
        danger = fall is not None and shown.pocket is not None
        start, end = self.layout.pixel(shown.aim.start), self.layout.pixel(rest or shown.aim.ghost)
        self._dash(surface, start, end, BAD if danger else IVORY, self.radius + 3.0 * self.times, self.radius)
        put(surface, self._faint if rest else self._ghost, end)
        if rest is not None:
            return
        for leg, share, colour in (
            (shown.cue, shown.aim.speed, CUE_LINE),
            (shown.struck, shown.aim.other_speed, BALL_LINE),
        ):
            if leg is not None:
                way = until_rest(pool, shown, leg, share, power)
                self._draw_leg(surface, way, colour)
                if leg is shown.struck and way.pocket is not None:
                    put(surface, self._goal, self._pockets[way.pocket])
        if fall is not None:
            put(surface, self._danger, self._pockets[fall])

    def _draw_leg(self, surface: pygame.Surface, leg: Leg, colour: Colour) -> None:
        """Draw a ball's way on as a thin line with a ring where it ends."""
        start, end = self.layout.pixel(leg.start), self.layout.pixel(leg.end)
        self._stroke_between(surface, start, end, colour)
        if leg.pocket is None:
            put(surface, self._faint, end)

    def _dash(
        self, surface: pygame.Surface, start: Vector, end: Vector, colour: Colour, skip: float, leave: float
    ) -> None:
        """Draw a dashed line that begins `skip` pixels after `start` and ends `leave` pixels before `end`."""
        way = hypot(end[0] - start[0], end[1] - start[1])
        if way <= skip + leave:
            return
        x, y = (end[0] - start[0]) / way, (end[1] - start[1]) / way
        at = skip
        while at < way - leave:
            to = min(at + DASH * self.times, way - leave)
            near, far = (start[0] + at * x, start[1] + at * y), (start[0] + to * x, start[1] + to * y)
            stroke(surface, near, far, colour, 2 * self.times)
            at += (DASH + GAP) * self.times

    def _draw_falls(self, surface: pygame.Surface, pool: Pool) -> None:
        """Draw rings round the pockets into which the last shot potted balls."""
        for name, fall in pool.potted.items():
            if name in pool.gone:
                continue
            picture = self._danger if name == pool.cue.name else self._goal
            put(surface, picture, self._pockets[fall.pocket])

    # -- the marks of the impacts ------------------------------------------------------------------------------------

    def _draw_paths(self, surface: pygame.Surface, session: Session) -> None:
        """Draw the ways of the balls since the shot, and where they were at each impact."""
        pool = session.pool
        for name in (ball.name or "" for ball in pool.balls if ball.name not in pool.gone):
            path, colour = [self.layout.pixel(place) for place in pool.path(name)], line_of(name)
            if pool.shots > 0:
                put(surface, self._faint, path[0])
            for start, end in pairwise(path):
                self._stroke_between(surface, start, end, colour)
        for mark in pool.marks:
            for name, place in mark.balls:
                put(surface, self._cue_mark if name == "cue ball" else self._mark, self.layout.pixel(place))

    def _stroke_between(self, surface: pygame.Surface, start: Vector, end: Vector, colour: Colour) -> None:
        """Draw a line from the edge of a ball at `start` to that of one at `end`."""
        way = hypot(end[0] - start[0], end[1] - start[1])
        if way > 2.0 * self.radius:
            x, y = self.radius * (end[0] - start[0]) / way, self.radius * (end[1] - start[1]) / way
            stroke(surface, (start[0] + x, start[1] + y), (end[0] - x, end[1] - y), colour, 2 * self.times)

    def _draw_numbers(self, surface: pygame.Surface, session: Session) -> None:
        """Write the number of each impact into the balls that took part."""
        for mark in session.pool.marks:
            for name, place in mark.balls:
                x, y = self.layout.pixel(place)
                place, size = (x, y - 6.5 * self.times), 13 * self.times
                self.letters.draw(surface, str(mark.number), place, size, line_of(name), anchor="middle")


def line_of(name: str) -> Colour:
    """The colour of what belongs to a ball."""
    return CUE_LINE if name == "cue ball" else BALL_LINE


def stroke(surface: pygame.Surface, start: Vector, end: Vector, colour: Colour, width: int = 2) -> None:
    """Draw a smooth line, its width in pixels."""
    way = hypot(end[0] - start[0], end[1] - start[1])
    if way == 0.0:
        return
    x, y = (end[1] - start[1]) / way, (start[0] - end[0]) / way
    for line in range(width):
        side = 0.5 * (width - 1) - line
        shift_x, shift_y = side * x, side * y
        pygame.draw.aaline(
            surface, colour, (start[0] + shift_x, start[1] + shift_y), (end[0] + shift_x, end[1] + shift_y)
        )
