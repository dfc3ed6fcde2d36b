"""The Collision Math Toy: the table `toy`, and a panel with everything that lets a person see the mathematics.

The panel's rows stand in `items`, what its switches do in `settings` and `desk`; `view` draws a table, `beside` what is
around two of them, `probe` reads the numbers of a shape, `hand` throws balls, `lane` launches them, and `chart` counts
box tests.
"""

from carom.play.toy.app import run
from carom.play.toy.chart import write_chart

__all__ = ["run", "write_chart"]
