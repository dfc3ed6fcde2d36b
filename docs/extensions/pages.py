"""What the site needs besides its pages: links that hold there, docstrings as they are meant, pictures of examples."""

from __future__ import annotations

import re
import shutil
from pathlib import Path
from typing import TYPE_CHECKING, Any

from reading_order import EXAMPLES
from sphinx.errors import ExtensionError
from sphinx_gallery.scrapers import figure_rst

if TYPE_CHECKING:
    from sphinx.application import Sphinx

#: Texts outside of docs/ that are pages of the site, as links name them, and the pages that they are there.
OUTSIDE = {"README.md": "index.md", "CONTRIBUTING.md": "contributing.md", "CHANGELOG.md": "changelog.md"}
OUTSIDE_LINK = re.compile(r"\]\((?:\.\./)+([A-Z]+\.md)")
EXAMPLE_LINK = re.compile(r"\]\((?:\.\./)+examples/(\w+)\.(?:py|md|rst)")
LOADED = re.compile(
    r"""<(?:script|img|iframe|source)\b[^>]*\bsrc=["']?(?:https?:)?//|<link\b[^>]*\bhref=["']?https?://"""
)
CODE = re.compile(r"(``.+?``|`[^`]+`)")


def link_within(app: Sphinx, name: str, source: list[str]) -> None:
    """Turn links to texts outside of docs/, and to examples, into links to their pages."""
    up = "../" * name.count("/")
    text = OUTSIDE_LINK.sub(lambda link: f"]({up}{OUTSIDE[link[1]]}", source[0])
    source[0] = EXAMPLE_LINK.sub(lambda link: f"]({up}gallery/{link[1].replace('README', 'index')}.rst", text)


def escape_docstring(app: Sphinx, what: str, name: str, thing: Any, options: Any, lines: list[str]) -> None:
    """Take docstrings as they are meant: outside of code, bars and stars are those of formulas."""
    for number, line in enumerate(lines):
        parts = CODE.split(line)
        parts[::2] = [re.sub(r"[|*]|(?<=\w)_(?!\w)", r"\\\g<0>", part) for part in parts[::2]]
        lines[number] = "".join(parts)
    if what in {"attribute", "property"} and lines:
        lines[0] = f": {lines[0]}"  # else what stands before a colon of the sentence is taken for a type


def svg_scraper(block: Any, variables: dict[str, Any], settings: dict[str, Any]) -> str:
    """The SVG files that a block of an example wrote, moved into the gallery."""
    folder = Path(variables["src_file"]).parent
    targets = []
    for path in sorted(folder.glob("*.svg")):
        target = Path(next(variables["image_path_iterator"])).with_suffix(".svg")
        shutil.move(path, target)
        targets.append(str(target))
    return figure_rst(targets, settings["src_dir"])


class ReadingOrder:
    """Sorts examples as `EXAMPLES` has them."""

    def __init__(self, folder: str) -> None:
        self.folder = folder

    def __call__(self, name: str) -> int:
        """The place of an example's file."""
        return EXAMPLES.index(Path(name).stem)


def refuse_network(app: Sphinx, error: Exception | None) -> None:
    """Fail the build if a page loads anything from a network."""
    if error is None:
        loading = [path.name for path in Path(app.outdir).rglob("*.html") if LOADED.search(path.read_text("utf-8"))]
        if loading:
            raise ExtensionError(f"pages load something from a network: {', '.join(sorted(loading))}")


def setup(app: Sphinx) -> dict[str, bool]:
    """Connect all of it."""
    app.connect("source-read", link_within)
    app.connect("autodoc-process-docstring", escape_docstring, priority=400)  # before napoleon
    app.connect("build-finished", refuse_network)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
