"""Strategies of hypothesis that the tests share: numbers, figures with a ball near them, and rigid motions.

A figure is a kind's name and its plain numbers, as `tests.naive` takes them: `("point", (x, y))`, `("segment", (ax, ay,
bx, by))`, `("circle", (cx, cy, radius))`, `("disc", the same, solid)`, `("arc", (cx, cy, radius, start, end))`.
"""

from math import cos, pi, sin

from hypothesis import strategies as st

Figure = tuple[str, tuple[float, ...]]
Ball = tuple[float, float, float]
Motion = tuple[float, float, float]


def numbers(low: float, high: float) -> st.SearchStrategy[float]:
    """Finite numbers, with a taste for round ones, where figures coincide and align."""
    return st.one_of(
        st.floats(low, high, allow_nan=False, allow_subnormal=False),
        st.integers(int(low) + (low > int(low)), int(high)).map(float) if high >= 1 else st.just(high),
    )


seeds = st.integers(0, 2**32 - 1)
coordinates = numbers(-100.0, 100.0)
radii = numbers(0.001, 50.0)
masses = numbers(0.001, 1000.0)
speeds = numbers(-100.0, 100.0)
elasticities = st.one_of(st.floats(0.0, 1.5), st.sampled_from((0.0, 1.0)))
angles = st.one_of(
    st.floats(0.0, 2.0 * pi, exclude_max=True, allow_subnormal=False), st.sampled_from((0.0, pi / 2, pi, 1.5 * pi))
)
fractions = st.floats(0.0, 1.0)
points = st.tuples(coordinates, coordinates)
vectors = st.tuples(speeds, speeds)
unit_vectors = angles.map(lambda angle: (cos(angle), sin(angle)))
motions = st.tuples(angles, coordinates, coordinates)

#: Magnitudes far from 1, whose squares are still doubles.
extremes = st.one_of(
    st.sampled_from((0.0, -0.0, 1.0, -1.0, 1e-150, -1e-150, 1e150, -1e150, 1e-8, 1e8)),
    st.builds(
        lambda sign, digits, power: sign * digits * 10.0**power,
        st.sampled_from((-1.0, 1.0)),
        st.floats(1.0, 9.9),
        st.integers(-149, 149),
    ),
)
positive_extremes = extremes.map(abs).filter(lambda number: number > 0.0)


@st.composite
def segments(draw: st.DrawFn) -> tuple[float, float, float, float]:
    """The ends of a segment, at least a thousandth apart."""
    x, y = draw(points)
    angle, length = draw(angles), draw(numbers(0.001, 100.0))
    return x, y, x + length * cos(angle), y + length * sin(angle)


@st.composite
def arcs(draw: st.DrawFn) -> tuple[float, float, float, float, float]:
    """Centre, radius, and two angles at least a thousandth of a radian apart, either way round."""
    x, y = draw(points)
    start = draw(angles)
    end = draw(angles.filter(lambda angle: 1e-3 < abs(angle - start) < 2.0 * pi - 1e-3))
    return x, y, draw(radii), start, end


circles = st.tuples(coordinates, coordinates, radii)
balls = st.tuples(coordinates, coordinates, radii)
figures: st.SearchStrategy[Figure] = st.one_of(
    st.tuples(st.just("point"), points),
    st.tuples(st.just("segment"), segments()),
    st.tuples(st.just("circle"), circles),
    st.tuples(st.just("disc"), circles),
    st.tuples(st.just("arc"), arcs()),
)


@st.composite
def meetings(draw: st.DrawFn) -> tuple[Figure, Ball]:
    """A figure and a ball near it, which overlaps it more often than not."""
    figure = draw(figures)
    x, y = draw(places_on(figure))
    radius = draw(radii)
    angle, distance = draw(angles), radius * draw(st.floats(0.0, 1.3))
    return figure, (x + distance * cos(angle), y + distance * sin(angle), radius)


@st.composite
def places_on(draw: st.DrawFn, figure: Figure) -> tuple[float, float]:
    """A place on a figure, to rounding."""
    kind, given = figure
    part = draw(fractions)
    if kind == "point":
        x, y = given
        return x, y
    if kind == "segment":
        ax, ay, bx, by = given
        return ax + part * (bx - ax), ay + part * (by - ay)
    start, turn = (given[3], (given[4] - given[3]) % (2.0 * pi)) if kind == "arc" else (0.0, 2.0 * pi)
    angle = start + part * turn
    reach = given[2] * draw(fractions) if kind == "disc" else given[2]
    return given[0] + reach * cos(angle), given[1] + reach * sin(angle)
