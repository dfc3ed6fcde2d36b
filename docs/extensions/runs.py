"""Directives for what plays on a page: `{run} scene seconds`, and `{video} file`; their content is the caption.

The scene of a run is a shipped one; it is recorded when the page is read, and what plays it is a file beside the pages.
The file of a video is one of the site's static ones.
"""

from __future__ import annotations

from html import escape
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


#: What shows a video in a page.
VIDEO = '<video class="run" controls muted playsinline preload="metadata" src="{path}" title="{words}"></video>'


class Video(SphinxDirective):
    """Shows a video, with its caption below."""

    required_arguments = 1
    has_content = True
    option_spec: ClassVar[dict[str, Callable[[str], str]]] = {}

    def run(self) -> list[nodes.Node]:
        """The figure: the video, and the caption."""
        name, caption = self.arguments[0], " ".join(self.content)
        if not (Path(self.env.app.srcdir) / "static" / name).is_file():
            raise self.error(f"there is no video {name!r}")
        path = "../" * self.env.docname.count("/") + f"_static/{name}"
        return [captioned(self, VIDEO.format(path=path, words=escape(caption)), caption)]


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
        return [captioned(self, FRAME.format(path=path, scene=scene), " ".join(self.content))]


def captioned(directive: SphinxDirective, html: str, caption: str) -> nodes.figure:
    """A figure of an element of HTML, with a caption."""
    words, messages = directive.state.inline_text(caption, directive.lineno)
    figure = nodes.figure("", nodes.raw("", html, format="html"), classes=["drawing"])
    figure += nodes.caption("", "", *words)
    figure += messages
    directive.set_source_info(figure)
    return figure


def write_run(folder: Path, scene: str, seconds: float) -> None:
    """Write the page that plays a shipped scene for so long."""
    world = getattr(scenes, scene)().build()
    folder.mkdir(parents=True, exist_ok=True)
    page = draw.replay_page(Recording.of(world, seconds, name=scene.replace("_", " ").capitalize()))
    (folder / f"{scene}.html").write_text(page, encoding="utf-8")


def setup(app: Sphinx) -> dict[str, bool]:
    """Add the directives."""
    app.add_directive("run", Run)
    app.add_directive("video", Video)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
