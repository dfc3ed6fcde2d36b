"""Names for annotations: what carom takes where it asks for a pair or for one of a few words, and what it gives back.

>>> from carom.typing import Detection, Pair
>>> def serve(position: Pair, detection: Detection = "continuous") -> None: ...
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Literal, TypeAlias

import numpy as np
from numpy.typing import NDArray

#: A pair of numbers as it is given back.
Vector: TypeAlias = tuple[float, float]

#: One number: Python's or NumPy's.
Number: TypeAlias = float | np.floating[Any] | np.integer[Any]

#: A pair of numbers that can be told from many pairs by its type.
OnePair: TypeAlias = tuple[Number, Number] | list[float] | list[int]

#: A pair of numbers as it is taken: a tuple, a list or an array of two.
Pair: TypeAlias = OnePair | NDArray[np.floating[Any]] | NDArray[np.integer[Any]]

#: Many pairs as they are taken: an array of shape (n, 2), or a list of pairs.
Pairs: TypeAlias = NDArray[Any] | Sequence[OnePair]

#: How collisions are found.
Detection: TypeAlias = Literal["discrete", "continuous"]

#: How the pairs are found that may collide.
BroadPhase: TypeAlias = Literal["brute", "grid", "quadtree"]

#: What elasticity scales: the normal velocity, or all of it.
Restitution: TypeAlias = Literal["normal", "total"]

#: How a shape moves that is no ball.
MotionName: TypeAlias = Literal["static", "kinematic"]

#: What a run keeps of its hits.
Keep: TypeAlias = Literal["all", "none", "counts"]
