"""A slow twin of the discrete world: one substep at a time, every ball with every shape and ball, by angles and sines.

It is written from the rules alone, shares no code with carom, and holds its own state: places and velocities, poses,
who passes what, who is inside which sensor, who sleeps. Beyond it are coinciding centres, and moving shapes that wake.
"""

from dataclasses import dataclass, field, replace
from itertools import pairwise
from math import atan2, cos, hypot, pi, sin, sqrt

Vector = tuple[float, float]
Meeting = tuple[Vector, Vector, float]

ORDER = ("point", "segment", "gate", "circle", "arc")
END_DEPTH = 0.25
PRESS_DEPTH = 0.25
SIDE_ROOM = 0.5
CROWD_WAY = 0.25
LEAST_SHARE = 0.125
SAMPLES = 400
SEAM_REACH = 1e-3
CLOSE = 1e-9
ROUNDING = 1e-13  # a slower approach is what is left of one that a response has ended


def plus(a: Vector, b: Vector, share: float = 1.0) -> Vector:
    """The vector a + share·b."""
    return a[0] + share * b[0], a[1] + share * b[1]


def minus(a: Vector, b: Vector) -> Vector:
    """The vector a - b."""
    return a[0] - b[0], a[1] - b[1]


def dot(a: Vector, b: Vector) -> float:
    """a·b."""
    return a[0] * b[0] + a[1] * b[1]


def scaled(a: Vector, share: float) -> Vector:
    """The vector share·a."""
    return share * a[0], share * a[1]


def turned(a: Vector, angle: float) -> Vector:
    """A vector turned counterclockwise."""
    return a[0] * cos(angle) - a[1] * sin(angle), a[0] * sin(angle) + a[1] * cos(angle)


@dataclass
class TwinBall:
    """A ball."""

    place: Vector
    radius: float
    velocity: Vector = (0.0, 0.0)
    mass: float = 1.0
    elasticity: float = 1.0
    sensor: bool = False
    layer: int = 1
    collides_with: int = 2**32 - 1
    still: float = 0.0
    asleep: bool = False


@dataclass
class TwinShape:
    """A shape as it was given, and how far it has turned and travelled since."""

    kind: str
    places: tuple[Vector, ...] = ()  # a point's own, a segment's ends, a centre
    radius: float = 0.0
    angles: Vector = (0.0, 0.0)
    direction: Vector = (0.0, 0.0)
    solid: bool = False
    elasticity: float = 1.0
    kick: float = 0.0
    sensor: bool = False
    layer: int = 1
    collides_with: int = 2**32 - 1
    kinematic: bool = False
    pivot: Vector = (0.0, 0.0)
    angular_velocity: float = 0.0
    turn_limits: Vector | None = None
    velocity: Vector = (0.0, 0.0)
    turn: float = 0.0
    way: Vector = (0.0, 0.0)
    spin: float = 0.0
    before: tuple[float, Vector] = (0.0, (0.0, 0.0))

    def advance(self, h: float) -> None:
        """Move for a substep."""
        self.before = self.turn, self.way
        low, high = self.turn_limits or (-1e300, 1e300)
        stopped = (self.turn >= high and self.angular_velocity > 0) or (self.turn <= low and self.angular_velocity < 0)
        self.spin = 0.0 if stopped else self.angular_velocity
        self.turn = min(max(self.turn + self.spin * h, low), high)
        if self.turn in (low, high):
            self.angular_velocity = 0.0
        self.way = plus(self.way, self.velocity, h)

    def out(self, place: Vector) -> Vector:
        """Where a place of the shape as given lies now."""
        return plus(plus(self.pivot, turned(minus(place, self.pivot), self.turn)), self.way)

    def home(self, place: Vector, turn: float, way: Vector) -> Vector:
        """Where a place in the plane lies on the shape as given, when that has turned and travelled so far."""
        return plus(self.pivot, turned(minus(minus(place, way), self.pivot), -turn))

    def surface_velocity(self, place: Vector) -> Vector:
        """How fast the shape's matter at a place moves."""
        x, y = minus(place, plus(self.pivot, self.way))
        return plus(self.velocity, (-self.spin * y, self.spin * x))

    # On the shape as given: the ball is brought home, and what is found is carried out again.

    def in_reach(self, c: Vector) -> bool:
        """Whether a centre is in the slab of a segment or in the sector of an arc; True for other shapes."""
        if self.kind in ("segment", "gate"):
            a, b = self.places
            along = dot(minus(c, a), minus(b, a))
            return 0.0 <= along <= dot(minus(b, a), minus(b, a))
        if self.kind != "arc":
            return True
        start, end = self.angles
        x, y = minus(c, self.places[0])
        return (atan2(y, x) - start) % (2 * pi) <= (end - start) % (2 * pi)

    def side(self, c: Vector) -> tuple[float, Vector, Vector]:
        """The signed distance of a centre from the line or circle, the direction in which it grows, the closest point.

        For a segment, the direction is that of the normal to the left of the way from its first end to its second.
        """
        if self.kind in ("segment", "gate"):
            a, b = self.places
            tx, ty = minus(b, a)[0] / hypot(*minus(b, a)), minus(b, a)[1] / hypot(*minus(b, a))
            normal = -ty, tx
            distance = dot(minus(c, a), normal)
            return distance, normal, plus(c, normal, -distance)
        q = self.places[0]
        away = hypot(*minus(c, q))
        out = minus(c, q)[0] / away, minus(c, q)[1] / away
        return away - self.radius, out, plus(q, out, self.radius)

    def overlap(self, ball: TwinBall, slack: float = 0.0) -> Meeting | None:
        """Point, normal and setback of a ball that overlaps the shape, or misses it by less than a slack."""
        c = self.home(ball.place, self.turn, self.way)
        if not self.in_reach(c):
            return None
        distance, normal, q = self.side(c)
        if not self.solid:
            normal = normal if distance > 0 else (-normal[0], -normal[1])
            distance = abs(distance)
        if distance >= ball.radius + slack:
            return None
        return self.out(q), turned(normal, self.turn), ball.radius - distance

    def is_open(self, c: Vector) -> bool:
        """Whether a centre, as seen from a gate as given, is on the side from which it lets balls by."""
        distance, normal, _ = self.side(c)
        return distance * dot(normal, self.direction) <= 0.0

    def moves(self) -> bool:
        """Whether it moves in this substep."""
        return self.kinematic and (self.spin != 0.0 or self.velocity != (0.0, 0.0))

    def barrier(self, c: Vector, way: Vector, room: float) -> str:
        """What a centre pushed from `c` by `way` comes to: "across" the shape's side, too "near" to it, or ""."""
        home = self.home(c, self.turn, self.way)
        if self.kind == "point" or (self.kind == "gate" and self.is_open(home)):
            return ""
        way = turned(way, -self.turn)
        sides = []
        for k in range(SAMPLES + 1):
            place = plus(home, way, k / SAMPLES)
            sides.append((self.in_reach(place), self.side(place)[0]))
        if self.solid and sides[0][1] < 0.0:
            return ""
        for (within, before), (within_too, after) in pairwise(sides):
            if (within or within_too) and (before > 0.0) != (after > 0.0):
                return "across"
        depths = [room - (side if self.solid else abs(side)) if within else 0.0 for within, side in sides]
        return "near" if depths[-1] > max(depths[0], 0.0) else ""

    def height_over(self, ball: TwinBall, place: Vector) -> float:
        """How far a place is from the line or circle, on the side of the ball."""
        ours = self.side(self.home(ball.place, self.turn, self.way))[0]
        theirs = self.side(self.home(place, self.turn, self.way))[0]
        return theirs if self.solid or ours > 0 else -theirs

    def touches(self, ball: TwinBall) -> bool:
        """Whether any place of the shape, its ends included, is inside the ball."""
        c = self.home(ball.place, self.turn, self.way)
        if self.in_reach(c):
            distance = self.side(c)[0]
            return (distance if self.solid else abs(distance)) < ball.radius
        ends = self.places
        if self.kind == "arc":
            ends = tuple(plus(self.places[0], (self.radius * cos(a), self.radius * sin(a))) for a in self.angles)
        return min(hypot(*minus(c, end)) for end in ends) < ball.radius

    def begins_to_be_passed(self, ball: TwinBall, first: bool, start: Vector, moved: Vector, setback: float) -> bool:
        """Whether a ball that overlaps it, and has moved from `start` to `moved`, passes it from now on."""
        home = self.home(ball.place, self.turn, self.way)
        if not first:
            return self.kind == "gate" and self.is_open(home)
        a, b = self.home(start, *self.before), self.home(moved, self.turn, self.way)
        if self.kind == "gate" and self.is_open(a):
            return True
        if self.kind not in ("segment", "gate", "arc") or self.in_reach(a) or not self.in_reach(b):
            return False
        low, high = 0.0, 1.0  # the last crossing of an edge, by halving
        for _ in range(60):
            middle = 0.5 * (low + high)
            low, high = (low, middle) if self.in_reach(plus(a, minus(b, a), middle)) else (middle, high)
        depths = [ball.radius - abs(self.side(place)[0]) for place in (a, plus(a, minus(b, a), high))]
        return min(*depths, setback) > END_DEPTH * ball.radius


@dataclass
class TwinWorld:
    """Settings, shapes and balls. `hits` has the impulse, shape and ball of each bounce; ENTER and EXIT by name."""

    balls: list[TwinBall]
    shapes: list[TwinShape]
    gravity: Vector = (0.0, 0.0)
    iterations: int = 6
    total: bool = False
    friction: float = 0.0
    sleep_speed: float = 0.0
    sleep_time: float = 0.5
    rest_speed: float | None = None
    max_speed: float | None = None
    passing: set[tuple[int, int]] = field(default_factory=set)
    inside: set[tuple[str, int, int]] = field(default_factory=set)
    hits: list[tuple[str, int, int, float]] = field(default_factory=list)
    found: bool = False
    doubtful: bool = False  # whether rounding may have decided something that shows
    faint: bool = False  # whether it may have decided that one more iteration follows
    touching: set[int] = field(default_factory=set)  # balls that overlapped a shape when they met the shapes last
    crowded: set[int] = field(default_factory=set)  # and that may be near the side of another
    met: list[Vector] = field(default_factory=list)  # where each ball was when it had met the shapes last
    stuck: bool = False  # whether a ball had no room, which one more iteration may change

    def substep(self, h: float) -> None:
        """One substep."""
        rest = 2 * hypot(*self.gravity) * h if self.rest_speed is None else self.rest_speed
        self.faint = self.stuck = False
        for shape in self.shapes:
            if shape.kinematic:
                shape.advance(h)
        starts = [ball.place for ball in self.balls]
        for ball in self.balls:
            if not ball.asleep:
                ball.place = plus(plus(ball.place, ball.velocity, h), self.gravity, h * h / 2)
                ball.velocity = plus(ball.velocity, self.gravity, h)
        moved = [ball.place for ball in self.balls]
        order = sorted(
            range(len(self.shapes)), key=lambda k: (self.shapes[k].kinematic, ORDER.index(self.shapes[k].kind), k)
        )
        for iteration in range(self.iterations):
            self.found = False
            self.touching, self.crowded = set(), set()
            for i, ball in enumerate(self.balls):
                if not ball.asleep:
                    for k in order:
                        self.meet_shape(i, k, iteration, starts[i], moved[i], rest)
            self.met = [ball.place for ball in self.balls]
            for i, j in self.pairs():
                self.meet_pair(i, j, rest)
            if not self.found:
                break
        else:  # what stands still has the last word, the static shapes at the end
            last = sorted(order, key=lambda k: not self.shapes[k].kinematic)
            for i, ball in enumerate(self.balls):
                for k in last:
                    if not ball.asleep and not self.shapes[k].moves():
                        self.meet_shape(i, k, self.iterations, starts[i], moved[i], rest)
        self.doubtful |= self.faint and self.stuck
        self.finish(h)

    def room(self, i: int, k: int | None, way: Vector) -> str:
        """What a push of a ball by a shape, or by a ball, comes to, on account of the other shapes."""
        ball, found = self.balls[i], ""
        for other, shape in enumerate(self.shapes):
            if other != k and self.holds_back(i, other, k is not None and not self.shapes[k].moves()):
                barrier = shape.barrier(ball.place, way, SIDE_ROOM * ball.radius)
                if barrier == "across":
                    return barrier
                found = found or barrier
        return found

    def holds_back(self, i: int, k: int, by_rest: bool) -> bool:
        """Whether a shape is in the way of a ball that is pushed; what moves is not, for what stands still."""
        ball, shape = self.balls[i], self.shapes[k]
        if shape.sensor or ball.sensor or (i, k) in self.passing or not may_meet(ball, shape):
            return False
        return not (by_rest and shape.moves())

    def pressed(self, i: int, k: int, way: Vector, normal: Vector) -> float:
        """How deep a push by shape `k` presses a ball onto a shape at rest that opposes it."""
        ball = self.balls[i]
        there = replace(ball, place=plus(ball.place, way))
        deepest = 0.0
        for other, shape in enumerate(self.shapes):
            contact = shape.overlap(there) if other != k and self.holds_back(i, other, True) else None
            if contact is None or dot(contact[1], normal) >= -0.5:
                continue
            if shape.kind != "gate" or not shape.is_open(shape.home(there.place, shape.turn, shape.way)):
                deepest = max(deepest, contact[2])
        return deepest

    def share_of_push(self, i: int, k: int, normal: Vector, setback: float, iteration: int) -> tuple[float, bool]:
        """By how much of the setback a shape moves a ball, and whether it moves and presses it onto one at rest."""
        moves, share = self.shapes[k].moves(), 1.0
        ball = self.balls[i]
        while self.room(i, k, scaled(normal, share * setback)) == "near" and not moves and share > LEAST_SHARE:
            share /= 2
        if self.room(i, k, scaled(normal, share * setback)):
            return 0.0, False
        depth = self.pressed(i, k, scaled(normal, setback), normal)
        if iteration + 1 == self.iterations and depth > PRESS_DEPTH * ball.radius:
            return 0.0, False
        return share, moves and depth > 0.0 and (iteration >= 2 or iteration + 1 == self.iterations)

    def meet_shape(self, i: int, k: int, iteration: int, start: Vector, moved: Vector, rest: float) -> None:
        """A ball and a shape."""
        ball, shape = self.balls[i], self.shapes[k]
        contact = shape.overlap(ball, CLOSE)
        if contact is None or not may_meet(ball, shape):
            return
        point, normal, setback = contact
        surface = shape.surface_velocity(point) if shape.kinematic else (0.0, 0.0)
        w = minus(ball.velocity, surface)
        s = dot(w, normal)
        pulled = dot(self.gravity, normal) > 0.0
        self.doubtful |= (
            -CLOSE < s < -ROUNDING
            or (abs(s) < CLOSE and pulled)
            or (setback < CLOSE and (s < -CLOSE or shape.kind == "gate"))
        )
        self.faint |= abs(setback) < CLOSE
        if setback <= 0:
            return
        if shape.sensor or ball.sensor:
            self.enter("shape", i, k)
            return
        if (i, k) in self.passing:
            return
        if shape.begins_to_be_passed(ball, iteration == 0, start, moved, setback):
            self.passing.add((i, k))
            return
        if shape.kind == "point" and self.yields(i, k, iteration == 0, start, moved):
            return
        share, pressed = self.share_of_push(i, k, normal, setback, iteration)
        self.stuck |= share < 1.0
        if share == 0.0 and shape.moves():
            self.passing.add((i, k))
            return
        self.found = True
        setback *= share
        if i in self.touching or share < 1.0 or setback > CROWD_WAY * ball.radius:
            self.crowded.add(i)
        self.touching.add(i)
        ball.place = plus(ball.place, normal, setback)
        if s < -ROUNDING:
            squared = s * s + 2 * dot(self.gravity, normal) * setback
            approach = sqrt(max(squared, 0.0))
            e = ball.elasticity * shape.elasticity
            sliding = plus(w, normal, -s)
            if pressed or (e < 1 and shape.kick == 0 and approach < rest):
                ball.velocity = plus(surface, sliding)
            else:
                self.doubtful |= abs(squared) < 1e-2 * s * s
                if self.total:
                    sliding = sliding[0] * e, sliding[1] * e
                ball.velocity = plus(plus(surface, sliding), normal, e * approach + shape.kick)
                self.hits.append(("bounce", i, k, ball.mass * (e * approach + shape.kick - s)))
        self.slow(ball)

    def yields(self, i: int, k: int, first: bool, start: Vector, moved: Vector) -> bool:
        """Whether a ball that overlaps a point is beside a wall that it meets, and the point on or behind that."""
        ball, point = self.balls[i], self.shapes[k]
        place = point.out(point.places[0])
        answer = False
        for j, wall in enumerate(self.shapes):
            contact = None if wall.kind == "point" or wall.sensor else wall.overlap(ball, CLOSE)
            if contact is None or not may_meet(ball, wall) or (i, j) in self.passing:
                continue
            over = wall.height_over(ball, place) - SEAM_REACH * ball.radius
            if wall.begins_to_be_passed(ball, first, start, moved, contact[2]) or over > CLOSE:
                continue
            self.doubtful |= contact[2] < CLOSE or over > -CLOSE
            answer = True
        return answer

    def pairs(self) -> list[tuple[int, int]]:
        """The pairs of balls whose boxes overlap now, before any of them is responded to."""
        found = []
        for i, a in enumerate(self.balls):
            for j in range(i + 1, len(self.balls)):
                x, y = minus(self.balls[j].place, a.place)
                if max(abs(x), abs(y)) <= a.radius + self.balls[j].radius:
                    found.append((i, j))
        return found

    def meet_pair(self, i: int, j: int, rest: float) -> None:
        """Two balls."""
        a, b = self.balls[i], self.balls[j]
        gap = minus(b.place, a.place)
        distance = hypot(*gap)
        if distance >= a.radius + b.radius + CLOSE or not may_meet(a, b) or (a.asleep and b.asleep):
            return
        closing = dot(minus(b.velocity, a.velocity), gap) / distance < -CLOSE
        self.doubtful |= distance > a.radius + b.radius - CLOSE and closing
        self.faint |= abs(distance - a.radius - b.radius) < CLOSE
        if distance >= a.radius + b.radius:
            return
        if a.sensor or b.sensor:
            self.enter("ball", j, i)
            return
        self.found = True
        normal = gap[0] / distance, gap[1] / distance
        setback, total = a.radius + b.radius - distance, a.mass + b.mass
        ways = {i: scaled(normal, -setback * b.mass / total), j: scaled(normal, setback * a.mass / total)}
        free = not any(self.is_crowded(k, way) for k, way in ways.items())
        for k, way in ways.items():
            if free or not self.room(k, None, way):
                self.balls[k].place = plus(self.balls[k].place, way)
        u1, u2 = dot(a.velocity, normal), dot(b.velocity, normal)
        if u1 - u2 > ROUNDING:
            e = a.elasticity * b.elasticity
            resting = e < 1 and u1 - u2 < rest
            e = 0.0 if resting else e
            common = (a.mass * u1 + b.mass * u2) / total
            after1, after2 = common - e * (u1 - common), common - e * (u2 - common)
            a.velocity = plus(a.velocity, normal, after1 - u1)
            b.velocity = plus(b.velocity, normal, after2 - u2)
            if not resting:
                self.hits.append(("ball", j, i, b.mass * (after2 - u2)))
                for ball in (a, b):
                    ball.still = 0.0 if ball.asleep else ball.still
        for ball in (a, b):
            ball.asleep = False
            self.slow(ball)

    def is_crowded(self, i: int, way: Vector) -> bool:
        """Whether a ball that is pushed may come to a shape's side: several shapes pushed it, or balls did so far."""
        near = CROWD_WAY if i in self.touching else 1 - SIDE_ROOM
        far = hypot(*minus(plus(self.balls[i].place, way), self.met[i])) > near * self.balls[i].radius
        return far or i in self.crowded

    def slow(self, ball: TwinBall) -> None:
        """Keep to `max_speed`."""
        speed = hypot(*ball.velocity)
        if self.max_speed is not None and speed > self.max_speed:
            ball.velocity = ball.velocity[0] * self.max_speed / speed, ball.velocity[1] * self.max_speed / speed

    def enter(self, what: str, i: int, k: int) -> None:
        """A ball and a sensor."""
        if (what, i, k) not in self.inside:
            self.inside.add((what, i, k))
            self.hits.append(("enter " + what, i, k, 0.0))

    def finish(self, h: float) -> None:
        """What ends a substep."""
        self.passing = {(i, k) for i, k in self.passing if self.shapes[k].touches(self.balls[i])}
        for what, i, k in sorted(self.inside):
            ball = self.balls[i]
            if what == "shape":
                lasts = self.shapes[k].overlap(ball) is not None
            else:
                other = self.balls[k]
                lasts = hypot(*minus(ball.place, other.place)) < ball.radius + other.radius
            if not lasts:
                self.inside.remove((what, i, k))
                self.hits.append(("exit " + what, i, k, 0.0))
        for ball in self.balls:
            if ball.asleep:
                continue
            speed = hypot(*ball.velocity)
            kept = max(1 - self.friction * h / speed, 0.0) if speed > 0 else 0.0
            ball.velocity = ball.velocity[0] * kept, ball.velocity[1] * kept
            ball.still = ball.still + h if speed * kept < self.sleep_speed else 0.0
            if self.sleep_speed > 0 and speed * kept < self.sleep_speed and ball.still >= self.sleep_time:
                ball.asleep, ball.velocity = True, (0.0, 0.0)


def may_meet(a: TwinBall | TwinShape, b: TwinBall | TwinShape) -> bool:
    """Whether the masks allow it."""
    return bool(a.layer & b.collides_with) and bool(b.layer & a.collides_with)
