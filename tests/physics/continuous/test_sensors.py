"""Sensors in the continuous mode: a ball that crosses one within a step gives ENTER and EXIT, each at its time."""

from copy import deepcopy
from math import asin, cos, pi, sin, sqrt
from typing import Any

import numpy as np
import pytest

from carom import Arc, Ball, Circle, HitKind, Point, Segment, World
from carom.shapes.shape import Shape
from tests.clock import within
from tests.worlds import box

SPEED, RADIUS, WIDE, OFF = 40.0, 0.25, 2.0, 0.1
OUTER, INNER = sqrt((WIDE + RADIUS) ** 2 - OFF**2), sqrt((WIDE - RADIUS) ** 2 - OFF**2)


def crossing(sensor: Shape | Ball, ball: Ball, substeps: int, **settings: Any) -> list[tuple[HitKind, float]]:
    """The kinds and times of the hits of one second."""
    world = World(**({"detection": "continuous", "substeps": substeps} | settings))
    world.add(sensor)
    world.add(ball)
    hits = [(hit.kind, hit.time) for hit in world.step(1.0)]
    assert world.statistics.stalled == 0
    return hits


def alternating(times: list[float]) -> list[tuple[HitKind, Any]]:
    """In, out, in, out at the times."""
    kinds = (HitKind.ENTER, HitKind.EXIT)
    return [(kinds[k % 2], pytest.approx(time, abs=1e-9)) for k, time in enumerate(times)]


def past(*places: float) -> list[float]:
    """When a ball from x = -10 comes to places."""
    return [(10 + x) / SPEED for x in places]


CROSSINGS: dict[str, tuple[Shape | Ball, float, list[float]]] = {
    "segment": (Segment((0, -2), (0, 2), sensor=True), OFF, past(-RADIUS, RADIUS)),
    "segment from its end": (Segment((-3, 0), (3, 0), sensor=True), OFF, past(-3, 3)),
    "beside a segment": (Segment((0, 0), (0, 2), sensor=True), -OFF, []),
    "point": (Point((0, 0), sensor=True), OFF, past(-sqrt(RADIUS**2 - OFF**2), sqrt(RADIUS**2 - OFF**2))),
    "circle": (Circle((0, 0), WIDE, sensor=True), OFF, past(-OUTER, -INNER, INNER, OUTER)),
    "disc": (Circle((0, 0), WIDE, sensor=True, solid=True), OFF, past(-OUTER, OUTER)),
    "arc": (Arc((0, 0), WIDE, pi - 1, pi + 1, sensor=True), OFF, past(-OUTER, -INNER)),
    "arc from inside": (Arc((0, 0), WIDE, -1, 1, sensor=True), OFF, past(INNER, OUTER)),
    "ball": (Ball((0, 0), WIDE, sensor=True), OFF, past(-OUTER, OUTER)),
    "segment that travels": (
        Segment((0, -2), (0, 2), sensor=True, motion="kinematic", velocity=(-SPEED / 4, 0)),
        OFF,
        [time / 1.25 for time in past(-RADIUS, RADIUS)],
    ),
    "disc that travels": (
        Circle((0, 0), WIDE, sensor=True, solid=True, motion="kinematic", velocity=(-SPEED / 4, 0)),
        OFF,
        [time / 1.25 for time in past(-OUTER, OUTER)],
    ),
}


@pytest.mark.parametrize("name", CROSSINGS)
@pytest.mark.parametrize("substeps", [1, 4])
def test_a_ball_crosses_a_sensor_within_a_step(name: str, substeps: int) -> None:
    sensor, height, times = CROSSINGS[name]
    ball = Ball((-10, height), RADIUS, velocity=(SPEED, 0))
    assert crossing(deepcopy(sensor), ball, substeps) == alternating(times)


def test_a_ball_that_is_a_sensor_crosses_a_wall() -> None:
    ball = Ball((-10, 0), RADIUS, velocity=(SPEED, 0), sensor=True)
    assert crossing(Segment((0, -2), (0, 2)), ball, 4) == alternating(past(-RADIUS, RADIUS))
    assert ball.velocity == (SPEED, 0)


@pytest.mark.parametrize("substeps", [1, 4])
def test_a_ball_falls_through_a_sensor(substeps: int) -> None:
    sensor = Segment((-2, -2), (2, -2), sensor=True)
    times = [sqrt(2 * (2 - RADIUS) / 10), sqrt(2 * (2 + RADIUS) / 10)]
    assert crossing(sensor, Ball((0, 0), RADIUS), substeps, gravity=(0, -10)) == alternating(times)


@pytest.mark.parametrize("substeps", [1, 4])
def test_sensors_turn_over_a_ball_at_rest(substeps: int) -> None:
    turns = {"motion": "kinematic", "pivot": (0, 0), "angular_velocity": pi, "sensor": True}
    half = asin(RADIUS / 2)
    bar = Segment((0, 0), (4, 0), **turns)
    assert crossing(bar, Ball((0, 2), RADIUS), substeps) == alternating([0.5 - half / pi, 0.5 + half / pi])
    half = 2 * asin(0.5 * (RADIUS + 0.5) / 2)
    disc = Circle((2, 0), 0.5, solid=True, **turns)
    assert crossing(disc, Ball((0, 2), RADIUS), substeps) == alternating([0.5 - half / pi, 0.5 + half / pi])


def test_a_bounce_within_a_sensor_neither_leaves_nor_enters_it() -> None:
    world = World(detection="continuous")
    world.add(Segment((0, -3), (0, 3)))
    world.add(Circle((0, 0), 1, sensor=True, solid=True))
    world.add(Ball((-5, 0), RADIUS, velocity=(10, 0)))
    kinds = [(hit.kind, hit.time) for hit in world.step(1)]
    expected = [(HitKind.ENTER, 0.375), (HitKind.BOUNCE, 0.475), (HitKind.EXIT, 0.575)]
    assert kinds == [(kind, pytest.approx(time, abs=1e-9)) for kind, time in expected]


def test_a_ball_that_begins_in_a_sensor_enters_at_once() -> None:
    world = World(detection="continuous")
    world.add(Circle((0, 0), 1, sensor=True, solid=True))
    world.add(Ball((0, 0), RADIUS, velocity=(1, 0)))
    assert [(hit.kind, hit.time) for hit in world.run(2)] == alternating([0.0, 1.25])


@pytest.mark.parametrize("how", ["remove", "switch off"])
def test_a_sensor_that_goes_is_left(how: str) -> None:
    world = World(detection="continuous")
    sensor = world.add(Circle((0, 0), 1, sensor=True, solid=True))
    world.add(Ball((0, 0), RADIUS))
    assert [hit.kind for hit in world.step(0.1)] == [HitKind.ENTER]
    if how == "remove":
        world.remove(sensor)
    else:
        sensor.can_collide = False
    assert [hit.kind for hit in world.step(0.1)] == [HitKind.EXIT]
    assert len(world.step(0.1)) == 0


def test_hits_come_in_order_of_time() -> None:
    rng = np.random.default_rng(3)
    world = World(detection="continuous", gravity=(0, -5), substeps=2)
    corners = [(-5.0, -5.0), (5.0, -5.0), (5.0, 5.0), (-5.0, 5.0)]
    for start, end in zip(corners, corners[1:] + corners[:1], strict=True):
        world.add(Segment(start, end))
    for _ in range(6):
        x, y = rng.uniform(-4, 4, 2)
        world.add(Segment((x, y), (x + rng.uniform(0.5, 2), y + rng.uniform(-1, 1)), sensor=True))
        world.add(Arc((y, x), rng.uniform(0.3, 1.5), rng.uniform(0, 6), rng.uniform(0, 6), sensor=True))
        world.add(Circle((-x, y), rng.uniform(0.3, 1.5), sensor=True))
    world.add_balls(rng.uniform(-4, 4, (12, 2)), velocity=rng.uniform(-20, 20, (12, 2)), radius=0.2)
    for _ in range(40):
        hits = np.asarray(world.step(1 / 20))
        assert (np.diff(hits["time"]) >= 0).all()
    # Each pair's hits with a sensor alternate.
    hits = np.asarray(world.run(1))
    sensing = hits[hits["kind"] != HitKind.BOUNCE]
    for pair in {(int(h["ball"]), int(h["shape"])) for h in sensing}:
        kinds = sensing["kind"][(sensing["ball"] == pair[0]) & (sensing["shape"] == pair[1])]
        assert (kinds[1:] != kinds[:-1]).all()


def ring_with_sensors(seed: int) -> World:
    """Balls that lose all at impacts and slide round a ring, through sensors that lie anywhere near it."""
    random = np.random.default_rng(seed)
    world = World(gravity=(0.0, -1.0), friction=2.0)
    world.add(Circle((0, 0), 6.0))
    for _ in range(30):
        angle, way = random.uniform(0, 2 * pi), random.uniform(-2, 2, 2)
        start = random.uniform(4.5, 6.0) * np.array([cos(angle), sin(angle)])
        world.add(Segment(start.tolist(), (start + way).tolist(), sensor=True))
    for angle in 0.9 * np.arange(7):
        speed = random.uniform(0, 25) * random.choice([1, 1, 1, -1])
        place, velocity = (5.4 * cos(angle), 5.4 * sin(angle)), (-speed * sin(angle), speed * cos(angle))
        world.add(Ball(place, 0.5, velocity=velocity, elasticity=0.0, mass=float(random.choice([1, 2, 100]))))
    return world


@pytest.mark.compiled
@pytest.mark.parametrize("seed", range(30))
def test_balls_that_slide_over_the_ends_of_sensors_go_on(seed: int) -> None:
    world, crossings = ring_with_sensors(seed), 0
    inside: set[tuple[int, int]] = set()
    for _ in range(8):
        with within(60.0):
            hits = world.step(0.25)
        for hit in hits:
            if hit.kind != HitKind.BOUNCE:
                # Who comes in was not inside, and who leaves was.
                assert (hit.kind == HitKind.EXIT) == ((hit.ball.id, hit.shape.id) in inside)
                inside ^= {(hit.ball.id, hit.shape.id)}
                crossings += 1
    assert crossings > 20


def grazing(seed: int) -> World:
    """A ball that comes as near to another one, which is a sensor, as to touch it, but for rounding."""
    random = np.random.default_rng(seed)
    ux, uy = [(0.6, 0.8), (0.8, -0.6), (1.0, 0.0), (0.0, 1.0), (-5 / 13, 12 / 13)][int(random.integers(5))]
    radii = random.choice([0.25, 0.5, 0.625, 1.0], 2).tolist()
    aside = sum(radii) * float(random.choice([-1, 1]))
    before = float(random.choice([1.0, 2.0, 3.5]))
    x, y = random.integers(-40, 40, 2) / 8.0 if random.random() < 0.5 else random.uniform(-9, 9, 2)
    vx, vy = random.integers(-3, 4, 2) if random.random() < 0.5 else random.uniform(-9, 9, 2)
    speed = float(random.choice([1.0, 3.0, 5.0]))
    world = World(gravity=[(0.0, 0.0), (0.0, -4.0), (3.0, -4.0)][int(random.integers(3))])
    world.add(Ball((x, y), radii[0], velocity=(vx, vy), sensor=True))
    place = x - aside * uy - before * ux, y + aside * ux - before * uy
    world.add(Ball(place, radii[1], velocity=(vx + speed * ux, vy + speed * uy)))
    return world


@pytest.mark.compiled
@pytest.mark.usefixtures("step_compiled")
@pytest.mark.parametrize("first", range(0, 2000, 500))
def test_a_ball_that_grazes_a_sensor_comes_in_and_out_once_or_not_at_all(first: int) -> None:
    touched = 0
    for seed in range(first, first + 500):
        with within(20.0):
            hits = grazing(seed).run(4.0, dt=0.25 if seed % 2 else 0.3)
        assert [hit.kind for hit in hits] in ([], [HitKind.ENTER, HitKind.EXIT]), seed
        touched += len(hits) > 0
    assert 50 < touched < 450


def round_numbers(seed: int) -> World:
    """Elastic balls of places, sizes and velocities that are round, many of them sensors: much happens at one time."""
    random = np.random.default_rng(seed)
    world = World(gravity=[(0.0, 0.0), (0.0, -4.0), (3.0, -4.0)][int(random.integers(3))])
    world.add(*box(8.0, 6.0))
    for _ in range(12):
        place = float(random.integers(2, 29)) / 4, float(random.integers(2, 21)) / 4
        radius, sensor = float(random.choice([0.5, 0.25])), bool(random.random() < 0.4)
        world.add(Ball(place, radius, velocity=random.integers(-3, 4, 2).tolist(), sensor=sensor))
    return world


@pytest.mark.compiled
@pytest.mark.usefixtures("step_compiled")
@pytest.mark.parametrize("seed", [*range(20), 1290, 2969])
def test_sensors_end_a_step_whatever_touches_at_once(seed: int) -> None:
    with within(20.0):
        hits = round_numbers(seed).run(2.0, dt=1 / 32)
    assert sum(hit.kind != HitKind.BOUNCE for hit in hits) < 300


def fast_among_sensors(seed: int, power: int, spin: float) -> tuple[World, float]:
    """A ball of 10^power lengths a second in a box with sensors, some steps after its beginning; and its speed."""
    random = np.random.default_rng(seed)
    world = World()
    moving: dict[str, Any] = {"motion": "kinematic", "angular_velocity": spin, "pivot": (3.0, 4.0)} if spin else {}
    places = random.uniform(1, 5, (4, 2)).tolist()
    world.add(
        *box(6.0, 6.0),
        Circle(places[0], float(random.uniform(0.2, 1.0)), solid=True, sensor=True, **moving),
        Segment(places[1], places[2], sensor=True, **moving),
        Arc(places[3], float(random.uniform(0.3, 1.0)), 0.3, float(random.uniform(1.0, 6.0)), sensor=True, **moving),
    )
    ball = world.add(Ball((1, 1), 0.25))
    for _ in range(3):
        world.step(float(random.uniform(0.2, 0.7)))
    angle, speed = random.uniform(0, 2 * pi), 10.0**power
    ball.velocity = speed * cos(angle), speed * sin(angle)
    return world, speed


@pytest.mark.compiled
@pytest.mark.usefixtures("step_compiled")
@pytest.mark.parametrize("power", [0, 10, 20, 22, 23, 24, 25, 26])
@pytest.mark.parametrize("spin", [0.0, 0.7])
def test_a_ball_so_fast_that_no_instant_tells_where_it_comes_onto_a_sensor_crosses_it(spin: float, power: int) -> None:
    crossed = 0
    for seed in range(60):
        world, speed = fast_among_sensors(seed, power, spin)
        inside = {contact.shape.id for contact in world.contacts(sensors=True)}
        with within(20.0):
            hits = world.step(20 / speed)
        for hit in hits:
            if hit.kind != HitKind.BOUNCE:
                assert (hit.shape.id in inside) == (hit.kind == HitKind.EXIT), seed
                inside ^= {hit.shape.id}
                crossed += 1
    assert crossed > 120
