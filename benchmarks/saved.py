"""Runs of the benchmarks, kept as JSON to be compared with later ones."""

import json
from dataclasses import asdict, dataclass
from pathlib import Path

from benchmarks.common import Before, Figure


@dataclass(frozen=True)
class Run:
    """What was measured, and on what."""

    on: dict[str, str]
    figures: dict[str, list[Figure]]

    def of(self, workload: str) -> Before:
        """The figures of one workload by their cases and engines; none where it was not measured."""
        return {(figure.workload, figure.engine): figure for figure in self.figures.get(workload, [])}


def save(path: Path, run: Run) -> None:
    """Keep a run in a file."""
    path.write_text(json.dumps(asdict(run), indent=1) + "\n", encoding="utf-8")


def load(path: Path) -> Run:
    """The run that was saved in a file.

    Raises:
        OSError: It cannot be read.
        ValueError: It holds no run.
    """
    try:
        told = json.loads(path.read_text(encoding="utf-8"))
        return Run(told["on"], {name: [Figure(**each) for each in found] for name, found in told["figures"].items()})
    except (ValueError, KeyError, TypeError, AttributeError):
        raise ValueError(f"{path} is no run that --json has saved") from None
