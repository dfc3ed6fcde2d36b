"""Charts with powers of ten along both axes."""

import re
from xml.etree import ElementTree

import pytest

from benchmarks import __main__ as program
from benchmarks import scaling
from benchmarks.chart import BOTTOM, LEFT, RIGHT, TOP, Chart, Curve
from benchmarks.common import Figure
from carom.draw.paint.painter import Style


def test_a_curve_goes_through_its_places() -> None:
    chart = Chart("title", "along", "what", across=(0, 2), up=(0, 4, 1))
    svg = chart.draw([Curve("steady", Style("ball-1"), [(1.0, 1.0), (10.0, 100.0), (100.0, 10_000.0)])])
    ElementTree.fromstring(svg)
    curves = svg[svg.index('"curves"') :]
    numbers = [float(number) for number in re.findall(r"-?\d+\.?\d*", re.search(r'(?:points|d)="([^"]+)"', curves)[1])]  # type: ignore[index]
    places = list(zip(numbers[::2], numbers[1::2], strict=True))
    assert [x for x, _ in places] == pytest.approx([LEFT, 0.5 * (LEFT + RIGHT), RIGHT], abs=0.01)
    first, middle, last = (y for _, y in places)
    assert (first - middle, middle - last) == pytest.approx((0.5 * (TOP - BOTTOM),) * 2, abs=0.02)
    for told in ("steady", "along", "what", "10,000"):
        assert told in svg


def test_what_balls_cost_is_drawn_for_every_engine_that_was_measured() -> None:
    figures = [
        Figure(f"{10**power:,} balls" if power else "1 ball", name, 100.0, "ns a ball")
        for name in ("carom", "bare loop, C")
        for power in range(7)
    ]
    svg = scaling.chart(figures)
    assert "bare loop, C" in svg
    assert "pymunk" not in svg
    assert "1,000,000" in svg


def test_a_chart_of_what_is_not_measured_is_refused(capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit):
        program.main(["--only", "gas", "--chart", "costs.svg"])
    assert "--chart draws what --only scaling measures" in capsys.readouterr().err
