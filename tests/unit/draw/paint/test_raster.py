"""Pixels: marks where they belong, covered as far as they are covered, at any zoom; letters; PNG files."""

import numpy as np
import pytest

import carom
from carom import draw
from carom.draw.paint.painter import sides
from carom.draw.parts.frame import Frame
from carom.draw.theme import LIGHT
from carom.shapes.aabb import Aabb

pygame = pytest.importorskip("pygame", reason='no pygame: pip install "carom[draw]"')
FRAME = Frame(200.0, 100.0, Aabb(0.0, 0.0, 20.0, 10.0), 10.0, 0.0, 0.0)
BLACK = draw.Style(fill="text")


def painter(zoom: float = 1.0, *, quick: bool = False) -> draw.RasterPainter:
    """A painter of 200 by 100 pixels, ten to a unit, all white."""
    frame = Frame(FRAME.width, FRAME.height, FRAME.stage, FRAME.scale, 0.0, 0.0, zoom=zoom)
    made = draw.RasterPainter(frame, draw.ThemeName.PRINT, quick=quick)
    made.surface.fill((255, 255, 255))
    return made


def cover(made: draw.RasterPainter) -> np.ndarray:
    """How dark each pixel is, (x, y), from 0 to 1."""
    return 1.0 - pygame.surfarray.array3d(made.surface)[:, :, 0] / 255.0


def test_a_segment_covers_its_length_times_its_width_and_its_round_ends() -> None:
    for width in (0.5, 1.0, 3.0):
        made = painter()
        made.segment((2.0, 2.0), (14.0, 7.0), draw.Style("text", width=width))
        area = 130.0 * width + (0.25 * np.pi * width * width if width >= 1.0 else 0.0)
        assert cover(made).sum() == pytest.approx(area, rel=0.03)


def test_a_disc_covers_its_area_wherever_it_is() -> None:
    for x in (5.0, 5.013, 5.05, 5.08):
        made = painter()
        made.circle((x, 5.0), 1.5, BLACK)
        assert cover(made).sum() == pytest.approx(np.pi * 225.0, rel=0.01)
        where = np.nonzero(cover(made) > 0.5)
        assert where[0].mean() == pytest.approx(10.0 * x - 0.5, abs=0.3)


def test_large_and_small_circles_are_drawn_alike() -> None:
    small, large = painter(), painter()
    style = draw.Style("text", fill="muted", width=2.0, fill_opacity=0.5)
    small.circle((10.0, 5.0), 4.7, style)
    large.circle((10.0, 5.0), 4.9, style)
    area = np.pi * (49.0**2 - 47.0**2) * 0.5 * (1.0 - 0x3D / 255.0) + 2.0 * np.pi * 2.0 * 2.0
    assert cover(large).sum() - cover(small).sum() == pytest.approx(area, rel=0.1)


def test_an_arc_is_drawn_on_its_own_side_alone() -> None:
    made = painter()
    made.arc((10.0, 5.0), 4.0, 0.0, np.pi / 2, draw.Style("text", width=2.0))
    dark = cover(made)
    assert dark.sum() == pytest.approx(2.0 * 40.0 * np.pi / 2, rel=0.05)
    assert dark[:99, :].sum() < 2.0
    assert dark[:, 52:].sum() < 1.0


def test_dashes_leave_gaps() -> None:
    dashed = draw.Style("text", width=2.0, dash=(5.0, 5.0))
    for call, plain in (("segment", 120.0), ("arc", 40.0 * np.pi), ("circle", 80.0 * np.pi), ("large", 96.0 * np.pi)):
        made = painter()
        if call == "segment":
            made.segment((2.0, 5.0), (14.0, 5.0), dashed)
        elif call == "arc":
            made.arc((10.0, 5.0), 4.0, 0.5, 0.5 + np.pi, dashed)
        else:
            made.circle((10.0, 5.0), 4.0 if call == "circle" else 4.8, dashed)
        assert 0.5 * 2.0 * plain < cover(made).sum() < 0.8 * 2.0 * plain


def test_a_line_through_points_has_one_darkness_where_its_parts_meet() -> None:
    made = painter()
    points = np.array([(2.0, 2.0), (8.0, 2.0), (8.0, 8.0), (14.0, 8.0)])
    made.polyline(points, draw.Style("text", width=2.0, opacity=0.5))
    assert cover(made).max() <= 0.51
    assert cover(made).sum() == pytest.approx(0.5 * 2.0 * 180.0, rel=0.03)
    assert cover(made)[79, 79] == pytest.approx(0.5, abs=0.02)


def test_parts_of_a_translucent_line_meet_without_a_bead() -> None:
    made = painter()
    style = draw.Style("text", width=3.0, opacity=0.5)
    made.polyline(np.array([(2.0, 5.0), (8.0, 5.0)]), style)
    made.polyline(np.array([(8.0, 5.0), (14.0, 5.0)]), style)
    assert cover(made).max() <= 0.51


def blurred(dark: np.ndarray) -> np.ndarray:
    """The means of blocks of 4 by 4 pixels."""
    return dark.reshape(50, 4, 25, 4).mean(axis=(1, 3))


def test_a_quick_line_is_where_the_fine_one_is() -> None:
    quick, fine = painter(quick=True), painter()
    points = np.array([(2.0, 2.0), (8.0, 7.0), (14.0, 3.0)])
    for made in (quick, fine):
        made.polyline(points, draw.Style("text", width=2.0, opacity=0.8))
        made.segment((15.0, 1.0), (18.0, 9.0), draw.Style("text", width=1.0))
        made.segment((1.0, 9.0), (12.0, 9.0), draw.Style("text", width=2.0, dash=(8.0, 4.0)))
        made.polyline(np.array([(1.0, 6.0), (3.0, 8.0), (1.0, 8.0)]), BLACK)
    assert cover(quick).sum() == pytest.approx(cover(fine).sum(), rel=0.25)
    assert np.abs(blurred(cover(quick)) - blurred(cover(fine))).max() < 0.3


@pytest.mark.parametrize("radius", [0.3, 0.57, 4.0])
def test_a_quick_arc_is_round_however_small(radius: float) -> None:
    made = painter(quick=True)
    made.arc((10.0, 5.0), radius, 0.3, 0.3 + np.pi, draw.Style("text", width=1.0))
    across, down = np.nonzero(cover(made) > 0.3)
    off = np.hypot(across + 0.5 - 100.0, down + 0.5 - 50.0) - 10.0 * radius
    assert np.abs(off).max() < 1.6, "its corners are no farther off the arc than a smooth line is wide"


@pytest.mark.parametrize("dash", [(), (3.0, 3.0)])
@pytest.mark.parametrize("zoom", [1.0, 2.0])
def test_the_sides_of_a_box_are_four_segments_quick_or_fine(dash: tuple[float, ...], zoom: float) -> None:
    style = draw.Style("text", width=1.0, dash=dash, opacity=0.6)
    for low, high in (((2.0, 1.5), (5.0, 4.0)), ((7.03, 2.27), (9.02, 8.26)), ((10.0, 1.0), (19.9, 9.0))):
        fine, segments, quick = painter(zoom), painter(zoom), painter(zoom, quick=True)
        for made in (fine, quick, quick):
            made.box(low, high, style)
        for start, end in sides(low, high):
            segments.segment(start, end, style)
        assert np.array_equal(cover(fine), cover(segments))
        # What is quick stands on whole pixels, and is opaque in the colour that it has on the stage.
        (left, bottom), (right, top) = (np.array(corner) * 10.0 * zoom for corner in (low, high))
        xs, ys = np.nonzero(cover(quick) > 0.05)
        assert (xs.min(), xs.max()) == pytest.approx((left, right), abs=zoom)
        assert (ys.min(), ys.max()) == pytest.approx((100.0 * zoom - top, 100.0 * zoom - bottom), abs=zoom)
        assert cover(quick)[xs.min() + 4 : xs.max() - 3, ys.min() + 4 : ys.max() - 3].max() == 0.0
        # pygame's smooth lines, which large boxes are made of, are wider by up to half a pixel.
        assert cover(quick).sum() == pytest.approx(cover(fine).sum(), rel=0.3)


def test_areas_are_filled_boxes_to_the_pixel() -> None:
    made = painter()
    made.polyline(np.array([(2.0, 2.0), (4.0, 2.0), (4.0, 5.0), (2.0, 5.0)]), BLACK)
    assert cover(made).sum() == 20.0 * 30.0
    veiled = painter()
    veiled.polyline(np.array([(2, 2), (4, 2), (4, 5), (2, 5.0)]), draw.Style(fill="text", fill_opacity=0.5))
    assert cover(veiled).sum() == pytest.approx(300.0, rel=0.01)
    triangle = painter()
    for _ in range(2):
        triangle.surface.fill((255, 255, 255))
        triangle.polyline(np.array([(2.0, 2.0), (8.0, 2.0), (2.0, 8.0)]), draw.Style("text", fill="text", width=0.1))
    assert cover(triangle).sum() == pytest.approx(1800.0, rel=0.03)


def test_marks_off_the_picture_are_no_marks() -> None:
    made = painter()
    style = draw.Style("text", fill="text", width=2.0)
    made.segment((50.0, 50.0), (60.0, 50.0), style)
    made.circle((50.0, 50.0), 1.0, style)
    made.circle((90.0, 50.0), 30.0, style)
    made.arc((50.0, 50.0), 1.0, 0.0, 1.0, style)
    made.polyline(np.array([(50.0, 50.0), (60.0, 50.0), (60.0, 61.0)]), style)
    made.segment((3.0, 3.0), (4.0, 4.0), draw.Style())
    made.circle((3.0, 3.0), 1.0, draw.Style())
    made.circle((9.0, 5.0), 4.9, draw.Style())
    assert cover(made).sum() == 0.0


def test_a_point_is_drawn_for_a_line_without_length() -> None:
    made = painter()
    made.segment((3.0, 3.0), (3.0, 3.0), draw.Style("text", width=4.0, dash=(2.0, 2.0)))
    assert cover(made).sum() == pytest.approx(np.pi * 4.0, rel=0.1)


def test_zoom_makes_everything_larger() -> None:
    def marks(made: draw.RasterPainter) -> float:
        made.segment((2.0, 5.0), (18.0, 5.0), draw.Style("text", width=2.0))
        made.circle((10.0, 2.0), 0.8, BLACK)
        made.text((2.0, 8.0), "words", draw.Lettering(size=20.0))
        return float(cover(made).sum())

    assert marks(painter(2.0)) == pytest.approx(4.0 * marks(painter()), rel=0.08)
    assert painter(2.0).surface.get_size() == (400, 200)


def test_words_stand_where_they_are_anchored() -> None:
    middles = {}
    for anchor in ("start", "middle", "end"):
        made = painter()
        made.text((10.0, 5.0), "words", draw.Lettering(anchor=anchor))
        columns, lines = np.nonzero(cover(made) > 0.2)
        middles[anchor] = columns.mean()
        assert lines.max() <= 50
        assert lines.min() >= 36
    assert middles["start"] > 110 > middles["middle"] + 5
    assert middles["middle"] == pytest.approx(100, abs=3)
    assert middles["end"] < 90


def test_letters_stand_as_far_apart_as_in_large_pictures() -> None:
    def width(zoom: float) -> float:
        made = painter(zoom)
        made.text((1.0, 5.0), "illegibility", draw.Lettering())
        return float(np.ptp(np.nonzero(cover(made) > 0.1)[0]) / zoom)

    assert width(1.0) == pytest.approx(width(4.0), abs=1.5)


@pytest.mark.parametrize("words", ["", "a\0b", "\ud800", "line\nbreak", "ünïcödé ∂ 漢"])
def test_any_words_can_be_written(words: str) -> None:
    painter().text((1.0, 1.0), words, draw.Lettering())


def test_what_is_kept_does_not_grow_without_end(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("carom.draw.paint.raster.MOST_KEPT", 5)
    made = painter()
    for number in range(40):
        made.circle((5.0, 5.0), 0.1 + 0.02 * number, BLACK)
    assert len(made._kept) <= 5


def test_a_png_is_the_picture() -> None:
    picture = draw.picture_of(carom.scenes.toy().build(), "Toy", size=(400, 300))
    data = draw.png(picture)
    assert data.startswith(b"\x89PNG\r\n\x1a\n")
    assert int.from_bytes(data[16:20], "big"), int.from_bytes(data[20:24], "big") == (400, 300)
    assert data == draw.png(picture)
    made = draw.RasterPainter(picture.frame, draw.ThemeName.AUTO)
    picture.draw(made)
    assert len(made.rgb()) == 3 * 400 * 300
    assert made.rgb()[:3] == bytes.fromhex(LIGHT.inks["paper"][1:])
