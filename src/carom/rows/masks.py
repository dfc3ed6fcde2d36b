"""Whether two rows of shapes or balls meet at all."""

from __future__ import annotations

from carom.rows.tables import Numbered


def may_collide(first: Numbered, second: Numbered) -> bool:
    """True if neither of two rows is switched off and each one's layer is in the other's mask."""
    if first["can_collide"] == 0 or second["can_collide"] == 0:
        return False
    return bool(first["layer"] & second["collides_with"]) and bool(second["layer"] & first["collides_with"])
