"""A table of each kind of shape, as short as it can be."""

from typing import Any

SHAPES: dict[str, dict[str, Any]] = {
    "point": {"kind": "point", "position": [1, 2]},
    "segment": {"kind": "segment", "start": [0, 0], "end": [1, 0]},
    "gate": {"kind": "gate", "start": [0, 0], "end": [1, 0]},
    "circle": {"kind": "circle", "center": [0, 0], "radius": 1},
    "arc": {"kind": "arc", "center": [0, 0], "radius": 1, "start_angle": 0, "end_angle": 1},
    "compound": {"kind": "compound", "pivot": [0, 0], "shapes": [{"kind": "point", "position": [1, 0]}]},
    "group": {"kind": "group", "shapes": [{"kind": "point", "position": [1, 0]}]},
}
