"""Worlds: what moves, in which order, and what comes out."""

from carom.world.hits import Hit, HitKind, Hits
from carom.world.statistics import Statistics
from carom.world.world import World

__all__ = ["Hit", "HitKind", "Hits", "Statistics", "World"]
