"""Patches: how much of each pixel a mark covers, by its distance."""

from typing import Any

import numpy as np
import pytest

from carom.draw.paint.patches import (
    Extent,
    from_arc,
    from_circle,
    from_segment,
    line_patches,
    nearest_of,
    patches,
    polygon_patches,
    polyline_patches,
)

pygame = pytest.importorskip("pygame", reason='no pygame: pip install "carom[draw]"')


def test_distances_are_those_of_the_shapes() -> None:
    x, y = np.array([0.0, 5.0, 10.0]), np.array([3.0, 4.0, 0.0])
    assert from_segment((0.0, 0.0), (4.0, 0.0))(x, y) == pytest.approx([3.0, np.hypot(1.0, 4.0), 6.0])
    assert from_circle((0.0, 0.0), 2.0)(x, y) == pytest.approx([1.0, np.hypot(5.0, 4.0) - 2.0, 8.0])
    # Pixels have y down: a quarter from angle 0 to π/2 lies to the right and above, at smaller y.
    quarter = from_arc((0.0, 0.0), 2.0, 0.0, np.pi / 2)
    assert quarter(np.array([3.0, 0.0]), np.array([-4.0, 5.0])) == pytest.approx([3.0, np.hypot(2.0, 5.0)])


def test_patches_leave_out_what_is_empty() -> None:
    line = line_patches(from_segment((1, 1), (700, 700)), Extent(0, 0, 701, 701), 2.0, (0, 0, 0), (800, 800))
    assert 10 < len(line) < 40
    assert patches(from_circle((50, 50), 10), Extent(90, 90, 99, 99), (0, 0, 0), (800, 800)) == []
    assert polyline_patches([(-9, -9), (-5, -5)], 1.0, (0, 0, 0), (100, 100)) == []
    assert polyline_patches([(-60, 60), (10, 130)], 1.0, (0, 0, 0), (100, 100)) == []


def covered(found: list[Any], size: tuple[int, int]) -> np.ndarray:
    """How much of each pixel (x, y) of a picture some patches cover."""
    picture = np.zeros(size)
    for surface, x, y in found:
        width, height = surface.get_size()
        picture[x : x + width, y : y + height] += pygame.surfarray.array_alpha(surface) / 255.0
    return picture


@pytest.mark.parametrize("center", [(50.0, 40.0), (3.0, 95.0), (150.0, 64.0)])
def test_patches_cover_what_a_picture_shows_of_a_disc_seam_or_no_seam(center: tuple[float, float]) -> None:
    size, radius = (160, 100), 30.5
    extent = Extent.of([center], radius + 1.0)
    found = covered(patches(from_circle(center, radius), extent, (0, 0, 0), size), size)
    x, y = np.meshgrid(np.arange(size[0]) + 0.5, np.arange(size[1]) + 0.5, indexing="ij")
    expected = np.clip(radius + 0.5 - np.hypot(x - center[0], y - center[1]), 0.0, 1.0)
    assert np.abs(found - expected).max() < 0.01


@pytest.mark.parametrize("width", [0.4, 1.0, 6.0])
def test_a_line_covers_its_width_and_a_thin_one_is_faint(width: float) -> None:
    start, end, size = (20.3, 30.7), (120.1, 80.2), (160, 100)
    extent = Extent.of([start, end], width + 1.0)
    found = covered(line_patches(from_segment(start, end), extent, width, (0, 0, 0), size), size)
    length = float(np.hypot(end[0] - start[0], end[1] - start[1]))
    assert found.sum() == pytest.approx(width * length, rel=0.06)
    assert found.max() == pytest.approx(min(1.0, width), abs=0.01)


def test_of_some_marks_the_nearest_counts() -> None:
    both = nearest_of([from_circle((0.0, 0.0), 1.0), from_segment((10.0, 0.0), (10.0, 5.0))])
    assert both(np.array([4.0, 8.0, 10.0]), np.array([0.0, 2.0, 9.0])) == pytest.approx([3.0, 2.0, 4.0])


def test_an_area_is_that_of_its_polygon() -> None:
    corners = [(20.0, 20.0), (100.0, 30.0), (60.0, 80.0)]
    found = covered(polygon_patches(corners, (0, 0, 0), (160, 100)), (160, 100))
    assert found.sum() == pytest.approx(0.5 * (80 * 60 - 40 * 10), rel=0.02)
    assert found[60, 45] == 1.0
    assert polygon_patches([(-9.0, 0.0), (-5.0, 0.0), (-7.0, 9.0)], (0, 0, 0), (160, 100)) == []
