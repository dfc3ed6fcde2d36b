"""Figures that balls fly at in tests of times of impact."""

from math import pi

from carom.geometry.arc import arc_ends

STILL = (0.0, 0.0)


FLOOR = (0.0, 0.0, 1.0, 0.0, 10.0)


RIGHT_HALF = (0.0, 0.0, 5.0, *arc_ends(0.0, 0.0, 5.0, 1.5 * pi, 0.5 * pi))


BOWL = (0.0, 0.0, 5.0, *arc_ends(0.0, 0.0, 5.0, pi, 0.0))


SLOP = 1e-9
