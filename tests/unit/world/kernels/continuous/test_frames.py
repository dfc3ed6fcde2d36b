"""Between two steps: what is seen and read back. What nobody changed goes on; a step that fails leaves no trace."""

from typing import Any

import numpy as np
import pytest

from carom import Ball, Circle, NonFiniteState, Segment, World
from carom.rows.flight import COURSE, NO_TICK
from carom.rows.state import MOVERS, UNCHANGED, WHOLE
from tests.worlds import box, continuous_world


def room(**settings: Any) -> World:
    """Balls that fly in a box under gravity, a shape that turns and a sensor."""
    mill = Segment((3, 4), (5, 4.2), motion="kinematic", pivot=(4, 4), angular_velocity=1.5)
    eye = Circle((6, 2), 0.8, solid=True, sensor=True)
    world = continuous_world(*box(8, 8), mill, eye, **({"gravity": (0.3, -4.0)} | settings))
    for k in range(4):
        world.add(Ball((1.2 + 1.6 * k, 1.5 + 1.3 * k), 0.3, velocity=(2 - k, 3 + k), elasticity=0.9))
    return world


def courses(world: World) -> list[bytes]:
    """What tells the flights of the balls, but for what was shown of them last."""
    names = [name for name in COURSE.names or () if not name.startswith("shown")]
    flights = world._arrays.flights[: world._arrays.balls.count]
    return [b"".join(flight[name].tobytes() for name in names) for flight in flights]


def picture(world: World) -> list[Any]:
    """What is seen of a world."""
    shapes = [(shape.orientation, shape.position, shape.angular_velocity) for shape in world.shapes]
    return [world.time, world.balls.position.tolist(), world.balls.velocity.tolist(), shapes]


def rewrite(world: World) -> None:
    """Write everything of the balls where it stands, through views and objects."""
    balls = world.balls
    balls.position[:] = balls.position.copy()
    balls.velocity[:] = balls.velocity.copy()
    rows = world._arrays.balls.used
    for name in ("x", "y", "vx", "vy"):
        rows[name] = rows[name].copy()


def test_writing_what_stands_there_is_no_change() -> None:
    films = []
    for rewrites in (False, True):
        world, times = room(), []
        for _ in range(40):
            if rewrites:
                rewrite(world)
            times += [hit.tobytes() for hit in np.asarray(world.step(1 / 16))]
        films.append((times, picture(world), courses(world)))
    assert films[0] == films[1]
    assert len(films[0][0]) >= 10


@pytest.mark.parametrize("name", ["x", "vy"])
def test_a_ball_that_was_changed_alone_begins_a_new_flight(name: str) -> None:
    world = room(gravity=(0, 0))
    world.step(0.0625)
    before = courses(world)
    world._arrays.balls.used[2][name] += 1e-3
    world.step(2.0**-30)
    after = courses(world)
    assert [one == other for one, other in zip(before, after, strict=True)] == [True, True, False, True]
    assert world._arrays.flights["time"][2] == 0.0625


@pytest.mark.parametrize("which", [0, 1])
def test_of_two_that_lie_on_each_other_one_may_be_put_elsewhere(which: int) -> None:
    floor = Segment((-9, 0), (9, 0))
    world = continuous_world(floor, gravity=(0, -10))
    balls = [world.add(Ball((0, 0.5 + k), 0.5, velocity=(0.5, 0), elasticity=0.3)) for k in range(2)]
    while not (world._arrays.flights["tick_time"][:2] < NO_TICK).all():
        world.step(1 / 240)
        assert world.time < 1.0
    world.balls.position[which] = (5, 0.5)
    for _ in range(60):
        world.step(1 / 60)
    assert (world._arrays.flights["tick_time"][:2] == NO_TICK).all()
    assert balls[which].position == pytest.approx((5.5, 0.5), abs=1e-6)
    # The other rolls on, or falls down.
    assert balls[1 - which].position[1] == pytest.approx(0.5, abs=0.01)


def test_the_rows_show_where_the_balls_are_and_their_flights_where_those_began() -> None:
    world = continuous_world(gravity=(0, -2))
    ball = world.add(Ball((1, 2), 1, velocity=(3, 4)))
    for time in (0.5, 1.0, 1.5):
        world.step(0.5)
        assert ball.position == (1 + 3 * time, 2 + 4 * time - time**2)
        assert ball.velocity == (3, 4 - 2 * time)
        flight = world._arrays.flights[0]
        assert [flight[name] for name in ("time", "x", "y", "vx", "vy")] == [0, 1, 2, 3, 4]


def test_a_run_shows_what_its_steps_would() -> None:
    stepped, ran = room(), room()
    hits = [hit.tobytes() for _ in range(60) for hit in np.asarray(stepped.step(1 / 16))]
    assert [hit.tobytes() for hit in np.asarray(ran.run(60 / 16, dt=1 / 16))] == hits
    assert picture(ran) == picture(stepped)
    assert courses(ran) == courses(stepped)


def failing(world: World) -> None:
    """Give a ball a speed with which the next long step overflows, and a short one does not."""
    world.balls[1].velocity = (1e308, 0)
    world.balls[1].can_collide = False


@pytest.mark.parametrize("walls", [0, 1])
@pytest.mark.parametrize("first", [0.0, 0.7])
def test_a_step_that_fails_leaves_everything_as_it_was(first: float, walls: int) -> None:
    world = room()
    world.step(first)
    world.add(*[Circle((0.5, 7.5), 0.1)] * walls)
    failing(world)
    before = picture(world)
    digest = world.digest()
    for _ in range(2):
        with pytest.raises(NonFiniteState):
            world.step(10.0)
        assert picture(world) == before
        assert world.digest() == digest
    # It goes on as if nothing had been tried.
    other = room()
    other.step(first)
    other.add(*[Circle((0.5, 7.5), 0.1)] * walls)
    failing(other)
    for tried in (world, other):
        tried.balls[1].velocity = (0, 1)
        tried.run(1.0, dt=1 / 16)
    assert picture(world) == picture(other)
    assert world.digest() == other.digest()


def test_a_second_step_of_a_run_that_fails_leaves_what_the_first_one_made() -> None:
    world, other = room(), room()
    for one in (world, other):
        one.step(0.25)
        one.balls[1].can_collide = False
        one.balls[1].velocity = (1.5e308, 0)
    with pytest.raises(NonFiniteState):
        world.run(3.0, dt=1.0)
    other.step(1.0)
    assert world.time == other.time == 1.25
    assert picture(world) == picture(other)
    for one in (world, other):
        one.balls[1].velocity = (0, 1)
        one.balls[1].position = (1.5, 1.5)
        one.run(1.0, dt=1 / 16)
    assert picture(world) == picture(other)


@pytest.mark.parametrize("steps", [3, 4])
def test_steps_made_at_once_that_fail_show_who_only_flew_where_those_before_left_it(steps: int) -> None:
    # The last of them shows its balls one by one, those before the one that overflows too.
    balls = Ball((0, 0), 1, velocity=(1, 2)), Ball((0, 9), 1, velocity=(0.8e308, 0))
    world = continuous_world(*balls, gravity=(0, -1))
    with pytest.raises(NonFiniteState):
        world._advance(steps, 1.0)
    assert world.time == 2.0
    assert world.balls[0].position == (2.0, 2.0)
    assert world.balls[0].velocity == (1.0, 0.0)


def test_a_mover_that_overflows_is_undone_too() -> None:
    world = room()
    world.add(Segment((0, 20), (1, 20), motion="kinematic", velocity=(1e308, 0)))
    world.step(0.5)
    before, digest = picture(world), world.digest()
    with pytest.raises(NonFiniteState):
        world.step(5.0)
    assert picture(world) == before
    assert world.digest() == digest


def test_shapes_are_copied_where_a_step_may_change_them_alone() -> None:
    world = room()
    hand = world.add(Segment((0, 20), (1, 20), motion="kinematic", angular_velocity=1.0, turn_limits=(0.0, 1.0)))
    kept = []
    for seconds in (0.25, 0.25, 0.25, 0.5, 0.25):
        world.step(seconds)
        kept.append(int(world._arrays.states[0]["kept_whole"]))
    # The hand comes to its stop in the fourth step.
    assert kept == [WHOLE, UNCHANGED, UNCHANGED, MOVERS, UNCHANGED]
    assert hand.orientation == 1.0
    world.add(Segment((0, 30), (1, 30), motion="kinematic", velocity=(1e300, 0)))
    for steps, expected in ((1, WHOLE), (1, MOVERS), (3, MOVERS)):
        world.run(steps * 0.25, dt=0.25)
        assert world._arrays.states[0]["kept_whole"] == expected


def test_what_was_seen_when_a_sensor_was_switched_off_is_left_now() -> None:
    world = continuous_world(Circle((0, 0), 2, solid=True, sensor=True))
    world.add(Ball((0, 0), 0.5, velocity=(0.1, 0)))
    assert len(world.step(0.5)) == 1
    world.shapes[0].can_collide = False
    (hit,) = world.step(0.5)
    assert (hit.kind.name, hit.time) == ("EXIT", 0.5)


def test_balls_that_come_and_go_do_not_change_the_flights_of_others() -> None:
    still, busy = continuous_world(gravity=(0, -1)), continuous_world(gravity=(0, -1))
    balls = [world.add(Ball((0.3, 0.7), 0.1, velocity=(1.1, 2.3))) for world in (still, busy)]
    for k in range(10):
        far = busy.add(Ball((50 + 3 * k, 0), 0.5))
        busy.step(0.1)
        busy.remove(far)
        still.step(0.1)
    assert balls[0].position == pytest.approx(balls[1].position, abs=1e-14)


@pytest.mark.parametrize("dt", [1.0, 0.25, 1 / 64])
def test_a_mover_that_is_changed_goes_on_from_where_it_is_seen(dt: float) -> None:
    def going() -> tuple[World, Segment]:
        made = Segment((0, 0), (2, 0), motion="kinematic", velocity=(1, 0), pivot=(0, 0), angular_velocity=0.5)
        world = continuous_world(made)
        world.run(1.0, dt=dt)
        return world, made

    world, made = going()
    made.velocity = (0, 1)
    world.run(1.0, dt=dt)
    assert (made.pivot, made.orientation) == ((1, 1), 1)
    world, made = going()
    made.angular_velocity = -0.5
    world.run(1.0, dt=dt)
    assert (made.pivot, made.orientation) == ((2, 0), 0)
    world, made = going()
    world.add(Ball((50, 50), 1))
    world.run(1.0, dt=dt)
    assert (made.pivot, made.orientation) == ((2, 0), 1)
    world, made = going()
    made.position = (5, 5)
    x, y = made.pivot
    world.run(1.0, dt=dt)
    assert made.pivot == pytest.approx((x + 1, y), abs=1e-15)
    world, made = going()
    made.move_to((7, 7), dt=0.5)
    world.run(1.0, dt=dt)
    assert (made.position, made.orientation) == ((7, 7), 0.5)


@pytest.mark.parametrize("sleep_speed", [0.0, 1.0])
def test_what_is_no_change_of_motions_leaves_them_as_they_were(sleep_speed: float) -> None:
    world, twin = room(sleep_speed=sleep_speed), room(sleep_speed=sleep_speed)
    mill, sensor = (shape for shape in world.shapes if shape.kind != "segment" or shape.motion)
    since = mill._row["since"]
    for k in range(6):
        post = world.add(Circle((0.5, 7.5), 0.1))
        world.step(0.1)
        post.position = (0.5 + 0.01 * k, 7.4)
        world.step(0.1)
        world.remove(post)
        sensor.elasticity = 0.5
        world.balls[0].velocity = (1.0, k)
        world.step(0.1)
        twin.run(0.3, 0.1)
        assert mill._row["since"] == since
        assert [shape.orientation for shape in twin.shapes if shape.motion] == [mill.orientation]
    mill.angular_velocity = 1.5
    world.step(0.1)
    assert mill._row["since"] == since
    mill.angular_velocity = 2.0
    world.step(0.1)
    assert mill._row["since"] == pytest.approx(1.9)


@pytest.mark.parametrize("change", ["mass", "velocity", "none"])
def test_of_an_island_all_are_solved_anew_where_one_was_changed(change: str) -> None:
    world = continuous_world(*box(4, 9), gravity=(0, -10))
    for k in range(4):
        world.add(Ball((1 + 0.3 * k, 0.6 + 0.8 * k), 0.4, elasticity=0.5))
    world.run(0.1)
    while not (world._arrays.flights["tick_time"][:4] < NO_TICK).all():
        world.step(1 / 60)
    before = world._arrays.flights["time"][:4].copy()
    if change != "none":
        setattr(world.balls[2], change, {"mass": 2.0, "velocity": (0, 0.1)}[change])
    world.step(1e-9)
    assert (world._arrays.flights["time"][:4] == before).all() == (change == "none")
    assert (world._arrays.flights["time"][:4] >= world.time - 2e-9).all() == (change != "none")
