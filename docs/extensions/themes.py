"""Plots for light and for dark pages: each is drawn twice, and the page's style shows the one that suits it."""

from __future__ import annotations

import io
from base64 import b64encode
from pathlib import Path
from typing import TYPE_CHECKING, Any

from matplotlib.artist import Artist
from matplotlib.colors import is_color_like, to_hex, to_rgba

if TYPE_CHECKING:
    from docutils import nodes
    from matplotlib.figure import Figure
    from sphinx.application import Sphinx

#: What is black or white on a light page, and what it is on a dark one; grounds are clear on both.
DARK = {"#000000": "#cfd0d0", "#ffffff": "#131416"}
#: The properties of what is drawn that have a colour.
COLOURS = ("color", "edgecolor", "facecolor", "markeredgecolor", "markerfacecolor")


def darken(figure: Figure) -> None:
    """Change what is black or white in a figure for good: letters, lines, ticks and frames, not images."""
    for artist in figure.findobj(Artist):
        for name in COLOURS:
            read, write = getattr(artist, f"get_{name}", None), getattr(artist, f"set_{name}", None)
            colour = read() if callable(read) and callable(write) else None
            if isinstance(colour, str | tuple) and is_color_like(colour) and to_rgba(colour)[3] > 0.0:
                plain = to_hex(colour)
                if plain in DARK and write is not None:
                    write(DARK[plain])


def png(figure: Figure) -> bytes:
    """A figure as the bytes of a PNG file, on a clear ground."""
    file = io.BytesIO()
    figure.savefig(file, format="png", transparent=True, bbox_inches="tight")
    return file.getvalue()


def drawn_twice(figure: Figure) -> dict[str, bytes]:
    """A figure as PNG files by theme; it stays dark."""
    light = png(figure)
    darken(figure)
    return {"light": light, "dark": png(figure)}


def plot_scraper(block: Any, variables: dict[str, Any], settings: dict[str, Any]) -> str:
    """The plots that a block of an example drew, each for both themes, as text for its page of the gallery."""
    from matplotlib import pyplot as plt

    lines = []
    for number in plt.get_fignums():
        figure = plt.figure(number)
        words = figure.axes[0].get_title() or figure.axes[0].get_ylabel() if figure.axes else ""
        path = Path(next(variables["image_path_iterator"]))
        for theme, data in drawn_twice(figure).items():
            target = path if theme == "light" else path.with_stem(f"{path.stem}-{theme}")
            target.write_bytes(data)
            place = target.relative_to(settings["src_dir"]).as_posix()
            lines += [f".. image:: /{place}", f"   :alt: {words}", f"   :class: sphx-glr-single-img only-{theme}", ""]
    plt.close("all")
    return "\n".join(lines)


def html(figure: Figure) -> str:
    """A figure for both themes as elements of HTML."""
    return "".join(
        f'<img class="only-{theme}" alt="" src="data:image/png;base64,{b64encode(data).decode()}">'
        for theme, data in drawn_twice(figure).items()
    )


def show_plots_in_both() -> None:
    """From here on, let a notebook's plots be shown for both themes."""
    from IPython import get_ipython
    from matplotlib.figure import Figure

    shell = get_ipython()
    if shell is not None:
        shell.run_line_magic("matplotlib", "inline")  # now, for it forgets how figures are shown
        shell.display_formatter.formatters["text/html"].for_type(Figure, html)


def in_both(app: Sphinx, page: nodes.document) -> None:
    """Let each picture of a page that has another one for dark pages beside it, `name-dark.png`, be shown as suits."""
    from docutils import nodes

    folder = Path(app.env.doc2path(app.env.docname)).parent
    for light in list(page.findall(nodes.image)):
        there = Path(light["uri"])
        dark = there.with_stem(f"{there.stem}-dark")
        if (folder / dark).is_file():
            other = light.deepcopy()
            other["uri"] = dark.as_posix()
            light["classes"].append("only-light")
            other["classes"].append("only-dark")
            light.parent.insert(light.parent.index(light) + 1, other)


def setup(app: Sphinx) -> dict[str, bool]:
    """Look for pictures for dark pages before Sphinx collects what pages show."""
    app.connect("doctree-read", in_both, priority=400)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
