"""Studies of runs: plots of what a recording holds.

`plots` needs matplotlib: `pip install "carom[study]"`.
"""

from carom.study import plots

__all__ = ["plots"]
