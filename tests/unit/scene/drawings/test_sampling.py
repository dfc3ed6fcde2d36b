"""Some of a DXF stands for all of it where all would take long."""

from pathlib import Path

import pytest

import carom
from carom.scene.drawings import reading, sampling
from carom.scene.drawings.dxf import sample_of
from carom.scene.drawings.sampling import some_of

LINE = "0\nLINE\n8\n0\n62\n0\n10\n0\n20\n{0}\n11\n1000\n21\n{0}\n"
ELLIPSE = "0\nELLIPSE\n8\n0\n62\n0\n10\n{0}\n20\n{1}\n11\n90\n21\n0\n40\n0.3\n41\n0\n42\n6.283185307\n"


def dxf(entities: str, blocks: str = "") -> str:
    """The text of a DXF."""
    sections = (("BLOCKS", blocks), ("ENTITIES", entities), ("OBJECTS", ""))
    return "".join(f"0\nSECTION\n2\n{name}\n{inside}0\nENDSEC\n" for name, inside in sections) + "0\nEOF\n"


def ellipses(count: int) -> str:
    """Ellipses all over a square whose sides are 1,000."""
    return "".join(ELLIPSE.format(37 * k % 911, 53 * k % 907) for k in range(count))


def test_a_share_of_the_entities_is_kept_and_all_else(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sampling, "SAMPLE", 100)
    polyline = (
        "0\nPOLYLINE\n8\n0\n66\n1\n70\n0\n"
        + "".join(f"0\nVERTEX\n8\n0\n10\n{k}\n20\n6\n" for k in range(3))
        + "0\nSEQEND\n8\n0\n"
    )
    text = dxf(ellipses(1000) + polyline + "".join(LINE.format(k) for k in range(500)), "0\nBLOCK\n2\nA\n0\nENDBLK\n")
    some = some_of(text)
    assert some is not None
    assert some.share == 0.1
    assert 60 < some.text.count("\nELLIPSE\n") < 140
    assert 30 < some.text.count("\nLINE\n") < 70
    assert polyline in some.text
    assert some.text.startswith(text[: text.index("0\nELLIPSE")])
    assert some.text.endswith("0\nENDSEC\n0\nSECTION\n2\nOBJECTS\n0\nENDSEC\n0\nEOF\n")
    assert some.size == 1000.0
    sample = sample_of(text)
    assert sample is not None
    assert len(sample.drawing.bodies) == some.text.count("\nELLIPSE\n") + some.text.count("\nLINE\n") + 1


@pytest.mark.parametrize("more", ["0\nINSERT\n2\nA\n", "", "10\nx\n"])
def test_blocks_few_curves_and_places_that_are_none_are_not_sampled(monkeypatch: pytest.MonkeyPatch, more: str) -> None:
    monkeypatch.setattr(sampling, "SAMPLE", 100)
    assert some_of(dxf(ellipses(199) + more)) is None
    assert (some_of(dxf(ellipses(201) + more)) is None) == ("INSERT" in more)
    assert some_of(ellipses(1000)) is None


def test_what_would_surely_be_too_many_arcs_is_told_of_some(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sampling, "SAMPLE", 100)
    path = tmp_path / "a.dxf"
    path.write_text(dxf(ellipses(400)))
    arcs = len(carom.Scene.load(path).shapes)
    monkeypatch.setattr(reading, "MOST_ARCS", arcs // 4)
    with pytest.raises(carom.SceneError, match="the drawing: the curves need about") as caught:
        carom.Scene.load(path)
    told = float(str(caught.value).split("about ")[1].split()[0])
    assert 0.3 < told / arcs < 3.0  # an estimate
    # Of a drawing that is much larger than what some of it says they are fewer.
    assert carom.Scene.load(path, tolerance=100.0).shapes


@pytest.mark.slow
def test_few_of_a_hundred_thousand_ellipses_are_read_to_tell_that_they_are_too_many(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "a.dxf"
    path.write_text(dxf(ellipses(100_000)))
    pytest.importorskip("ezdxf")
    from carom.scene.drawings import dxf as readers

    sizes, read = [], readers._document_of
    monkeypatch.setattr(readers, "_document_of", lambda text: sizes.append(len(text)) or read(text))
    with pytest.raises(carom.SceneError, match="the curves need about"):
        carom.Scene.load(path, 0.01)
    assert 0 < sum(sizes) < 0.1 * path.stat().st_size
