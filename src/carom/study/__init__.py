"""Studies: plots of what a recording holds, and sweeps of many runs.

`plots` needs matplotlib, `pip install "carom[study]"`; `sweep` needs Dask and pyarrow, `pip install "carom[sweep]"`.
"""

from carom.study import measures, plots
from carom.study.sweeps import sweep

__all__ = ["measures", "plots", "sweep"]
