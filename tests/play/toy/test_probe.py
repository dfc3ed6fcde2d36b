"""What the mouse points at, and the numbers that are read there."""

from typing import Any

import pytest

import carom
from carom.play.toy.probe import ball_at, read, shape_at

SHAPES: dict[str, Any] = {
    "segment": carom.Segment((1, 2), (4, 6), elasticity=0.5, kick=3.0, name="ramp"),
    "gate": carom.Gate((0, 0), (0, 2), direction=(1, 0)),
    "circle": carom.Circle((3, 4), 2.0, solid=True, name="bumper"),
    "arc": carom.Arc((3, 4), 2.0, start_angle=0.0, end_angle=1.5707963267948966),
    "point": carom.Point((7, -0.001)),
}
WANTED = {
    "segment": {
        "from": "(1.00, 2.00)",
        "to": "(4.00, 6.00)",
        "length": "5.00",
        "angle": "53.1°",
        "normal": "(-0.80, 0.60)",
    },
    "gate": {"lets pass": "(1.00, 0.00)", "length": "2.00"},
    "circle": {"center": "(3.00, 4.00)", "radius": "2.00", "solid": "yes", "box": "(1.00, 2.00) to (5.00, 6.00)"},
    "arc": {"from": "0.0°", "to": "90.0°", "radius": "2.00", "length": "3.14", "elasticity": "1"},
    "point": {"position": "(7.00, 0.00)"},
}


@pytest.mark.parametrize("kind", SHAPES)
def test_a_reading_has_the_numbers_of_the_shape(kind: str) -> None:
    reading = read(SHAPES[kind], 0.0)
    assert WANTED[kind].items() <= dict(reading.pairs).items()
    assert f"{kind}, static" in reading.title


def test_a_part_says_what_it_is_part_of_and_how_it_turns() -> None:
    arm = carom.Segment((0, 0), (1, 0))
    carom.Compound([arm], pivot=(0, 0), angular_velocity=2.0, rotating=True, name="vane")
    reading = read(arm, 0.0)
    assert reading.title == "vane, segment, kinematic"
    assert {"pivot": "(0.00, 0.00)", "turned": "0.0°", "turns": "2 rad/s"}.items() <= dict(reading.pairs).items()


def test_a_part_at_rest_says_that_it_does_not_turn() -> None:
    arm = carom.Segment((0, 0), (1, 0))
    carom.Compound([arm], pivot=(0, 0), angular_velocity=2.0, rotating=False)
    assert dict(read(arm, 0.0).pairs)["turns"] == "0 rad/s"


def test_a_ball_s_reading_has_its_motion_and_energy() -> None:
    world = carom.World(gravity=(0, -10))
    ball = world.add(carom.Ball((1, 2), radius=0.5, velocity=(3, 4), mass=2.0, name="cue"))
    reading = read(ball, 10.0)
    assert reading.title == f"cue {ball.id}"
    wanted = {
        "position": "(1.00, 2.00)",
        "velocity": "(3.00, 4.00)",
        "speed": "5.00",
        "energy": "65.00",
        "mass": "2.00",
    }
    assert wanted.items() <= dict(reading.pairs).items()
    assert dict(reading.pairs)["asleep"] == "no"


def test_the_nearest_within_reach_is_found_and_balls_come_first() -> None:
    world = carom.World()
    floor = world.add(carom.Segment((0, 0), (10, 0)))
    world.add(carom.Segment((0, 0.3), (10, 0.3)))
    ball = world.add(carom.Ball((5, 0.5), radius=0.5))
    assert shape_at(world, (2, 0.1), 0.25) is floor
    assert shape_at(world, (5, 0.1), 0.25) is ball
    assert ball_at(world, (5, 0.1), 0.25) is ball
    assert shape_at(world, (2, 5), 0.25) is None
    assert ball_at(world, (2, 0), 0.25) is None


def test_of_a_segment_and_its_end_point_the_segment_is_found() -> None:
    world = carom.World()
    world.add(carom.Point((0, 0)))
    floor = world.add(carom.Segment((0, 0), (10, 0)))
    assert shape_at(world, (-0.1, 0), 0.25) is floor
