"""What every shape has: options, which are attributes too, and their signature."""

import inspect

import pytest

from carom import Motion, Point, Shape
from carom.shapes import SHAPE_CLASSES


def test_the_defaults_of_every_shape() -> None:
    point = Point((3, 4))
    assert (point.elasticity, point.kick, point.sensor, point.can_collide) == (1.0, 0.0, False, True)
    assert (point.layer, point.collides_with) == (1, 2**32 - 1)
    assert (point.motion, point.pivot, point.orientation) == (Motion.STATIC, (3.0, 4.0), 0.0)
    assert (point.angular_velocity, point.rotating, point.turn_limits, point.velocity) == (0.0, True, None, (0.0, 0.0))
    assert (point.name, point.user, point.id, point.world, point.compound) == (None, None, None, None, None)


def test_options_are_attributes() -> None:
    tag = object()
    options = {
        "elasticity": 0.5,
        "kick": 2.0,
        "sensor": True,
        "can_collide": False,
        "once": True,
        "layer": 4,
        "collides_with": 6,
        "motion": "kinematic",
        "pivot": (1.0, 2.0),
        "angular_velocity": 3.0,
        "rotating": False,
        "turn_limits": (-1.0, 2.0),
        "velocity": (5.0, 6.0),
        "name": "post",
        "user": tag,
    }
    point = Point((3, 4), **options)
    assert point.motion is Motion.KINEMATIC
    assert {name: getattr(point, name) for name in options if name != "motion"} == {
        name: value for name, value in options.items() if name != "motion"
    }


def test_an_unknown_option_is_refused() -> None:
    with pytest.raises(TypeError, match="elasticty"):
        Point((0, 0), elasticty=0.5)  # type: ignore[call-arg]


def test_a_mistyped_attribute_is_refused() -> None:
    with pytest.raises(AttributeError):
        Point((0, 0)).elasticty = 0.5  # type: ignore[attr-defined]


@pytest.mark.parametrize("kind", SHAPE_CLASSES.values())
def test_signatures_show_the_options_of_every_shape(kind: type[Shape]) -> None:
    parameters = inspect.signature(kind).parameters
    common = list(inspect.signature(Point).parameters)[1:]
    assert list(parameters)[-len(common) :] == common
    assert len(common) == 15
    assert all(parameters[name].kind is inspect.Parameter.KEYWORD_ONLY for name in common)
