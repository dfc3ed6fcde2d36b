"""The figures of the mathematics pages, drawn by the library's own painter, most of them from the library's answers.

`FIGURES` holds them by name; `draw_all` writes each as two SVG files, for a light and for a dark page.
`python -m docs.figures FOLDER` does so too.
"""

from docs.figures import arcs, balls, boxes, circles, ends, film, impacts, lines, moving, points, segments, tangents  # noqa: F401
from docs.figures.sheet import FIGURES, draw_all

__all__ = ["FIGURES", "draw_all"]
