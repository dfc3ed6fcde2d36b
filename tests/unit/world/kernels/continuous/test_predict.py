"""What comes next for a ball: the first event of all, and the same one from whatever age of the flight one looks."""

from math import inf, pi
from random import Random

import numpy as np
import pytest

import carom
from carom.constants import FINEST_LEVEL
from carom.rows.flight import CLEAR, EXIT_BALL, HIT_BALL, HIT_SHAPE, LEAVE, LOOK, NO_BALL, NOTHING
from carom.rows.kinds_in_motion import impact_at_rest
from carom.rows.relation import INSIDE_BALL, LASTING, PASSING
from carom.world.kernels.continuous.bins import file_ball, open_bins, side_of, unfile_ball
from carom.world.kernels.continuous.flight import event_age, path_of
from carom.world.kernels.continuous.predict import file_anew, predict
from carom.world.kernels.continuous.queue import front_of, open_queue
from carom.world.kernels.continuous.surfaces import impact_in_motion
from carom.world.kernels.step.relations import add_relation
from carom.world.tables import Arrays
from tests.kernel_calls import film_tables, foresee_all, foresee_own, foreseen, in_flight, look_at
from tests.worlds import continuous_world

BALLS = 12

Event = tuple[int, float, float, int]


def furniture(seed: int, few: bool, sensors: bool = False) -> list[carom.Shape]:
    """Shapes all over the place, some of which move."""
    random = Random(seed)

    def place(size: float = 9.0) -> tuple[float, float]:
        return random.uniform(-size, size), random.uniform(-size, size)

    shapes: list[carom.Shape] = []
    for _ in range(3 if few else 15):
        shapes.append(carom.Segment(place(), place()))
        shapes.append(carom.Circle(place(), random.uniform(0.1, 1)))
        shapes.append(carom.Point(place()))
        start = random.uniform(0, 6)
        shapes.append(carom.Arc(place(), random.uniform(0.5, 3), start, (start + 2) % (2 * pi)))
    shapes += [
        carom.Segment(place(), place(), motion="kinematic", velocity=place(1), angular_velocity=0.5)
        for _ in range(2 if few else 12)
    ]
    for shape in shapes[::2] if sensors else ():
        shape.sensor = True
    return shapes


def furnished(
    seed: int, few: bool, broad_phase: str = "grid", pull: float = 4.0, sensors: bool = False, shuffled: int = 0
) -> Arrays:
    """Shapes all over the place, and balls that fly among them."""
    random, shapes = Random(seed + 100), furniture(seed, few, sensors)
    if shuffled:
        Random(shuffled).shuffle(shapes)
    world = carom.World(detection="continuous", gravity=(0.25 * pull, -pull), broad_phase=broad_phase)
    world.add(*shapes)
    for _ in range(BALLS):
        place, velocity = ([random.uniform(-size, size) for _ in range(2)] for size in (9.0, 20.0))
        world.add(carom.Ball(tuple(place), random.uniform(0.05, 0.3), velocity=tuple(velocity)))
    return in_flight(world, 1.5)


def earliest(arrays: Arrays, i: int, until: float) -> float:
    """When a ball first touches any shape, each asked in turn."""
    ball, flight, first = arrays.balls.rows[i], arrays.flights[i], inf
    path, radius = path_of(ball, flight), float(ball["radius"])
    for shape in arrays.shapes.used:
        found = (
            impact_in_motion(shape, 0.0, path, radius, until, 1.0)
            if shape["motion"]
            else impact_at_rest(shape, path, radius, until)
        )
        first = min(first, inf if found is None else found)
    return first


def seen_from(arrays: Arrays, i: int, age: float) -> Event:
    """The first event of a ball that is no look, as it is foreseen from an age of its flight on."""
    for _ in range(200):
        look_at(arrays, age)
        event = foresee_own(arrays, i)
        if event[0] != LOOK or event[1] > 1e3:
            return event
        assert event_age(arrays.flights[i]) > age
        age = event_age(arrays.flights[i])
    raise AssertionError("a ball looks for ever")


@pytest.mark.slow
@pytest.mark.parametrize(
    ("few", "broad_phase"), [(True, "grid"), (False, "grid"), (False, "brute"), (False, "quadtree")]
)
@pytest.mark.parametrize("seed", range(2))
def test_the_impact_that_is_foreseen_is_the_first_of_all(seed: int, few: bool, broad_phase: str) -> None:
    arrays, seen = furnished(seed, few, broad_phase), 0
    for i in range(BALLS):
        event, time, low, _partner = seen_from(arrays, i, 0.0)
        expected = earliest(arrays, i, 1.5)
        if expected < inf:
            seen += 1
            assert event == HIT_SHAPE
            assert time + low == pytest.approx(expected, abs=1e-12)
        else:
            assert time > 1.5
    assert seen >= 6


@pytest.mark.slow
@pytest.mark.parametrize("sensors", [False, True])
@pytest.mark.parametrize("pull", [0.0, 4.0])
@pytest.mark.parametrize("few", [True, False])
@pytest.mark.parametrize("seed", range(2))
def test_from_any_age_of_a_flight_the_same_is_foreseen_to_the_bit(
    seed: int, few: bool, pull: float, sensors: bool
) -> None:
    arrays, random, seen = furnished(seed, few, pull=pull, sensors=sensors), Random(seed), 0
    for i in range(BALLS):
        expected = seen_from(arrays, i, 0.0)
        if expected[0] in (NOTHING, LOOK):
            continue
        seen += 1
        for share in [0.1, 0.5, 0.999, *(random.random() for _ in range(4))]:
            assert seen_from(arrays, i, share * expected[1]) == expected
    assert seen >= 6


@pytest.mark.slow
@pytest.mark.parametrize("sensors", [False, True])
@pytest.mark.parametrize("few", [True, False])
@pytest.mark.parametrize("seed", range(2))
def test_in_whatever_order_shapes_were_added_the_same_is_foreseen_to_the_bit(
    seed: int, few: bool, sensors: bool
) -> None:
    films = []
    for shuffled in range(3):
        arrays = furnished(seed, few, sensors=sensors, shuffled=shuffled)
        rows = arrays.shapes.used
        events = [seen_from(arrays, i, 0.0) for i in range(BALLS)]
        films.append(
            [
                (event, time, low, *([] if partner == NO_BALL else [float(rows[partner][x]) for x in ("cx", "cy")]))
                for event, time, low, partner in events
            ]
        )
    assert films[0] == films[1] == films[2]


@pytest.mark.slow
@pytest.mark.parametrize("pull", [0.0, 4.0])
@pytest.mark.parametrize("seed", range(3))
def test_the_index_finds_what_asking_all_shapes_finds_to_the_bit(seed: int, pull: float) -> None:
    films = []
    for broad_phase in ("grid", "brute", "quadtree"):
        arrays = furnished(seed, False, broad_phase, pull)
        films.append([seen_from(arrays, i, 0.0) for i in range(BALLS)])
    assert films[0] == films[1] == films[2]
    assert sum(event[0] == HIT_SHAPE for event in films[0]) >= 6


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(2))
def test_the_front_of_the_queue_is_the_first_event_of_all_balls(seed: int) -> None:
    arrays = furnished(seed, False)
    arrays.balls.rows["collides_with"], arrays.balls.rows["layer"] = 1, 2
    arrays.shapes.rows["layer"] = 1
    arrays.shapes.rows["collides_with"] = 2
    heads = foresee_all(arrays)
    times = [foreseen(arrays, i)[1] for i in range(BALLS)]
    assert arrays.states[0]["queued"] == sum(time < inf for time in times)
    assert arrays.queue[0]["ball"] == int(np.argmin(times))
    # Where nothing is to come any more, a ball leaves the queue.
    first = int(arrays.queue[0]["ball"])
    arrays.balls.rows["can_collide"][first] = 0
    tables = *film_tables(arrays), heads, arrays.relations, arrays.flights, arrays.queue
    predict(arrays.states[0], arrays.balls.rows, *tables, first)
    assert foreseen(arrays, first)[0] != HIT_SHAPE
    assert foreseen(arrays, first)[1] > times[first]


@pytest.mark.parametrize("gravity", [(0.0, 0.0), (0.0, -9.0)])
@pytest.mark.parametrize("many", [False, True])
def test_a_ball_far_away_that_never_meets_anything_has_no_event(gravity: tuple[float, float], many: bool) -> None:
    shapes = [carom.Circle((3 * k, 0), 1) for k in range(40 if many else 4)]
    arrays = in_flight(continuous_world(*shapes, carom.Ball((500, -3000), 1, velocity=(70, -10)), gravity=gravity))
    assert foresee_own(arrays) == (NOTHING, inf, 0.0, NO_BALL)
    foresee_all(arrays)
    assert arrays.states[0]["queued"] == 0


@pytest.mark.parametrize("many", [False, True])
def test_a_ball_that_comes_from_far_or_fast_is_foreseen_as_exactly(many: bool) -> None:
    for speed in (1.0, 1e4, 1e9):
        shapes = [carom.Circle((3 * k, 0), 1) for k in range(40 if many else 4)]
        arrays = in_flight(continuous_world(*shapes, carom.Ball((3, 1e6), 1, velocity=(0, -speed))))
        event, time, _low, partner = seen_from(arrays, 0, 0.0)
        assert (event, partner) == (HIT_SHAPE, 1)
        assert time == pytest.approx((1e6 - 2) / speed, rel=1e-15)


@pytest.mark.parametrize(("kind", "event"), [(PASSING, CLEAR), (LASTING, LEAVE)])
def test_what_a_ball_passes_or_rests_on_is_no_impact_but_its_end_is_foreseen(kind: int, event: int) -> None:
    arrays = in_flight(
        continuous_world(carom.Segment((-5, 0), (5, 0)), carom.Ball((4.5, 0.6), 1, velocity=(2, 0))), 100.0
    )
    add_relation(arrays.states[0], arrays.relations, arrays.balls.rows[0], 0, kind, 0)
    found = seen_from(arrays, 0, 0.0)
    assert (found[0], found[3]) == (event, 0)
    # A ball leaves what it rests on when its centre is past the end, and is clear of what it passed with its whole.
    assert found[1] == pytest.approx(0.25 if event == LEAVE else 0.65, abs=1e-8)


def test_a_ball_that_is_filed_under_a_wider_level_asks_all_who_are_near_there() -> None:
    world = continuous_world(*[carom.Ball((3.0 * k, -1.5), 0.5) for k in range(20)])
    world.add(carom.Ball((0.0, 0.0), 0.5, velocity=(1.0, 0.0)), carom.Ball((900.0, 0.0), 0.5, velocity=(-1.0, 0.0)))
    arrays = in_flight(world)
    state, balls, flights, heads = arrays.states[0], arrays.balls.rows, arrays.flights, np.zeros(4096, "i4")
    assert open_bins(state, balls, flights, heads)
    open_queue(state, arrays.queue)
    near, far = 20, 21
    # The one has flown far; so has the other when it comes to the next cell.
    unfile_ball(state, flights, heads, far)
    file_ball(state, balls, flights, heads, far, 0.0, FINEST_LEVEL + 1)
    flights[near]["filings"] = 1000
    look_at(arrays, 1.3 * side_of(state, int(flights[near]["level"])))
    # The cell that it comes from has nearly the same numbers as the other one's, but of another level.
    assert max(abs(int(flights[near][name]) - int(flights[far][name])) for name in ("column", "line")) <= 1
    flights[[near, far]]["event"] = NOTHING
    file_anew(state, balls, *film_tables(arrays)[:3], heads, flights, arrays.relations, arrays.queue, near)
    assert flights[near]["level"] == FINEST_LEVEL + 1
    assert foreseen(arrays, near)[0] == HIT_BALL
    assert flights[near]["partner"] == far


@pytest.mark.parametrize("put", [7.0, -40.0])
def test_who_has_a_ball_inside_that_is_put_far_away_foresees_at_once_that_it_has_left(put: float) -> None:
    world = continuous_world(carom.Ball((0.1, 0.0), 0.5), carom.Ball((0.0, 0.0), 0.5, sensor=True))
    world.add(*[carom.Ball((3.0 * k, 3.0), 0.5) for k in range(9)])
    arrays = in_flight(world)
    state, balls, flights, heads = arrays.states[0], arrays.balls.rows, arrays.flights, np.zeros(4096, "i4")
    inner, outer = 0, 1
    add_relation(state, arrays.relations, balls[outer], outer, INSIDE_BALL, inner)
    assert open_bins(state, balls, flights, heads)
    open_queue(state, arrays.queue)
    flights[outer]["event"] = NOTHING
    balls[inner]["x"] = put
    flights[inner]["version"] += 1
    tables = *film_tables(arrays), heads, arrays.relations, flights, arrays.queue
    predict(state, balls, *tables, inner)
    assert foreseen(arrays, outer)[0] == EXIT_BALL
    assert (flights[outer]["event_time"], flights[outer]["partner"]) == (0.0, inner)
    # It is the next event of all.
    assert front_of(state, flights, arrays.queue) == outer
