"""Parts of tasks are checked where they are made, and a mistake is told as one of a scene is."""

from typing import Any

import pytest

import carom
from carom.rl import End, Impulse, Observation, Points, Reward, Spread, Travel, Turn


@pytest.mark.parametrize(
    ("make", "fields", "told"),
    [
        (Turn, {"shape": "x"}, "speeds: must be given, or `speed`, and not both"),
        (Turn, {"shape": "x", "speeds": (1.0, 2.0), "speed": 1.0}, "speeds: must be given, or `speed`, and not both"),
        (Turn, {"shape": "x", "speeds": (1.0,)}, r"speeds: must be two or more, not \(1.0,\)"),
        (Turn, {"shape": "x", "speed": -1.0}, "speed: must be positive, not -1.0"),
        (Turn, {"speed": 1.0}, "shape: is missing"),
        (Turn, {"shape": "x", "speed": 1.0, "limit": 3}, "limit: is unknown"),
        (Travel, {"shape": "x", "speed": 1.0, "direction": (0.0, 0.0)}, "direction: must not be zero"),
        (Travel, {"shape": "x", "speed": 1.0, "limits": (1.0, 2.0)}, r"limits: must hold 0, not \(1.0, 2.0\)"),
        (Impulse, {"ball": "x", "speed": float("inf")}, "speed: must be finite, not inf"),
        (Observation, {"pixels": (20, 80)}, r"pixels\[0\]: must be at least 64, not 20"),
        (Observation, {"turning": "*"}, r"turning: must be a regular expression, not '\*': nothing to repeat"),
        (Observation, {"turnin": "x"}, "turnin: is unknown; did you mean turning"),
        (Points, {"shapes": "x", "points": float("nan")}, "points: must be finite, not nan"),
        (Reward, {"points": [{"shapes": "x"}]}, r"points\[0\].points: is missing"),
        (End, {"actions": 0}, "actions: must be at least 1, not 0"),
        (Spread, {"position": (-1.0, 0.0)}, r"position: must not be negative, not \(-1.0, 0.0\)"),
        (Spread, {"angle": 4.0}, "angle: must be at most 3.14"),
    ],
)
def test_a_mistake_is_told_with_its_path(make: Any, fields: dict[str, Any], told: str) -> None:
    with pytest.raises(carom.TaskError, match=f"^{told}"):
        make(**fields)


def test_every_fault_is_told() -> None:
    with pytest.raises(carom.TaskError) as caught:
        Spread(position=1.0, angle="x")  # type: ignore[arg-type]
    assert [line.strip() for line in str(caught.value).splitlines()] == [
        "2 faults",
        "position: must be a pair of numbers, not 1.0",
        "angle: must be a number, not 'x'",
    ]


def test_the_top_speed_is_the_greatest_either_way() -> None:
    assert Turn(shape="x", speeds=(-9.0, 0.0, 4.0)).top_speed == 9.0
    assert Travel(shape="x", speed=3.0).top_speed == 3.0


def test_lists_and_whole_numbers_are_taken_as_files_give_them() -> None:
    asked: dict[str, Any] = {"shape": "x", "speeds": [-1, 1]}
    assert Turn(**asked) == Turn(shape="x", speeds=(-1.0, 1.0))
    asked = {"pixels": [64, 96]}
    assert Observation(**asked).pixels == (64, 96)
