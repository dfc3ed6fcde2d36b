"""A directive for a run that plays on a page: `{run} scene seconds`, its content the caption.

The scene is a shipped one. Its run is recorded when the page is read; what plays it is one file beside the pages.
"""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, ClassVar

from docutils import nodes
from sphinx.util.docutils import SphinxDirective

from carom import Recording, draw, scenes

if TYPE_CHECKING:
    from collections.abc import Callable

    from sphinx.application import Sphinx

#: Where the files are written, below the folder of the site.
FOLDER = "_runs"

#: What shows one in a page; it begins to play by itself.
FRAME = '<iframe class="run" src="{path}#play" title="A run of the scene {scene}, which plays" loading="lazy"></iframe>'


class Run(SphinxDirective):
    """Shows a run of a shipped scene, with its caption below."""

    required_arguments = 2
    has_content = True
    option_spec: ClassVar[dict[str, Callable[[str], str]]] = {}

    def run(self) -> list[nodes.Node]:
        """The figure: a frame in which the run plays, and the caption."""
        scene, seconds = self.arguments
        if scene not in scenes.names():
            raise self.error(f"there is no scene {scene!r}")
        write_run(Path(self.env.app.outdir) / FOLDER, scene, float(seconds))
        path = "../" * self.env.docname.count("/") + f"{FOLDER}/{scene}.html"
        words, messages = self.state.inline_text(" ".join(self.content), self.lineno)
        figure = nodes.figure(
            "", nodes.raw("", FRAME.format(path=path, scene=scene), format="html"), classes=["drawing"]
        )
        figure += nodes.caption("", "", *words)
        self.set_source_info(figure)
        return [figure, *messages]


def write_run(folder: Path, scene: str, seconds: float) -> None:
    """Write the page that plays a shipped scene for so long."""
    world = getattr(scenes, scene)().build()
    folder.mkdir(parents=True, exist_ok=True)
    page = draw.replay_page(Recording.of(world, seconds, name=scene.replace("_", " ").capitalize()))
    (folder / f"{scene}.html").write_text(page, encoding="utf-8")


def setup(app: Sphinx) -> dict[str, bool]:
    """Add the directive."""
    app.add_directive("run", Run)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
