"""Worlds: what moves, in which order, and what comes out."""

from carom.world.answers import Aim, Aims, CastHit, CastHits, Contacts, Neighbor, Neighbors
from carom.world.boundary import Boundary
from carom.world.counts import Count, Counts
from carom.world.hits import Hit, HitKind, Hits
from carom.world.statistics import Statistics
from carom.world.touches import Touch, Touches
from carom.world.world import World

__all__ = [
    "Aim",
    "Aims",
    "Boundary",
    "CastHit",
    "CastHits",
    "Contacts",
    "Count",
    "Counts",
    "Hit",
    "HitKind",
    "Hits",
    "Neighbor",
    "Neighbors",
    "Statistics",
    "Touch",
    "Touches",
    "World",
]
