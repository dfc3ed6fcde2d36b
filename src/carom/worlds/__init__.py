"""Many copies of a world, stepped by one call: `Worlds`."""

from carom.worlds.hits import CopyHit, CopyHits
from carom.worlds.worlds import Worlds

__all__ = ["CopyHit", "CopyHits", "Worlds"]
