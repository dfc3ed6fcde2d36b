"""Plots of the site follow its theme: what is black on a light page is light on a dark one, colours stay.

Needs the extra `study`, and is skipped without it.
"""

import io
from pathlib import Path
from types import SimpleNamespace

import matplotlib as mpl
import numpy as np
import pytest

from docs.extensions import themes

mpl.use("Agg")
from matplotlib import pyplot as plt

COLOURED = (0x1F, 0x8A, 0xA8)


def plotted() -> None:
    """A plot with letters, ticks, a frame, a legend, and an area of a colour of its own."""
    _, axes = plt.subplots(figsize=(3.0, 2.0))
    axes.fill_between([0.0, 1.0], [0.0, 0.0], [1.0, 1.0], color="#1f8aa8", label="area")
    axes.plot([0.0, 1.0], [1.0, 0.0], color="black")
    axes.bar([0.2], [0.4], color="#1f8aa8")  # whose edge is black, and clear
    axes.set(title="A title", xlabel="across", ylabel="up")
    axes.legend()


def pixels(data: bytes) -> np.ndarray:
    """The red, green and blue, and the cover, of a PNG file's pixels, from 0 to 255."""
    return np.round(255.0 * plt.imread(io.BytesIO(data), format="png")).astype(int).reshape(-1, 4)


def test_what_is_black_is_light_on_a_dark_page_and_colours_stay() -> None:
    plotted()
    drawn = themes.drawn_twice(plt.gcf())
    plt.close("all")
    light, dark = (pixels(drawn[theme]) for theme in ("light", "dark"))
    assert (light[:, 3] == 0).mean() > 0.2, "the ground is the page's"
    assert light.shape == dark.shape
    for seen, letters in ((light, 0), (dark, 0xCF)):
        opaque = seen[seen[:, 3] == 255][:, :3]
        assert 400 < (np.abs(opaque - letters).max(axis=1) <= 2).sum() < 1400
        assert (np.abs(opaque - COLOURED).max(axis=1) <= 2).sum() > 3000
    assert not (np.abs(dark[dark[:, 3] == 255][:, :3]).max(axis=1) <= 8).any(), "nothing is black on a dark page"


def test_a_plot_of_the_gallery_stands_there_for_both(tmp_path: Path) -> None:
    plotted()
    paths = iter([str(tmp_path / "images" / "plot_001.png")])
    (tmp_path / "images").mkdir()
    text = themes.plot_scraper(None, {"image_path_iterator": paths}, {"src_dir": str(tmp_path)})
    assert plt.get_fignums() == []
    assert [line for line in text.splitlines() if line.startswith("..")] == [
        ".. image:: /images/plot_001.png",
        ".. image:: /images/plot_001-dark.png",
    ]
    assert "only-light" in text
    assert "only-dark" in text
    assert text.count(":alt: A title") == 2
    assert all((tmp_path / "images" / name).stat().st_size > 1000 for name in ("plot_001.png", "plot_001-dark.png"))


def test_a_plot_of_a_notebook_is_two_images(monkeypatch: pytest.MonkeyPatch) -> None:
    shown = {}
    formatter = SimpleNamespace(for_type=lambda kind, show: shown.update({kind.__name__: show}))
    shell = SimpleNamespace(
        run_line_magic=lambda *words: None, display_formatter=SimpleNamespace(formatters={"text/html": formatter})
    )
    themes.show_plots_in_both()  # outside of a notebook it does nothing
    assert shown == {}
    monkeypatch.setattr("IPython.get_ipython", lambda: shell)
    themes.show_plots_in_both()
    plotted()
    text = shown["Figure"](plt.gcf())
    plt.close("all")
    assert text.count("<img ") == 2
    assert 'class="only-dark"' in text


@pytest.mark.parametrize("dark", [False, True])
def test_a_picture_that_has_one_for_dark_pages_beside_it_is_two_images(tmp_path: Path, dark: bool) -> None:
    nodes, utils = pytest.importorskip("docutils.nodes"), pytest.importorskip("docutils.utils")
    (tmp_path / "pictures").mkdir()
    for name in ("plot.png", "plot-dark.png")[: 1 + dark]:
        (tmp_path / "pictures" / name).touch()
    page = utils.new_document("page")
    page += nodes.image(uri="pictures/plot.png", alt="A plot")
    env = SimpleNamespace(docname="page", doc2path=lambda name: str(tmp_path / f"{name}.md"))
    themes.in_both(SimpleNamespace(env=env), page)  # type: ignore[arg-type]
    shown = [(image["uri"], image["alt"], image["classes"]) for image in page.findall(nodes.image)]
    light, other = ("pictures/plot.png", "A plot"), ("pictures/plot-dark.png", "A plot")
    assert shown == ([(*light, ["only-light"]), (*other, ["only-dark"])] if dark else [(*light, [])])
