"""The layout of a picture: what it shows is on the stage, whatever size is asked for, and the panel where it fits."""

import pytest

from carom.draw.parts.frame import FULL_WIDTH, Frame
from carom.shapes.aabb import Aabb

BOXES = {
    "wide": Aabb(-4.0, 0.0, 4.0, 2.0),
    "tall": Aabb(0.0, 0.0, 1.0, 3.0),
    "flat": Aabb(0.0, 5.0, 10.0, 5.0),
    "nearly flat": Aabb(0.0, 5.0, 10.0, 5.0 + 1e-9),
    "upright": Aabb(2.0, 0.0, 2.0, 1e6),
    "a point": Aabb(1.0, 1.0, 1.0, 1.0),
}


@pytest.mark.parametrize("box", BOXES.values(), ids=list(BOXES))
@pytest.mark.parametrize("size", [None, 64, 500, 1184, 3000, (64, 64), (320, 200), (900, 640), (3840, 2160), (64, 900)])
def test_the_box_is_on_the_stage_and_the_stage_in_the_picture(box: Aabb, size: object) -> None:
    frame = Frame.fit(box, 300.0, size)
    for x, y in ((box.left, box.bottom), (box.right, box.top)):
        assert frame.shows(x, y)
        pixel_x, pixel_y = frame.pixel(x, y)
        assert 0.0 < pixel_x < frame.width
        assert 0.0 < pixel_y < frame.height
        assert frame.world(pixel_x, pixel_y) == pytest.approx((x, y), abs=1e-14 * (1.0 + box.top))
    assert frame.scale > 0.0


@pytest.mark.parametrize("size", [(64, 64), (901, 641), (1920, 1080), (1080, 1920)])
def test_a_size_of_two_sides_is_met(size: tuple[int, int]) -> None:
    assert Frame.fit(BOXES["wide"], 300.0, size).pixels == size


@pytest.mark.parametrize("side", [64, 300, 800, 1200, 4000])
def test_a_size_of_one_side_is_the_longer_one(side: int) -> None:
    for box in (BOXES["wide"], BOXES["tall"]):
        assert max(Frame.fit(box, 300.0, side).pixels) == side


def test_no_size_is_the_one_that_suits() -> None:
    assert Frame.fit(BOXES["wide"], 300.0, None) == Frame.around(BOXES["wide"], 300.0)


def test_there_is_a_panel_where_it_fits() -> None:
    assert Frame.fit(BOXES["wide"], 300.0, (900, 640)).panel
    assert not Frame.fit(BOXES["wide"], 300.0, (900, 300)).panel
    assert not Frame.fit(BOXES["wide"], 300.0, (500, 640)).panel
    assert not Frame.fit(BOXES["wide"], 300.0, 500).panel
    panel = Frame.fit(BOXES["tall"], 300.0, (900, 640))
    assert panel.panel_left + 224.0 <= panel.width - 19.0


def test_words_grow_with_large_pictures_and_never_shrink_much() -> None:
    assert Frame.fit(BOXES["wide"], 300.0, (int(2 * FULL_WIDTH), 1440)).zoom == pytest.approx(2.0, rel=0.01)
    assert Frame.fit(BOXES["wide"], 300.0, (640, 480)).zoom == 1.0
    assert Frame.fit(BOXES["wide"], 300.0, 1100).zoom < 1.0
    assert Frame.fit(BOXES["wide"], 300.0, 700).zoom == 1.0
