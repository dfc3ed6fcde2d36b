"""What mypy says of a misspelt field of a row: of a world's state, a shape, a ball, an answer, a kernel's argument."""

import re
from pathlib import Path

import pytest

from tests.typing.test_user_programs import run

#: Each line but those of the beginning has a field that there is not.
PROGRAM = """\
import carom
from carom.rows.flight import FlightRow
from carom.rows.tables import Table
from carom.shapes.rails import halt
from carom.world.answers import CastHits
world, ball, wall = carom.World(), carom.Ball((0, 0), 1), carom.Segment((0, 0), (1, 0))
world._states[0]["sleepng"] += 1
world.statistics._count("colisions")
ball._row["frction"] = 0.5
ball._with("position", 1, xx=2.0)
wall._row["lenght"]
wall._set_geometry("p0", (0, 0), ax=0.0, ya=0.0)
wall._still_row()["pivot"]
world._arrays.shapes.row(wall)["centre_x"]
halt({"time_lift": 1.0})
CastHits._object(CastHits(0), world, {"shap": 1})
def fly(flights: Table[FlightRow]) -> float: return flights[0]["event_tme"]
"""


@pytest.mark.slow
def test_every_misspelt_field_is_found(tmp_path: Path) -> None:
    pytest.importorskip("mypy")
    program = tmp_path / "program.py"
    program.write_text(PROGRAM, encoding="utf-8")
    flags = ("--strict", "--config-file=", f"--cache-dir={tmp_path}", "--follow-imports=silent", "--no-error-summary")
    said = run("mypy", *flags, str(program), folder=tmp_path)
    found = {
        int(match[1]) for match in re.finditer(r"program\.py:(\d+): error: .*(?:key|keyword|argument)", said, re.I)
    }
    assert found == set(range(7, len(PROGRAM.splitlines()) + 1)), said
