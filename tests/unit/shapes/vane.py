"""A compound of three kinds of parts."""

from typing import Any

from carom import Arc, Circle, Compound, Segment


def vane(**options: Any) -> Compound:
    """A compound of three kinds of parts."""
    return Compound([Segment((1, 0), (3, 0)), Circle((4, 0), 1), Arc((0, 2), 1, 0, 1)], pivot=(0, 0), **options)
