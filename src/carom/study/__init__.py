"""Studies: tables and what is measured in them, plots of what a recording holds, and sweeps of many runs.

`plots` needs matplotlib, `pip install "carom[study]"`; `sweep` needs Dask and pyarrow, `pip install "carom[sweep]"`.
"""

from carom.study import measures, plots
from carom.study.billiards.escapes import Correlation, Escape, correlation, escape
from carom.study.billiards.maps import BoundaryMap, Density, MeanFreePath, boundary_map, mean_free_path
from carom.study.billiards.running import RunLyapunov, lyapunov_of
from carom.study.billiards.sections import Section, section
from carom.study.billiards.spectra import Lyapunov, lyapunov
from carom.study.billiards.tables import Starts, Table, table
from carom.study.sweeps import sweep

__all__ = [
    "BoundaryMap",
    "Correlation",
    "Density",
    "Escape",
    "Lyapunov",
    "MeanFreePath",
    "RunLyapunov",
    "Section",
    "Starts",
    "Table",
    "boundary_map",
    "correlation",
    "escape",
    "lyapunov",
    "lyapunov_of",
    "mean_free_path",
    "measures",
    "plots",
    "section",
    "sweep",
    "table",
]
