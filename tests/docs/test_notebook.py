"""The example notebook runs, and what ends its cells shows itself."""

import ast
import re
import sys
from typing import Any

import matplotlib as mpl
import pytest

from tests.conventions.source_trees import ROOT

NOTEBOOK = ROOT / "docs" / "notebook.md"
CELL = re.compile(r"^```\{code-cell\} ipython3\n(?::tags:.*?\n)?(.*?)^```$", re.MULTILINE | re.DOTALL)


def shown(cell: str, names: dict[str, Any]) -> Any:
    """What a cell shows: the value of its last line, unless that ends with a semicolon or is no expression."""
    tree = ast.parse(cell)
    last = tree.body[-1]
    if not isinstance(last, ast.Expr) or cell.rstrip().endswith(";"):
        exec(compile(tree, str(NOTEBOOK), "exec"), names)
        return None
    exec(compile(ast.Module(tree.body[:-1], []), str(NOTEBOOK), "exec"), names)
    return eval(compile(ast.Expression(last.value), str(NOTEBOOK), "eval"), names)


@pytest.mark.compiled
def test_the_notebook_runs_and_shows_a_world_a_run_and_a_scene(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    mpl.use("Agg")
    monkeypatch.chdir(NOTEBOOK.parent)  # where notebooks are run from
    monkeypatch.setattr("sys.path", [*sys.path])
    names: dict[str, Any] = {}
    cells = [shown(cell, names) for cell in CELL.findall(NOTEBOOK.read_text(encoding="utf-8"))]
    world, shapes, contact, run, touches, scene = [value for value in cells if value is not None]
    assert world._repr_svg_().startswith("<svg")
    assert "<td>bumper</td>" in shapes._repr_html_()
    assert "setback" in contact._repr_svg_()
    assert "<td>dome</td>" in touches._repr_html_()
    assert run._repr_html_().startswith("<iframe")
    assert scene._repr_svg_().startswith("<svg")
    assert "(721, 6, 2) frames, balls, coordinates" in capsys.readouterr().out
    assert len(run.hits) > 100
