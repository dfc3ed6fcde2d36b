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

#: Fraction of a ball's radius by which slabs and sectors reach past their ends in a world, so that rounding leaves no
#: gap at an exact joint. Far above rounding (1e-16), far below anything that is seen.
END_SLOP = 1e-9

#: Fraction of a ball's radius: a point that stands out of a wall by less is on it, and a ball beside the wall meets the
#: wall instead (discrete). If the wall leaves the ball on the point it meets it after all, so nothing is lost but
#: time. Smaller, and guard points of ends that were rounded apart turn balls at seams; larger, and posts are missed.
SEAM_REACH = 1e-3

#: Share of a length, default of `guard_points`: ends nearer than this part of the shorter shape are one place, whatever
#: the unit. Well above what a few steps of arithmetic leave (1e-15), well below any gap that is meant.
GUARD_TOLERANCE = 1e-9

#: Share of a coordinate, default of `guard_points`: ends are one place, and tangents opposite, within this too, for the
#: rounding of coordinates moves ends and so turns the shapes between them. Some twenty units in the last place: what a
#: sine, a turn and a shift leave. Smaller, and far from the origin joints fall apart; larger, and detail is lost there.
GUARD_ROUNDING = 4e-15

#: Radians, default of `guard_points`: two ends whose outward tangents are opposite within this continue each other and
#: need no point. Between their slabs there is then a wedge of this angle, as wide as this share of a radius where a
#: ball touches, and a ball that falls into it would go through: so this must not exceed twice `END_SLOP`, by which
#: slabs reach past their ends. A larger one has nothing to give: a point at a joint that is bent by more is met in
#: the wedge alone, where it turns a ball by no more than the bend does.
GUARD_ANGLE_TOLERANCE = 1e-9

#: The longest leg of a biarc's control polygon is the chord over this. Smaller, and the joint is lost in rounding where
#: both ends lead away from each other.
BIARC_LEAST_DIVISOR = 1e-3

#: Share of an outline's size: a curve that turns about within this radius has a cusp there, a corner
#: that needs a point. Smaller, and the arc round the tip is lost in the rounding of coordinates.
TIP_RADIUS = 1e-12

#: The least tolerance that a curve may be followed within: at it some 3000 arcs are enough for a curve that bends
#: evenly. Smaller, and the rounding of coordinates (1e-16) and of arcs' ends (1e-16 of the radius) shows.
LEAST_TOLERANCE = 1e-11

#: The largest radius of an arc that follows a curve; one that would be larger becomes a straight piece between two arcs
#: of a tenth of it. The ends of an arc are off by the rounding of its radius, and a ball whose radius is 1e-5 of the
#: outline's size or more must not take that for a step (`END_DEPTH_CONTINUOUS`).
LARGEST_RADIUS = 1e5

#: Radians: an arc that turns by less is a segment. Two of them make a joint no more bent than `GUARD_ANGLE_TOLERANCE`.
STRAIGHT_TURN = 5e-10

#: Tests of places against shapes that are made at once, and shapes that all places of a box are tested against before
#: they are divided, when guard points are looked for. Change the speed alone.
COVER_TESTS = 16384
COVER_SAMPLE = 8

#: Relative to a shape's size: ends, middle, box and tangent of a shape in a snapshot agree with the rest of it within
#: this. Sines of another machine differ by 1e-16; nothing that is drawn or met depends on less.
SNAPSHOT_TOLERANCE = 1e-9

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

#: Members of a quadtree's four quarters, in members of the node, above which it is not split after all. Four quarters
#: of half the members each take as many tests of pairs as the node, so more than 2 copies of balls cost time as well as
#: memory; a list of shapes still gets shorter up to 4. Changes the speed alone.
TREE_COPIES_OF_BALLS = 2
TREE_COPIES_OF_SHAPES = 3

#: Cells per shape, in the discrete mode and for flights, and cells at most, of the grid that finds the shapes near a
#: ball: more cells, shorter lists and more memory (48 bytes a cell). Changes the speed, and how many tests are counted.
INDEX_CELLS_PER_SHAPE = 64
FLIGHT_CELLS_PER_SHAPE = 16
INDEX_CELLS_MOST = 65536

#: Balls up to this many look at the box of each of `FEW_SHAPES` kinematic shapes in discrete mode, near which they are.
#: Changes the speed alone, and the number of box tests.
FEW_BALLS = 64

#: Balls up to this many, or as many as shapes that only turn, are asked if near before these are put in place.
FEW_TO_ASK = 8

#: Balls up to this many are moved, and meet shapes, one after the other. Of more, those that may meet a shape are
#: listed first, and all are put into the cells of a grid meanwhile. Changes the speed and the order of pairs alone.
FEW_TO_SORT = 8

#: Times that a ball which shapes push out of its cell goes on with those near its new place, in one iteration; then the
#: next iteration does. Fewer, and broad phases may differ in which shape pushes first; more, and hits need more room.
NEW_CELLS = 4

#: Parts of a cell of the grid of shapes along each axis, a bit each for whether a shape is in reach. Speed alone.
CELL_PARTS = 7

#: Static shapes up to this many are asked for a rectangle free of all of them. Changes the speed alone.
FEW_FIXED = 64

#: Parts by which a shape is in reach of more of them than it need be, far above the rounding of places in a cell.
PART_MARGIN = 0.001

#: Factor by which a shape is found from farther away than needed, so that rounding never hides it.
INDEX_MARGIN = 1.000001

#: Relative, two units in the last place of 1: directions closer than this (in radians) to a sector's ray, and points
#: closer than this (times their coordinates) to a circle, are on it. The doubles next to π and its halves are 2e-16
#: off, so a smaller one puts (-1, 0) outside of an arc from 0 to pi.
ROUNDING = 4.5e-16

#: Within these a sum of squares has lost no term to underflow or overflow; outside, vectors are scaled before.
LEAST_SQUARE = 1e-280
GREATEST_SQUARE = 1e300

#: 2^27 + 1: times it, a double splits into two halves of 26 bits, whose products are exact.
SPLITTER = 134217729.0

#: Times their distance: lines that meet no nearer are parallel. A shape that comes no farther is where numbers reach.
FARTHEST_CROSSING = 1e300

#: Cells at most per ball in the grid that finds pairs of balls (4 bytes each). Fewer, and cells share their numbers
#: earlier, which costs tests. Changes the speed and the order of pairs alone.
GRID_CELLS_PER_BALL = 4.0

#: The same of a grid that is laid ahead, around where balls come to in a substep: enough for a gas that fills a fifth
#: of its box. Changes the speed and the order of pairs alone.
GRID_CELLS_AHEAD = 5.0

#: Relative: a root counts as found when a step towards it is shorter than this. A few units in the last place of 1;
#: smaller, and the search goes round in rounding.
ROOT_TOLERANCE = 1e-15

#: Steps towards a root at most. Halving alone takes 53 from any enclosure to its last digit; Newton's method about 5.
ROOT_STEPS = 100

#: Relative to a ball's velocity: a slower approach is the rounding of its direction (a response leaves up to 5e-16), so
#: a ball that touches and approaches slower slides. Smaller, and a ball that slides meets the same surface for ever.
APPROACH_ROUNDING = 1e-15
APPROACH_ROUNDING_SQUARED = APPROACH_ROUNDING * APPROACH_ROUNDING

#: Relative to the squares of a ball's distance and way: a ball that keeps clear of a touch by more than this, as far as
#: one looks, is left out before its time is computed. Far above the rounding of a time (1e-15), so that no time depends
#: on how far one looks; larger, and more times are computed in vain.
GRAZING = 1e-12

#: Relative to the coordinates that a gap is reckoned from: one that is no wider is rounding, and left as it is. A few
#: units in the last place. Smaller, and centres are moved by what their places cannot tell, which adds up; larger, and
#: gaps stay that need not.
GAP_ROUNDING = 1e-15

#: Part of a ball's speed, and of its square: an impact that changes it by less has rounded it. A few last places.
KEPT_ROUNDING = 2e-15

#: Part of a ball's speed: if less is along the normal, its speed and its angular momentum say the same.
LEAST_STEEPNESS = 1e-4

#: Factor on a ball's reach, far above rounding: a ball that falls is out of it for good when farther off than this.
ESCAPE_MARGIN = 1.000001

#: Fraction of a ball's radius: how deep a ball may dip into a turning shape unseen, and get clear again by itself. What
#: dips deeper is always found; what is found is exact. A hundredth of END_DEPTH_CONTINUOUS, so that a dip is no
#: passing; smaller, and the search takes more steps, by its inverse root, past a shape that a ball slides along.
TURN_DEPTH = 1e-8

#: Steps of the search for a touch with a turning shape at most; one that needs more stops there, where the ball is
#: clear still, and may go on from there. About 10 are usual; a ball that slides along a flipper takes some hundreds.
TURN_STEPS = 4096

#: Times that a ball may touch the line or circle of a turning shape past its ends before the search stops likewise.
TURN_CROSSINGS = 16

#: Width of the cells for balls in flight, in diameters of the largest ball of the level: a little more than 2. More
#: means fewer cells to look into, and more balls in each.
BIN_SIDE = 2.002

#: Fraction of its cell's width that a ball may be outside of the cell under which it is filed; then it is filed anew.
#: More means fewer filings of balls that go to and fro over a border; the radius and this are half a width together at
#: most, so that balls which touch are in neighbouring cells.
BIN_MARGIN = 0.25

#: The radius of a level's largest ball and that margin, in widths of its cells.
BIN_REACH = 0.5

#: Balls up to this many are compared each with each in continuous mode, without cells. Changes the speed alone.
FEW_FLIGHTS = 6

#: Factor on the way of the balls in a span, far above its rounding (1e-15).
SWEEP_ROUNDING = 1.000001

#: Fraction of its radius that a ball which passes a shape, or is inside a sensor, travels before it looks whether it
#: still does. A way there and back again within it goes unseen; smaller costs events.
LOOK_TRAVEL = 0.25

#: Radians: a ball that slides along a bent or turning shape is put back onto it at least so often.
SLIDE_TURN = 0.1

#: Fraction of a ball's radius: the most that a lasting contact may have opened before it is given up.
LIFT = 1e-3

#: Fraction of its radius that a ball in flight is moved at most when it is parted from another; the rest follows when
#: they meet again. More, and a heap that is pressed together may throw balls far.
PUSH_MOST = 0.25

#: Cosine of the angle between the normals of two shapes: a ball that one of them holds is thrown off by the other, with
#: whatever speed, if the angle is smaller. At a larger one, contacts that end and begin in turn do so ever more slowly.
THROW_OFF = 0.5

#: Radians: a ball in lasting contact that approaches the next shape at less than this slope rolls onto it. Far above
#: the rounding of normals at a joint (1e-12), far below any edge that is meant.
JOINT_TURN = 1e-9

#: Fraction of a ball's radius: a ball with less room than this between a moving shape and one at rest is squeezed, and
#: the moving one goes over it. Smaller, and a ball gains more speed in the closing gap. And the cosine of the angle at
#: which a single one stops it: smaller, and balls that would glide off aside are gone over.
SQUEEZE_GAP = 0.05
SQUEEZE_FACING = 0.5

#: Fraction of a ball's radius: a ball that the last iteration still presses deeper than this onto a shape at rest is
#: squeezed. Smaller, and a flipper that drives a ball out of a narrow nook lets it through; larger, and balls that have
#: no room are pressed for longer.
PRESS_DEPTH = 0.25

#: Iterations of a substep after which a mover that presses a ball onto a shape at rest does not bounce it any more.
#: Fewer, and a shot out of a nook loses speed; more, and one that is squeezed gets faster than it is pushed.
PRESS_ITERATIONS = 2

#: Fraction of a ball's radius: a push takes a ball's centre no nearer than this to the side of a shape, so that a ball
#: which moves by less than half its radius a substep does not cross it next. Smaller, and such a ball may.
SIDE_ROOM = 0.5

#: Fraction of a ball's radius: what a shape and then other balls have pushed by no more than this each comes to no
#: other shape's side, so nobody looks. At most half of 1 - SIDE_ROOM.
CROWD_WAY = 0.25

#: Share of a setback: a push by a shape at rest that comes too near to another's side is halved down to this, and then
#: left to the next iteration.
LEAST_SHARE = 0.125

#: Factor on the way of a push, far above rounding (1e-16): what a longer one than the radius crosses may be out of the
#: index's sight.
PUSH_MARGIN = 1.000001

#: Fraction of a ball's radius: balls that overlap by less as a substep begins do so from rounding, and are left so.
SEPARATION_SLACK = 1e-9

#: Slices into which a flight's way is cut to find the shapes along it; a longer one is tested against all shapes.
FLIGHT_SLICES = 64

#: The same of a ball among many, which will rather meet another one before.
CROWD_SLICES = 8

#: Static shapes, and kinematic ones, up to this many are all tested against a ball's way in continuous mode, without an
#: index; kinematic ones in discrete mode by few balls.
FEW_SHAPES = 16

#: For how long the index of kinematic shapes that travel holds: the time in which they go so many of their own widths
#: and balls', on the whole. More, and it is made anew less often, and shapes are looked at from farther off.
REGION_WAY = 4.0

#: The index of static shapes may grow by one in so many of its members before it is made anew for want of room, and of
#: the kinematic shapes too before the index of these, which stands behind it, has to give way and is made anew.
INDEX_SLACK = 4

#: Box tests that take as long as filing a shape in cells: where regions would cost balls more of them, shapes that have
#: moved are filed anew in discrete mode. Changes the speed alone.
REGION_LOAD = 500.0
#: Substeps for which it holds at most in discrete mode, in each of which rounding takes a shape from its way. More, and
#: shapes are looked at from farther off, far from the origin.
REGION_SUBSTEPS = 1024

#: Times the mean width of the regions of all that moves, and widths of a cell: a shape whose region is wider is asked
#: everywhere.
REGION_WIDE = 8.0
REGION_CELLS = 24.0

#: Factor on a span's length within which a shape's stop counts as reached at its end. Above rounding (1e-16) by far;
#: a shape that travels too goes this much too far in that span.
STOP_MARGIN = 1.000000001

#: (√5 - 1)/2: its multiples, modulo 1, keep away from each other as evenly as those of any number.
GOLDEN_SECTION = 0.6180339887498949

#: Cells per item at most, and places in cells per item at most, of the grid that serves queries: more cells, shorter
#: lists, more memory (4 bytes a place) and more time to make the grid. Changes the speed alone.
SEARCH_CELLS_PER_ITEM = 4.0
SEARCH_MARKS_PER_ITEM = 64.0

#: Widths of a cell by which items and queries are taken to be larger than they are, so that rounding of a place in the
#: grid (1e-16 of the number of cells) never hides one from the other.
SEARCH_MARGIN = 1e-6

#: Queries of a world as it stands that are answered by testing every item, before a grid is made: making it takes about
#: as long as they do. Changes the speed alone.
SEARCH_SCANS = 32

#: Relative to a ray's length and its distance from a segment or arc: how far past their ends rays meet them, so that
#: none slips through a joint. Ten times the rounding of where a ray meets a line; far below anything that is seen.
RAY_SLOP = 1e-14

#: Relative to the speed of a shot: a ball that goes on slower stands still. Aimed full at another, it keeps what the
#: rounding of its line leaves it, some 1e-15 for every radius that it comes from afar.
STILL_SHARE = 1e-12

#: Seconds: the instant of what never was. Far before any world's beginning, and small enough to reckon with.
NEVER = -1e300

#: Part of the speed at which a ball meets what takes all of its approach and does not hold it: at this it leaves.
LEAST_PART = 1e-15

#: Part of a ball's speed: what it has off a shape that holds it is rounding below this.
LEAST_ROLL = 1e-12

#: Fraction of a ball's radius: where the rebound off what presses it on would be lower than this, the contact lasts; at
#: elasticities of 1 and more the second. Larger, and bounces that can be seen are cut off; smaller, and balls bounce
#: more often before they rest.
REBOUND = 1e-3
ELASTIC_REBOUND = 1e-9

#: Share of what pulls a ball: a pressure on what holds it that is less is rounding. Far above that (1e-16).
PRESS_ROUNDING = 1e-12

#: Fraction of a ball's radius by which a ball that slides along a bent or moving shape leaves it between two ticks at
#: most. Smaller costs ticks, by the cube root.
SLIDE_LIFT = 2.5e-4

#: Rounds in which the way that a ball has slid in a tick, and its speed, are bettered: each by two or three digits.
SLIDE_ROUNDS = 4

#: Fraction of a ball's radius: a flight between two impacts that is shorter cannot be told from none. After so many of
#: them, one after the other, the ball's impacts take all of the approach; at elasticities of 1 and more the second.
SHORT_FLIGHT = 1e-6
SHORT_ELASTIC_FLIGHT = 1e-12
SHORT_FLIGHTS = 8
SHORT_ELASTIC_FLIGHTS = 32

#: A ball that has had so many impacts one after the other, between which it went no more than SHORT_ELASTIC_FLIGHT,
#: lacks the room to go on; between shapes that move as one, between which it went no more than SHORT_FLIGHT.
MOST_AT_ONCE = 1000

#: Fraction of a ball's radius: what such a ball is nearer to, it touches; a bend that is larger by less, a ball fills.
SHORT_GAP = 1e-5

#: Fraction of a moving shape's reach from its pivot that a ball, as seen from it, goes in one slice of a search for
#: their touch, and the radians that the shape turns in one at most. Changes the last bits of impacts, and the speed.
MOVER_WAY = 0.25
MOVER_TURN = 0.5

#: Slices of such a search in one look.
MOVER_LOOKS = 16

#: Looks of a ball at a sensor, or at what it passes, before it looks for the rest of what comes next.
SENSOR_LOOKS = 16

#: Fraction of the speed that what pulls a ball changes in a tick of friction, where that does not act along its path.
FRICTION_TICK = 0.02

#: Sine of the angle below which a pull along a ball's path is taken to be along it. Far above rounding (1e-16).
FRICTION_TURN = 1e-12

#: Events of a step after which its kernel comes back for a moment, so that Ctrl-C is heard.
EVENTS_BETWEEN_PAUSES = 200_000

#: Steps of Newton's method that put a ball onto two shapes which hold it; from a thousandth of its radius off two or
#: three reach the last digit.
TOUCH_STEPS = 4

#: Rounds of `iterations` each in which balls that overlap because something was changed are parted at most, before
#: they fly. Fewer, and a crowd keeps overlaps; more, and one that has no room is pushed for longer.
PARTING_ROUNDS = 64

#: Sweeps to and fro over an island's contacts before each search along its loaded ones, steps of a search at most, and
#: rounds of both at most. Fewer, and more is left unsolved in large heaps under heavy balls; more, and two shapes that
#: close on a ball, where there is no solution, take longer.
SOLVER_SWEEPS = 2
SEARCH_STEPS = 256
SOLVER_ROUNDS = 24

#: Share of a solve's tolerance down to which a search goes on. Smaller takes up to twice the steps, larger more rounds.
SEARCH_SHARE = 0.6

#: Share of the worst approach of a contact without load down to which a search goes on: beyond, it solves what the next
#: sweep will change. At 0 and at 0.1 large heaps take up to twice the time, at 1 heavy balls are left unsolved.
SEARCH_PROPORTION = 0.01

#: Relative to the sum over single contacts: a search direction along which the energy bends by less moves nothing but
#: rounding. Smaller, and impulses run away along it; larger, and balls a million times heavier than others move on.
LEAST_CURVATURE = 1e-12

#: Relative to the velocity that a contact's impulse gives: breaches of contacts below this are rounding. Smaller, and
#: solves under a ball a million times heavier than others never end before their last round.
SOLVER_ROUNDING = 1e-15

#: Times in a solve of an island's accelerations that contacts which part, but would be brought back within the tick,
#: are stopped, and how many times the solve's tolerance they part faster. Fewer times or faster, and low hops go on.
HOP_ROUNDS = 2
HOP_SPEED = 4.0

#: Visits of a ball while an impact spreads through an island at most, and those of them in which contacts are elastic.
#: More than a ball of a long row of touching ones needs; fewer would end the impulse within it.
IMPACT_VISITS = 64
ELASTIC_VISITS = 32

#: Share of the speed below which a contact does not rebound: slower approaches do not spread. Smaller, and impacts
#: reach farther into heaps than can be seen.
IMPACT_SHARE = 5e-2

#: Relative to an island's fastest ball: approaches below this are rounding of its velocities, and do not spread.
SPEED_ROUNDING = 1e-14

#: Fraction of a ball's radius: how far other balls of its island move it in one solve of places at most. Larger, and it
#: may be pushed through what nobody has looked at; smaller, and deep overlaps take more ticks.
ISLAND_PUSH = 0.1

#: Passes over an island's contacts that part balls one by one at most, after so many rounds of a solve for all at once.
PLACE_PASSES = 8
PLACE_ROUNDS = 4

#: Fraction of a ball's radius: overlaps of an island that are left as they are. Above rounding of places by far.
PLACE_SLACK = 1e-9

#: The same of two balls: an overlap that nobody sees. Smaller, and ticks solve places that are right already; larger,
#: and balls of a heap sink into each other.
PAIR_SLACK = 3e-5

#: Fraction of a ball's radius: a gap up to this to a shape that pressed over the last tick is closed. Larger than what
#: a tick opens on a bent shape, small enough that nobody sees it.
SETTLE_GAP = 1e-4

#: The tick of an island: a share of the time in which its least ball would fall its radius, and the radians that a
#: contact's normal turns in it at most. Smaller costs solves; larger, and balls on bends leave them more.
ISLAND_TICK = 0.1
ISLAND_TURN = 0.1

#: Share of an island's tick: if less of it remains at an event, the next one begins.
LEAST_TICK = 1e-3

#: Relative to an island's fastest ball, where nothing presses it: contacts do not rebound more slowly.
STILL_SPEED = 1e-9

#: How closely an island is solved while it moves: its velocities down to a share of the speed below which contacts do
#: not rebound, its accelerations to one of what pulls it over a tick, so that contacts close by a few 1e-5 of a radius
#: in a tick, which later ones take back. The slower its balls are the closer, down to a share of their speed, and at
#: rest to the last of these. Smaller costs; larger, and what is all but at rest shakes.
SETTLED_SHARE = 1e-2
TICK_SHARE = 3e-3
MOTION_SHARE = 5e-3
REST_SHARE = 1e-7

#: Fraction of a ball's radius: a contact of an island that does not press and is opened farther ends. As much as a
#: rebound that is none may rise. Smaller, and contacts end and begin again; larger, and approaches that can be seen end
#: before the balls touch.
ISLAND_OPEN = 1e-3

#: Ticks, one after the other, in which an island hardly moves before it sleeps, and what hardly is: shares of the speed
#: below which contacts do not rebound, and of what pulls it.
QUIET_TICKS = 8
QUIET_SPEED = 0.05
QUIET_PULL = 0.02

#: Fraction of a ball's radius: a moving shape that is deeper in a ball which has no room goes over it.
SQUEEZE_DEEP = 0.5

#: Shares of the speed below which contacts of an island do not rebound: a ball that an event elsewhere pushes by more
#: within the tick is solved with it; and down to which accelerations are solved then. Smaller costs; larger, and the
#: balls around it do work.
JOLT_SHARE = 5e-2
JOLT_TOLERANCE = 2e-2

#: Balls that are solved with an event before it is asked whether the rest can wait: where those around them are pushed
#: still, their island is solved anew when that has changed a ball by the same speed, if no less of a tick than this
#: share has gone by then; else more are solved now, in each round a ring more than in the one before up to so many
#: balls. More balls cost, fewer near ones take more rounds; with a larger share jolts go through whole heaps.
JOLT_MOST = 8
JOLT_WAIT = 0.05
JOLT_NEAR = 128

#: Part of a ball's radius: a ball that was less far from a shape between two hits has not left it, and touches it once.
#: A hop that low is not seen.
LOWEST_HOP = 0.05

#: Part of an outline's length by which the ends of two of its shapes may miss each other.
JOINT_GAP = 1e-9
