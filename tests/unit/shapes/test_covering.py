"""Which places lie on shapes, among many of both: what testing each place against each shape says."""

from math import inf
from random import Random

import numpy as np
import pytest

from carom import Arc, Circle, Point, Segment, Shape
from carom.constants import COVER_TESTS
from carom.shapes.covering import Tolerances, covered_places

Place = tuple[float, float]


def some_shapes(random: Random, count: int) -> list[Shape]:
    """Shapes of all kinds."""

    def place() -> Place:
        return random.uniform(-9, 9), random.uniform(-9, 9)

    made: list[Shape] = []
    for _ in range(count // 4):
        start = random.uniform(0, 6)
        made += [Point(place()), Segment(place(), place()), Circle(place(), random.uniform(0.1, 3))]
        made += [Arc(place(), random.uniform(0.1, 3), start, start + random.uniform(0.1, 5))]
    made[2] = Circle(place(), 1.0, solid=True)
    return made


@pytest.mark.slow
@pytest.mark.parametrize(("seed", "count"), [(1, 12), (2, 12), (3, 264)])
def test_a_place_is_covered_by_what_is_near_moves_alike_and_does_not_end_there(seed: int, count: int) -> None:
    random = Random(seed)
    shapes = some_shapes(random, count)
    places = [
        (random.uniform(-9, 9), random.uniform(-9, 9)) if random.random() < 0.5 else shape.closest_point((9, 9))
        for shape in random.choices(shapes, k=count)
    ]
    near, rounding = np.array([random.choice((0.0, 0.3)) for _ in shapes]), np.full(count, 1e-9)
    motions = np.array([random.randrange(2) for _ in shapes])
    owners = np.array([random.randrange(count) for _ in places])
    ending = np.array([[random.randrange(count), -1] for _ in shapes])
    numbers = np.arange(count)
    close = Tolerances(np.full(count, 0.2), np.full(count, 1e-9))
    rows = np.array([shape._row for shape in shapes])
    x, y = np.array(places).T
    sizes = np.array([getattr(shape, "length", 1.0) for shape in shapes])
    found = covered_places(rows, sizes, Tolerances(near, rounding), motions, ending, x, y, close, owners, numbers)
    expected = []
    for k, place in enumerate(places):
        gaps = [
            (0.0 if isinstance(shape, Circle) and shape.solid and shape.contains(place) else shape.distance(place))
            - (min(near[j], 0.2) + 1e-9)
            if motions[j] == motions[owners[k]] and k not in ending[j]
            else inf
            for j, shape in enumerate(shapes)
        ]
        assert min(gaps) == inf or abs(min(gaps)) > 1e-12
        expected.append(min(gaps) <= 0.0)
    assert found.tolist() == expected
    # Enough that they are halved, with each kind apart.
    assert count * (count // 4) > COVER_TESTS or count < 100
    assert 0 < sum(expected) < count
