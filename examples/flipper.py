"""A flipper adds its own speed twice.
===================================

A ball falls on a flipper as it swings. The farther from the pivot it is met, the faster the surface is there, and an
elastic ball leaves with its own normal speed turned round and twice the surface's on top.
"""

import matplotlib.pyplot as plt
import numpy as np

import carom

TURN, FALL = 12.0, 2.0  # radians a second, lengths a second


def shot(place: float) -> float:
    """How fast a ball leaves that is met so far from the pivot, the flipper being level then."""
    world = carom.World()
    flipper = carom.Segment((0, 0), (3, 0), motion="kinematic", pivot=(0, 0), turn_limits=(-0.5, 0.5))
    flipper.rotate((0, 0), -TURN * 0.02)  # level after two hundredths of a second
    world.add(flipper)
    flipper.angular_velocity = TURN
    ball = world.add(carom.Ball((place, 0.2 + FALL * 0.02), radius=0.2, velocity=(0, -FALL)))
    hits = world.step(0.03)
    assert len(hits) >= 1
    return float(np.hypot(*ball.velocity))


places = np.linspace(0.3, 2.9, 14)
speeds = [shot(place) for place in places]
expected = FALL + 2 * TURN * places

_, axes = plt.subplots(figsize=(7, 3.6), layout="constrained")
axes.plot(places, expected, color="#d9480f", label="v + 2 ω · distance")
axes.plot(places, speeds, "o", color="#1f8aa8", label="balls")
axes.set_xlabel("distance from the pivot in lengths")
axes.set_ylabel("speed after the bounce in lengths/s")
axes.legend(frameon=False)
print(f"from {speeds[0]:.1f} near the pivot to {speeds[-1]:.1f} at the tip")
plt.show()
