"""Draws all figures into a folder: `python -m docs.figures FOLDER`."""

import sys
from pathlib import Path

from docs.figures import draw_all

draw_all(Path(sys.argv[1]))
