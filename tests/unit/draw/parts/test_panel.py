"""The panel: its height is where its last line stands, and long words fit."""

from carom.draw.paint.svg import SvgPainter
from carom.draw.parts.frame import PANEL_WIDTH, Frame
from carom.draw.parts.panel import CAPTION, NAME, Panel, broken, room, shortened
from carom.shapes.aabb import Aabb


def test_the_last_line_stands_at_the_panel_s_height() -> None:
    panel = Panel("name", "caption " * 20, (("time", "1 s"),), (("wall", 4), ("post", 2)), (), ("note",))
    frame = Frame.around(Aabb(0.0, 0.0, 1.0, 1.0), panel.height)
    places: list[float] = []

    class Painter(SvgPainter):
        """Notes where words stand."""

        def text(self, position: tuple[float, float], *_: object) -> None:
            places.append(frame.pixel(*position)[1])

    panel.draw_still(Painter(frame), frame, 7.0)
    assert round(max(places) - 7.0, 9) == round(panel.height, 9)


def test_a_long_name_ends_in_an_ellipsis_and_a_short_one_stays() -> None:
    assert shortened("pinball", NAME) == "pinball"
    short = shortened("a" * 100, NAME)
    assert len(short) == room(NAME)
    assert short.endswith("…")


def test_a_caption_is_broken_into_lines_that_fit() -> None:
    lines = broken("one two three " * 10, CAPTION)
    assert len(lines) > 1
    assert max(map(len, lines)) * CAPTION.size * 0.5 <= PANEL_WIDTH
