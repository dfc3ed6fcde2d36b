"""An impact is where and when it is to the last digits, whatever the age of the world and the length of its steps.

Exact rational numbers say where a ball of double-precision place and velocity touches.
"""

from fractions import Fraction
from math import ulp

import hypothesis.strategies as st
import pytest
from hypothesis import assume, given

import carom
from carom.world.hits import Hit
from tests.worlds import continuous_world

#: Units in the last place of the largest coordinate concerned.
MOST = 4.0
#: Seconds for which nothing was in the world; it counts them in doubles.
AGES = st.sampled_from([0.0, 1.0, 1e3, 1e6, 1e9])
STEPS = st.sampled_from([1e-4, 1e-3, 1 / 60, 1.0, 1e3, 1e5])
RADII = st.floats(0.01, 1.0)
#: How many radii a ball flies, and in how many steps.
WAYS = st.floats(3.0, 1e4)
COUNTS = st.floats(1.0, 40.0)


def first_hit(world: carom.World, dt: float) -> Hit:
    """The first hit of a world that makes steps of `dt`."""
    for _ in range(60):
        for hit in world.step(dt):
            return hit
    raise AssertionError("nothing was hit")


def ulps(found: float, exact: Fraction, scale: float) -> float:
    """How far a number is from an exact one, in units of the last place of the larger of it and a scale."""
    return float(abs(Fraction(found) - exact)) / ulp(max(abs(float(exact)), abs(scale)))


@pytest.mark.compiled
@given(age=AGES, dt=STEPS, radius=RADII, way=WAYS, count=COUNTS, slope=st.floats(-1, 1), height=st.floats(-1, 1))
def test_a_ball_touches_a_wall_where_rational_numbers_say(
    age: float, dt: float, radius: float, way: float, count: float, slope: float, height: float
) -> None:
    wall, speed = way * radius, way * radius / (count * dt)
    world = continuous_world(carom.Segment((wall, -3 * wall), (wall, 3 * wall)))
    world.step(age or dt)
    world.add(carom.Ball((0, height * wall), radius, velocity=(speed, slope * speed)))
    x, y = first_hit(world, dt).position
    flown = (Fraction(wall) - Fraction(radius)) / Fraction(speed)
    assert ulps(x, Fraction(wall) - Fraction(radius), wall) <= MOST
    assert ulps(y, Fraction(height * wall) + Fraction(slope * speed) * flown, height * wall) <= MOST


@pytest.mark.compiled
@given(age=AGES, dt=STEPS, radius=RADII, way=WAYS, count=COUNTS, share=st.floats(-0.9, 0.2))
def test_two_balls_touch_where_rational_numbers_say(
    age: float, dt: float, radius: float, way: float, count: float, share: float
) -> None:
    apart, speed = way * radius, way * radius / (count * dt)
    assume(apart > 2.1 * radius)
    world = continuous_world()
    world.step(age or dt)
    world.add(carom.Ball((0, 0), radius, velocity=(speed, 0)))
    world.add(carom.Ball((apart, 0), radius, velocity=(share * speed, 0)))
    hit = first_hit(world, dt)
    flown = (Fraction(apart) - 2 * Fraction(radius)) / (Fraction(speed) - Fraction(share * speed))
    x, y = hit.position
    assert ulps(x, Fraction(apart) + Fraction(share * speed) * flown, apart) <= MOST
    assert y == 0.0
