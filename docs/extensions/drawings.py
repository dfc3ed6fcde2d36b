"""A directive for the library's own figures: `{drawing} name`, its content the caption.

All figures of docs/figures are drawn when the build begins, for a light and for a dark page; the page shows the one
that suits it.
"""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, ClassVar

from docutils import nodes
from sphinx.util.docutils import SphinxDirective

from docs.figures import FIGURES, draw_all

if TYPE_CHECKING:
    from collections.abc import Callable

    from sphinx.application import Sphinx

#: Where the figures are drawn, below the folder of the pages.
FOLDER = "_figures"


class Drawing(SphinxDirective):
    """Shows a figure by its name, with its caption below."""

    required_arguments = 1
    has_content = True
    option_spec: ClassVar[dict[str, Callable[[str], str]]] = {}

    def run(self) -> list[nodes.Node]:
        """The figure: two images, of which the page's style shows one, and the caption."""
        name = self.arguments[0]
        if name not in FIGURES:
            raise self.error(f"there is no figure {name!r}")
        figure = nodes.figure(classes=["drawing"])
        self.set_source_info(figure)
        for theme in ("light", "dark"):
            image = nodes.image(
                uri=f"/{FOLDER}/{name}-{theme}.svg", alt=FIGURES[name].alt, classes=[f"only-{theme}"], candidates={}
            )
            self.set_source_info(image)
            figure += image
        words, messages = self.state.inline_text(" ".join(self.content), self.lineno)
        figure += nodes.caption("", "", *words)
        return [figure, *messages]


def draw_figures(app: Sphinx) -> None:
    """Draw all figures."""
    draw_all(Path(app.srcdir) / FOLDER)


def setup(app: Sphinx) -> dict[str, bool]:
    """Add the directive, and draw the figures before the pages are read."""
    app.add_directive("drawing", Drawing)
    app.connect("builder-inited", draw_figures)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
