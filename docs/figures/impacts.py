"""Figures of times of impact."""

from __future__ import annotations

from math import pi, sqrt

from carom.geometry.impact import impact_point
from carom.geometry.path import Path
from docs.figures.sheet import BLUE, GREEN, RED, Sheet, figure, plus

#: A throw over a post at 0, and the squared reach at which the ball touches it: start, velocity, gravity.
THROWN = ((-1.2, -0.1), (0.5, 2.2), -1.42)
LEVEL = 0.75


@figure(
    "impact-straight",
    (-3.75, -1.6, 3.9, 2.45),
    80,
    "A ball on a straight way to a point: its distance falls to r where the way enters the circle of radius r.",
)
def impact_straight(sheet: Sheet) -> None:
    """A ball's centre meets the circle of its own radius about the point."""
    p, v, radius, q = (-2.6, 1.3), (4.0, -0.9), 1.0, (0.8, 0.0)
    px, py = p[0] - q[0], p[1] - q[1]
    b, speed_squared, k = px * v[0] + py * v[1], v[0] * v[0] + v[1] * v[1], px * v[1] - py * v[0]
    time = impact_point(*q, Path(*p, *v, 0.0, 0.0), radius, 10.0)
    assert time is not None
    assert abs(time - (-b - sqrt(speed_squared * radius * radius - k * k)) / speed_squared) < 1e-12
    touch = plus(p, v, time)
    sheet.circle(q, radius)
    sheet.ball(p, radius, ghost=True)
    sheet.ball(touch, radius)
    sheet.line(p, plus(p, v, 1.55))
    sheet.arrow(p, plus(p, v, 0.35), GREEN)
    sheet.label(plus(p, v, 0.35), "v", pi / 2, GREEN)
    foot = plus(p, v, -b / speed_squared)
    sheet.line(q, foot, BLUE, dashed=False)
    sheet.label(plus(q, (0.1, 0.12)), "|k|/|v|", 0.0, BLUE, 26)
    sheet.line(q, touch, RED, dashed=False)
    sheet.label(((q[0] + touch[0]) / 2, (q[1] + touch[1]) / 2), "r", -pi / 2, RED, 11)
    sheet.dot(q, RED, 4.5)
    sheet.label(q, "q", -pi / 3, RED)
    sheet.label(p, "p", pi, "ball-1")
    sheet.label((3.0, -1.3), "t = (−b − √…)/v²")


@figure(
    "impact-fall",
    (-0.6, -0.8, 7.2, 3.2),
    82,
    "A squared distance over time: it turns where its slope, a cubic, is zero, and is monotone in between.",
)
def impact_fall(sheet: Sheet) -> None:
    """The squared distance of a falling ball from a point, and where it crosses the level."""
    p, v, g = THROWN

    def away(t: float) -> float:
        x, y = p[0] + v[0] * t, p[1] + v[1] * t + 0.5 * g * t * t
        return x * x + y * y

    times = [0.01 * k for k in range(311)]
    scale_x, scale_y, level = 2.0, 0.85, LEVEL
    sheet.arrow((-0.3, 0.0), (6.8, 0.0), "muted", 1.2)
    sheet.arrow((0.0, -0.3), (0.0, 3.0), "muted", 1.2)
    sheet.label((6.8, 0.0), "t", -pi / 2, "muted")
    sheet.label((0.35, 2.85), "|p(t)|²", 0.0, "muted")
    sheet.path([(scale_x * t, scale_y * away(t)) for t in times], BLUE, 2.4)
    sheet.line((0.0, scale_y * level), (6.6, scale_y * level), RED)
    sheet.label((6.5, scale_y * level), "r²", pi / 2, RED)
    turns = [
        t
        for s, t, u in zip(times, times[1:], times[2:], strict=False)
        if (away(t) - away(s)) * (away(u) - away(t)) <= 0.0
    ]
    for t in turns:
        sheet.dot((scale_x * t, scale_y * away(t)), GREEN, 4.5)
        sheet.line((scale_x * t, 0.0), (scale_x * t, scale_y * away(t)), GREEN)
    crossing = impact_point(0.0, 0.0, Path(*p, *v, 0.0, g), sqrt(level), 10.0)
    assert crossing is not None
    sheet.dot((scale_x * crossing, scale_y * level), RED, 4.5)
    sheet.label((scale_x * crossing, scale_y * level), "touch", 0.7, RED, 26)
    sheet.label((scale_x * turns[-1], 0.0), "turns", -pi / 2, GREEN)


@figure(
    "impact-advance",
    (-0.6, -0.7, 7.2, 2.9),
    82,
    "A gap over time, and safe steps below it, each to where a parabola of known curvature would close it.",
)
def impact_advance(sheet: Sheet) -> None:
    """Conservative advancement: steps under the gap that never go too far."""

    def gap(t: float) -> float:
        return 2.1 - 0.95 * t + 0.16 * t * t - 0.012 * t * t * t

    def rate(t: float) -> float:
        return -0.95 + 0.32 * t - 0.036 * t * t

    bend = 0.7
    sheet.arrow((-0.3, 0.0), (6.9, 0.0), "muted", 1.2)
    sheet.arrow((0.0, -0.3), (0.0, 2.7), "muted", 1.2)
    sheet.label((6.9, 0.0), "t", -pi / 2, "muted")
    sheet.label((0.3, 2.6), "gap f", 0.0, "muted")
    sheet.path([(0.05 * k, gap(0.05 * k)) for k in range(105)], BLUE, 2.4)
    time = 0.0
    for number in range(4):
        f, slope = gap(time), rate(time)
        step = (slope + sqrt(slope * slope + 2.0 * bend * f)) / bend
        points = [
            (time + step * k / 20, f + slope * step * k / 20 - bend * (step * k / 20) ** 2 / 2) for k in range(21)
        ]
        sheet.path(points, GREEN, 1.6)
        sheet.dot((time, f), GREEN, 3.6)
        sheet.dot((time + step, 0.0), RED, 3.6)
        if number < 3:
            sheet.line((time + step, 0.0), (time + step, gap(time + step)))
        time += step
    sheet.label((3.6, 1.9), "f + f′τ − Mτ²/2 ≥ 0 is safe", None, GREEN)


@figure(
    "gap-turns",
    (-3.2, -1.2, 3.6, 2.2),
    82,
    "A ball thrown over a post: it comes nearer, goes away, and comes nearer again.",
)
def gap_turns(sheet: Sheet) -> None:
    """A falling ball may touch a point from its second approach."""
    p, v, g = THROWN
    places = [(p[0] + v[0] * t, p[1] + v[1] * t + 0.5 * g * t * t) for t in (0.01 * k for k in range(301))]
    sheet.path(places, BLUE, 2.0)
    radius = sqrt(LEVEL)
    sheet.circle((0.0, 0.0), radius)
    time = impact_point(0.0, 0.0, Path(*p, *v, 0.0, g), radius, 10.0)
    assert time is not None
    touch = (p[0] + v[0] * time, p[1] + v[1] * time + 0.5 * g * time * time)
    sheet.ball(places[0], radius, ghost=True)
    sheet.ball(touch, radius)
    sheet.line((0.0, 0.0), touch, RED, dashed=False)
    sheet.dot((0.0, 0.0), RED, 4.5)
    sheet.label((0.0, 0.0), "q", -pi / 2, RED)
    sheet.arrow((2.9, 2.0), (2.9, 1.1), "muted")
    sheet.label((2.9, 1.6), "g", 0.0, "muted")
