"""The replay page: one file that plays a recorded run in any browser, without a network."""

from __future__ import annotations

import json
import re
from base64 import b64encode
from hashlib import sha256
from html import escape
from importlib.resources import files
from typing import TYPE_CHECKING

from carom.checks import instance
from carom.draw.page.run import FIRST_LAYERS, page_run
from carom.draw.paint.svg import printable
from carom.draw.theme import ThemeName
from carom.record.recording import Recording
from carom.spelling import spelled

if TYPE_CHECKING:
    from collections.abc import Collection

    from carom.draw.page.packing import Plain
    from carom.draw.parts.layers import Layer

#: The page's program, in the order in which its parts need each other.
SCRIPTS = (
    "data",
    "motion",
    "view",
    "brush",
    "names",
    "tracks",
    "stage",
    "player",
    "panel",
    "hits",
    "timeline",
    "controls",
    "main",
)
#: What may not stand in a script that holds data: each can end it, or begin what hides its end.
UNSAFE = str.maketrans({"<": "\\u003c", ">": "\\u003e", "&": "\\u0026"})


@spelled
def replay_page(
    recording: Recording, theme: ThemeName = ThemeName.AUTO, layers: Collection[Layer] = FIRST_LAYERS
) -> str:
    """The text of an HTML file that plays `recording`, at first with some `layers`, which its reader can switch.

    It holds all it needs, and may load nothing else.
    """
    instance("recording", recording, Recording, "a Recording")
    script = "\n".join(part(f"{name}.js") for name in SCRIPTS)
    return filled_in(
        part("template.html"),
        {
            "title": escape(printable(recording.name or "A run")),
            "style": part("page.css"),
            "script": script,
            "script_hash": hash_of(script),
            "run": embedded(page_run(recording, theme, layers)),
        },
    )


def part(name: str) -> str:
    """The text of a file of the page."""
    return files("carom.draw").joinpath("replay", name).read_text(encoding="utf-8")


def filled_in(template: str, values: dict[str, str]) -> str:
    """`template` with each `{{name}}` replaced by its value; nothing that a value holds is replaced."""
    return re.sub(r"\{\{(\w+)\}\}", lambda found: values[found[1]], template)


def hash_of(script: str) -> str:
    """What the page's policy calls its own script, the only one that it may run."""
    return "sha256-" + b64encode(sha256(script.encode()).digest()).decode("ascii")


def embedded(data: Plain) -> str:
    """`data` as JSON that can stand in a script of a page, whatever its texts are."""
    return json.dumps(data, separators=(",", ":"), allow_nan=False).translate(UNSAFE)
