"""What a painter is: every one of them takes the same calls, and styles are plain values."""

import inspect

import pytest

from carom import draw
from carom.draw.page.painter import PagePainter
from carom.draw.paint.painter import Lettering, Lines, Painter, Style
from carom.draw.paint.raster import RasterPainter
from carom.draw.paint.svg import SvgPainter

CALLS = sorted(name for base in (Lines, Painter) for name in vars(base) if not name.startswith("_"))


@pytest.mark.parametrize("kind", [PagePainter, RasterPainter, SvgPainter])
@pytest.mark.parametrize("call", CALLS)
def test_a_painter_takes_the_calls_of_all_painters(kind: type, call: str) -> None:
    wanted, given = inspect.signature(getattr(Painter, call)), inspect.signature(getattr(kind, call))
    assert list(given.parameters) == list(wanted.parameters)
    assert {name: str(one.annotation) for name, one in given.parameters.items()} == {
        name: str(one.annotation) for name, one in wanted.parameters.items()
    }


def test_styles_are_values_that_say_what_is_drawn() -> None:
    assert Style("wall", width=2.0) == Style(stroke="wall", width=2.0) != Style("wall")
    assert len({Style("wall"), Style("wall"), Style(fill="wall")}) == 2
    assert (Style().stroke, Style().fill, Lettering().anchor) == (None, None, "start")
    with pytest.raises(AttributeError):
        Style("wall").width = 3.0  # type: ignore[misc]
    with pytest.raises(TypeError, match="strok is no argument"):
        draw.Style(strok="wall")  # type: ignore[call-arg]
