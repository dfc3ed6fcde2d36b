"""Worlds: what moves, in which order, and what comes out."""

from carom.world.answers import Aim, Aims, CastHit, CastHits, Contacts, Neighbor, Neighbors
from carom.world.hits import Hit, HitKind, Hits
from carom.world.statistics import Statistics
from carom.world.world import World

__all__ = [
    "Aim",
    "Aims",
    "CastHit",
    "CastHits",
    "Contacts",
    "Hit",
    "HitKind",
    "Hits",
    "Neighbor",
    "Neighbors",
    "Statistics",
    "World",
]
