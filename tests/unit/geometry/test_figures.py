"""An arc as seen from its centre is the arc, put where its centre is the origin."""

from math import cos, sin

import pytest
from hypothesis import given

from carom.geometry.figures import ArcGeometry, CentredArc, centred_arc
from tests.strategies import angles, points, radii


@given(points, radii, angles, angles, radii)
def test_the_centre_of_a_centred_arc_is_the_origin(
    center: tuple[float, float], radius: float, start: float, end: float, slop: float
) -> None:
    x, y = center
    a, b = [(radius * cos(angle), radius * sin(angle)) for angle in (start, end)]
    seen = centred_arc(ArcGeometry(x, y, radius, x + a[0], y + a[1], x + b[0], y + b[1]), slop)
    assert seen == pytest.approx(CentredArc(radius, *a, *b, slop), rel=1e-12, abs=1e-13)
