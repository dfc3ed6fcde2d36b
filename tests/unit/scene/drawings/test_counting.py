"""How much a drawing has is counted in its text, each limit told before anything is followed."""

from io import StringIO
from itertools import count, takewhile
from types import SimpleNamespace
from typing import Any

import ezdxf
import pytest

import carom
from carom.scene.descriptors import WorldDescriptor
from carom.scene.drawings import counting, svg
from carom.scene.drawings.bodies import Drawing
from carom.scene.drawings.counting import check_text, curves_in, own_of
from carom.scene.drawings.limits import LONGEST_NUMBER, MOST_CURVES, MOST_ELEMENTS
from carom.scene.drawings.tree import Element
from carom.scene.faults import Faults
from tests.clock import soon


@pytest.mark.parametrize(
    ("data", "count"),
    [
        ("M0 0L1 1H2V3Z", 0),
        ("M0 0C1 2 3 4 5 6c1 2 3 4 5 6s1 2 3 4q1 2 3 4t1 2a1 1 0 0 1 3 4", 6),
        ("M0 0c" + "1 2 3 4 5 6 " * 50, 50),
        ("M0 0t" + "1 2 " * 500 + "L" + "1 2 " * 500, 500),
        ("M0 0a" + "1 1 0 0 1 3 4 " * 20 + "z", 20),
    ],
)
def test_curves_are_counted_where_one_letter_stands_for_many_too(data: str, count: int) -> None:
    assert curves_in(data) == count


@pytest.mark.parametrize(
    ("tag", "attributes", "amount"),
    [
        ("g", {}, (0, 0)),
        ("path", {"d": "M0 0C1 2 3 4 5 6"}, (8, 1)),
        ("polyline", {"points": "1,2 3,4"}, (3, 0)),
        ("ellipse", {"rx": "3", "ry": "4"}, (0, 1)),
        ("ellipse", {"rx": "3", "ry": "3"}, (0, 0)),
        ("ellipse", {"rx": "3"}, (0, 0)),
        ("rect", {"rx": "3", "ry": "4"}, (0, 4)),
        ("rect", {"rx": "3"}, (0, 0)),
    ],
)
def test_an_element_has_outlines_and_curves_of_its_own(
    tag: str, attributes: dict[str, str], amount: tuple[int, int]
) -> None:
    assert own_of(Element(tag, attributes, 1)) == amount


@pytest.mark.parametrize(
    ("inside", "said"),
    [
        (
            f"<g>{'<g/>' * 4}</g><use href='#a'/><use href='#a'/><g id='a'/>",
            '<g id="a"> (line 1): draws more than 10',
        ),
        (
            "<g><polyline points='1 2 3'/></g><polygon id='p' points='1 2 3 4 5 6 7'/>",
            '<polygon id="p"> (line 1): the out',
        ),
        ("<path d='M0 0t1 2t1 2t1 2'/><path id='p' d='t1 2'/>", '<path id="p"> (line 1): a drawing may have at most 3'),
    ],
)
def test_where_a_limit_is_passed_is_told_and_one_less_is_let_through(
    monkeypatch: pytest.MonkeyPatch, inside: str, said: str
) -> None:
    text = f"<svg xmlns='http://www.w3.org/2000/svg'>{inside}</svg>".encode()
    for module in (svg, counting):
        monkeypatch.setattr(module, "MOST_ELEMENTS", 10)
        monkeypatch.setattr(module, "MOST_MARKS", 20 if "path" in inside else 7)
        monkeypatch.setattr(module, "MOST_CURVES", 3)
    with pytest.raises(carom.SceneError) as caught:
        svg.SvgReader(text, Drawing(Faults(WorldDescriptor)))
    assert str(caught.value).startswith(said)
    for module in (svg, counting):
        for name in ("MOST_ELEMENTS", "MOST_MARKS", "MOST_CURVES"):
            monkeypatch.setattr(module, name, getattr(module, name) + 1)
    svg.SvgReader(text, Drawing(Faults(WorldDescriptor)))


def test_no_number_has_thousands_of_digits() -> None:
    with pytest.raises(carom.SceneError, match="numbers with more than 1000 digits"):
        own_of(Element("path", {"d": f"M{'1' * 5 * LONGEST_NUMBER} 0"}, 1))


# -- DXF ---------------------------------------------------------------------------------------------------------------


def text_of(draw: Any) -> str:
    """The text of a DXF drawing."""
    document = ezdxf.new("R2010")
    draw(document)
    stream = StringIO()
    document.write(stream)
    return stream.getvalue()


def refusal(text: str) -> str:
    """What is said of a text that is refused at once."""
    with soon(), pytest.raises(carom.SceneError) as caught:
        check_text(text)
    return str(caught.value)


def splines(document: Any) -> None:
    """Some curves: eight of a spline, and ellipses."""
    space = document.modelspace()
    space.add_open_spline([(k, k % 3) for k in range(11)], degree=3)
    space.add_ellipse((0, 0), (2, 0), 0.5)
    block = document.blocks.new("Some")
    for _ in range(5):
        block.add_ellipse((0, 0), (2, 0), 0.5)
    array = space.add_blockref("sOME", (0, 0))
    array.dxf.column_count, array.dxf.row_count = 3, 4


@pytest.mark.parametrize(
    ("degree", "weights", "clamped", "each"),
    [(3, None, True, 1), (5, None, True, 12), (3, [1.0, 2.0] * 15, True, 12), (3, None, False, 12)],
)
def test_what_is_slow_to_follow_counts_more(
    degree: int, weights: list[float] | None, clamped: bool, each: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    def draw(document: Any) -> None:
        spline = document.modelspace().add_open_spline([(k, k % 3) for k in range(30)], degree=degree)
        if weights:
            spline.weights = weights
        if not clamped:
            spline.knots = [float(k) for k in range(31 + degree)]

    text = text_of(draw)
    # One less than its knots that differ, of which so many as its degree may be beyond either end.
    most = each * ((30 - degree if clamped else 30 + degree) - 2 * degree)
    monkeypatch.setattr(counting, "MOST_CURVES", most)
    check_text(text)
    monkeypatch.setattr(counting, "MOST_CURVES", most - 1)
    assert refusal(text) == f"a drawing may have at most {most - 1} curves"


def test_what_blocks_hold_is_counted_each_time_it_is_drawn(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(counting, "QUICK", 0)
    text = text_of(splines)
    check_text(text)
    # The spline has knots 0 to 8 apart, of which six may be beyond its ends; and 1 + 5 * 12 ellipses.
    monkeypatch.setattr(counting, "MOST_CURVES", 62)
    assert refusal(text) == "a drawing may have at most 62 curves"
    monkeypatch.setattr(counting, "MOST_CURVES", 63)
    check_text(text)
    # Three in model space, and 5 * 12 of the block.
    monkeypatch.setattr(counting, "MOST_ELEMENTS", 63)
    check_text(entities_of(text))
    monkeypatch.setattr(counting, "MOST_ELEMENTS", 62)
    assert refusal(entities_of(text)).endswith("those of blocks counted each time")


def entities_of(text: str) -> str:
    """The sections of a text that have what is drawn."""
    parts = text.split("0\nSECTION\n")[1:]
    return "".join("0\nSECTION\n" + part for part in parts if part.split("\n")[1] in {"BLOCKS", "ENTITIES"})


LINE = "0\nLINE\n8\n0\n10\n1\n20\n2\n11\n3\n21\n4\n"


@pytest.mark.slow
@pytest.mark.parametrize(
    ("blocks", "entities", "said"),
    [
        ("", LINE * (MOST_ELEMENTS + 1), "at most 150000 entities"),
        ("0\nBLOCK\n2\nA\n" + LINE * 60_000 + "0\nENDBLK\n", "0\nINSERT\n2\nA\n" * 3, "counted each time"),
        ("", "0\nELLIPSE\n40\n0.5\n" * (MOST_CURVES + 1), "at most 125000 curves"),
        (
            "",
            LINE * (counting.QUICK + 1) + "0\nSPLINE\n71\n3\n" + "".join(f"40\n{k}\n" for k in range(130_000)),
            "curves",
        ),
    ],
)
def test_texts_that_are_just_too_large_are_refused_soon(blocks: str, entities: str, said: str) -> None:
    text = f"0\nSECTION\n2\nBLOCKS\n{blocks}0\nENDSEC\n0\nSECTION\n2\nENTITIES\n{entities}0\nENDSEC\n0\nEOF\n"
    assert said in refusal(text)


def test_blocks_in_themselves_and_chains_of_them_end(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(counting, "QUICK", 0)
    chain = "".join(f"0\nBLOCK\n2\nB{k}\n0\nINSERT\n2\nB{k + 1}\n0\nENDBLK\n" for k in range(5000))
    own = "0\nBLOCK\n2\nA\n0\nINSERT\n2\nA\n0\nENDBLK\n"
    entities = "0\nINSERT\n2\nB0\n0\nINSERT\n2\nA\n"
    check_text(f"0\nSECTION\n2\nBLOCKS\n{chain}{own}0\nENDSEC\n0\nSECTION\n2\nENTITIES\n{entities}0\nENDSEC\n")


def test_the_structures_of_a_dxf_are_counted_no_farther_than_to_the_first_that_is_too_many(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    line, drawn = counting._STRUCTURE.search("  0\nLINE\n"), count()
    endless = SimpleNamespace(finditer=lambda _text: (line for _ in takewhile(lambda k: k < 1000, drawn)))
    monkeypatch.setattr(counting, "_STRUCTURE", endless)
    monkeypatch.setattr(counting, "MOST_ELEMENTS", 10)
    with pytest.raises(carom.SceneError, match="at most 10 entities"):
        check_text("")
    assert next(drawn) == 21
