"""What mypy and pyright, at their strictest, say of a user's program: nothing where all is right, and every mistake."""

import json
import os
import re
import shutil
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

import carom

FOLDER = Path(__file__).resolve().parent
SOURCES = FOLDER.parents[1] / "src"
RIGHT, WRONG = FOLDER / "right.py", FOLDER / "wrong.py"

#: What a checker found: its words by file and line.
Findings = dict[tuple[str, int], list[str]]


def run(*command: str, folder: Path) -> str:
    """What a type checker prints."""
    environment = os.environ | {"MYPYPATH": str(SOURCES), "PYRIGHT_PYTHON_IGNORE_WARNINGS": "1"}
    done = subprocess.run(
        [sys.executable, "-m", *command], cwd=folder, capture_output=True, text=True, check=False, env=environment
    )
    return done.stdout or done.stderr


def mypy_says(folder: Path) -> Findings:
    """What mypy finds in both programs."""
    pytest.importorskip("mypy")
    flags = ("--strict", "--config-file=", f"--cache-dir={folder}", "--follow-imports=silent", "--no-error-summary")
    found: Findings = {}
    for line in run("mypy", *flags, str(RIGHT), str(WRONG), folder=folder).splitlines():
        match = re.match(r"(.*?):(\d+): (?:error: )?(.*)", line)
        assert match, line
        found.setdefault((Path(match[1]).name, int(match[2])), []).append(match[3])
    return found


def pyright_says(folder: Path) -> Findings:
    """What pyright finds in both programs."""
    pytest.importorskip("pyright")
    if not re.match(r"pyright \d", run("pyright", "--version", folder=folder)):
        pytest.skip("pyright cannot run: it needs Node.js, or a network to download it")
    settings = {
        "include": ["."],
        "extraPaths": [str(SOURCES)],
        "typeCheckingMode": "strict",
        "reportUnusedExpression": False,
    }
    for program in (RIGHT, WRONG):
        shutil.copy(program, folder)
    path = folder / "pyrightconfig.json"
    path.write_text(json.dumps(settings), encoding="utf-8")
    options = ("--project", str(path), "--pythonpath", sys.executable, "--outputjson")
    said = json.loads(run("pyright", *options, folder=folder))
    assert said["summary"]["filesAnalyzed"] == 2
    found: Findings = {}
    for entry in said["generalDiagnostics"]:
        place = Path(entry["file"]).name, entry["range"]["start"]["line"] + 1
        found.setdefault(place, []).append(entry["message"])
    return found


@pytest.fixture(scope="module", params=[mypy_says, pyright_says], ids=["mypy", "pyright"])
def findings(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Findings:
    """What one of the checkers finds."""
    says: Callable[[Path], Findings] = request.param
    return says(tmp_path_factory.mktemp("typing"))


def test_the_right_program_uses_every_public_name() -> None:
    program = RIGHT.read_text(encoding="utf-8")
    assert [name for name in carom.__all__ if not re.search(rf"\bcarom\.{name}\b", program)] == []


@pytest.mark.slow
def test_nothing_is_said_of_a_right_program(findings: Findings) -> None:
    assert {place: words for place, words in findings.items() if place[0] == RIGHT.name} == {}


@pytest.mark.slow
def test_every_mistake_is_found_and_nothing_else(findings: Findings) -> None:
    lines = WRONG.read_text(encoding="utf-8").splitlines()
    marked = {number for number, line in enumerate(lines, 1) if line.endswith("# wrong")}
    found = {line: words for (file, line), words in findings.items() if file == WRONG.name}
    assert marked - set(found) == set()
    assert {line: words for line, words in found.items() if line not in marked} == {}
