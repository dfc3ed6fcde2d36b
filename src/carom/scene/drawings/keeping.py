"""Scenes kept in the pictures of them: so that a picture can be read back as the scene that it was, to the last bit.

A picture shows more than a scene (a panel, arrows, tracks) and each number to a hundredth of a pixel. So the scene
itself is in it, as JSON, together with a digest of all that is drawn. A program may save the picture anew; if it has
changed what is drawn, the scene is not what the picture shows any more, and is not given for it.
"""

from __future__ import annotations

import json
import re
from hashlib import blake2b
from typing import Any
from xml.sax.saxutils import escape

from carom.errors import SceneError
from carom.scene.drawings.tree import MARK, Element, read_tree
from carom.scene.scanning import check_json

#: The id of the element that holds a scene, and its attribute with the digest.
KEPT, DIGEST = "carom-scene", "data-carom-drawn"
#: What the font of every picture that carom draws begins with, on its root.
FONT = "system-ui,-apple-system,'Segoe UI'"
#: What is said of where something is drawn.
_DRAWN = ("cx", "cy", "d", "height", "points", "r", "transform", "viewBox", "width", "x", "x1", "x2", "y", "y1", "y2")


def with_scene(picture: str, table: dict[str, Any]) -> str:
    """The text of an SVG picture with the scene that it shows, given as the table that a file holds."""
    digest = _digest_of(read_tree(picture.encode("utf-8")))
    text = escape(json.dumps(table, separators=(",", ":")))
    kept = f'<metadata id="{KEPT}" {DIGEST}="{digest}">{text}</metadata>'
    head, end, rest = picture.partition(">\n")
    return f"{head}{end}{kept}\n{rest}"


def kept_in(root: Element) -> dict[str, Any] | None:
    """The table of the scene that is kept in a picture, None where there is none.

    Raises `SceneError` where what is drawn was changed since, or the table is broken, and for a picture of carom that
    keeps no scene, as those of runs: its frames and letters would be walls.
    """
    for child in root.children:
        if child.attributes.get("id") == KEPT and child.tag == "metadata":
            if child.attributes.get(DIGEST) != _digest_of(root):
                raise SceneError(
                    f"{child}: is the scene of a picture that was changed since carom drew it; a picture can be read "
                    "back, and not be edited: draw anew, or edit the scene"
                )
            try:
                check_json(child.text)
                table = json.loads(child.text)
            except ValueError as error:
                raise SceneError(f"{child}: is no scene: {error}") from None
            if not isinstance(table, dict):
                raise SceneError(f"{child}: is no scene: must hold one table")
            return table
    if root.attributes.get("role") == "img" and root.attributes.get("font-family", "").startswith(FONT):
        raise SceneError(f"{root}: is a picture of a run, which keeps no scene; `carom show SCENE` draws one that does")
    return None


def _digest_of(root: Element) -> str:
    """A digest of all that is drawn, whatever a program writes around it and between numbers."""
    hashed = blake2b(digest_size=8)
    for element in root.walk():
        attributes = [(name, element.attributes[name]) for name in _DRAWN if name in element.attributes]
        if attributes and MARK not in element.tag:
            words = [f"{name}={re.sub(r'[ ,]+', ' ', text)}" for name, text in attributes]
            hashed.update(f"{element.tag} {' '.join(words)}\n".encode())
    return hashed.hexdigest()
