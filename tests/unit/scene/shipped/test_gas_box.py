"""The gas is one in equilibrium, of the area fraction that it promises."""

import pytest

from carom import scenes


def test_the_gas_is_an_equilibrium() -> None:
    scene = scenes.gas(balls=500)
    world = scene.build()
    area = (world.shapes[0].length) ** 2
    assert 500 * 3.141592653589793 * 0.25 / area == pytest.approx(0.20)
    assert world.balls.velocity.sum(axis=0) == pytest.approx((0.0, 0.0), abs=1e-9)
    assert (world.balls.velocity**2).sum(axis=1).mean() == pytest.approx(7.5**2)
    assert scenes.gas(balls=1).balls[0].velocity != (0.0, 0.0)
