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

#: Width of the broad phase's cells in diameters of the balls in them. 1 is the least that finds every pair, and the
#: thousandth above it covers the rounding of coordinates up to 1e12 radii from the origin; more means
#: fewer cells and more tests in each. Changes the speed and the order of pairs alone.
CELL_SIDE = 1.001

#: Cells; a ball farther than this from the grid's corner is put into the last cell. Far beyond any grid, and small
#: enough that numbers of cells never overflow.
CELL_CLAMP = 1073741824.0

#: The finest level of the hierarchical grid: cells 2^-24 as wide as the largest ball's. Smaller balls share that level.
FINEST_LEVEL = 24

#: Members of a quadtree's leaf above which it is split, while there are levels left. Changes the speed alone.
LEAF_MEMBERS = 4

#: Cells per shape, and cells at most, of the grid that finds the shapes near a ball: more cells, shorter lists and more
#: memory (32 bytes a cell). Changes the speed alone.
INDEX_CELLS_PER_SHAPE = 64
INDEX_CELLS_MOST = 65536

#: Factor by which a shape is found from farther away than needed, so that rounding never hides it.
INDEX_MARGIN = 1.000001

#: Relative, two units in the last place of 1: directions closer than this (in radians) to a sector's ray, and points
#: closer than this (times their coordinates) to a circle, are on it. The doubles next to π and its halves are 2e-16
#: off, so a smaller one puts (-1, 0) outside of an arc from 0 to pi.
ROUNDING = 4.5e-16

#: A sum of squares within these has no term that was lost to underflow, and none that overflowed; outside, vectors are
#: scaled before they are squared.
LEAST_SQUARE = 1e-280
GREATEST_SQUARE = 1e300

#: 2^27 + 1: times it, a double splits into two halves of 26 bits, whose products are exact.
SPLITTER = 134217729.0

#: Multiple of their points' distance; lines that meet no nearer than this are parallel, for their crossing overflows.
FARTHEST_CROSSING = 1e300

#: Cells at most per ball in the grid that finds pairs of balls (4 bytes each). Fewer, and cells share their numbers
#: earlier, which costs tests. Changes the speed and the order of pairs alone.
GRID_CELLS_PER_BALL = 4.0

#: Relative: a root counts as found when a step towards it is shorter than this. A few units in the last place of 1;
#: smaller, and the search goes round in rounding.
ROOT_TOLERANCE = 1e-15

#: Steps towards a root at most. Halving alone takes 53 from any enclosure to its last digit; Newton's method about 5.
ROOT_STEPS = 100

#: Relative to a ball's velocity: a slower approach is the rounding of its direction (a response leaves up to 5e-16), so
#: a ball that touches and approaches slower slides. Smaller, and a ball that slides meets the same surface for ever.
APPROACH_ROUNDING = 1e-15
APPROACH_ROUNDING_SQUARED = APPROACH_ROUNDING * APPROACH_ROUNDING

#: Relative to the squared length of a ball's path from its centre to a shape: what passes by so clearly is left out
#: before its times are computed. Far above the rounding of that estimate (1e-15), so that no touch is lost by it.
GRAZING = 1e-12
