"""Every tolerance and fixed number of the library: its unit, why this value, and what breaks if it changes."""

from math import pi

TWO_PI = 2.0 * pi
HALF_PI = 0.5 * pi

#: Fraction of a ball's radius. Discrete mode: a ball whose centre comes into a slab or sector while it overlaps the
#: shape by more than this passes it. Smaller, and a ball that rolls over a slightly uneven joint falls through; larger,
#: and a ball that comes round a bare end is thrown back by most of its radius.
END_DEPTH_DISCRETE = 0.25

#: The same in continuous mode, where overlaps come from rounding alone.
END_DEPTH_CONTINUOUS = 1e-6

#: Fraction of a ball's radius by which slabs and sectors reach past their ends in continuous mode, so that rounding
#: leaves no gap at an exact joint. Far above rounding (1e-16), far below anything that is seen.
END_SLOP = 1e-9

#: Length, default of `guard_points`: ends closer than this are one place. Well above the rounding of coordinates up
#: to 1e4, well below any gap that is meant.
GUARD_TOLERANCE = 1e-9

#: Radians, default of `guard_points`: two ends whose outward tangents are opposite within this continue each other.
#: A joint of 1e-6 rad turns a ball's velocity by less than 1e-6 of its speed.
GUARD_ANGLE_TOLERANCE = 1e-6
