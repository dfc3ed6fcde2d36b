"""What the build makes of the README, for a package index, where nothing lies beside it."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

from hatchling.metadata.plugin.interface import MetadataHookInterface

#: A picture on a line of its own, and a link, with a path in this repository each.
PICTURE = re.compile(r"^!\[[^\]]*\]\((?!\w+:)[^)]+\)\n\n?", re.MULTILINE)
LINK = re.compile(r"\[([^\]]+)\]\((?!\w+:|#)([^)]+)\)")
#: The heading of the list of pages, and what stands below it where they cannot be followed.
PAGES, WHERE = "## Read on\n", "\nThese pages come with the source distribution.\n"


class DescriptionHook(MetadataHookInterface):
    """Makes the long description."""

    def update(self, metadata: dict[str, Any]) -> None:
        """Add the description to the metadata."""
        text = (Path(self.root) / "README.md").read_text(encoding="utf-8")
        metadata["readme"] = {"content-type": "text/markdown", "text": description(text)}


def description(readme: str) -> str:
    """A README without pictures that lie beside it, and with the paths of pages in place of links to them."""
    text = LINK.sub(r"\1 (`\2`)", PICTURE.sub("", readme))
    return text.replace(PAGES, PAGES + WHERE)
