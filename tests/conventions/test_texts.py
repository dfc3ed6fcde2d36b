"""The README and the pages of docs/ are true: their commands are there, their code runs, their links lead somewhere."""

import re
import shlex
from itertools import pairwise
from pathlib import Path

import pytest

import carom
from carom.cli import main
from tests.conventions.source_trees import ROOT, named

BUILT = {"_build", "_figures", "gallery"}  # folders of docs/ that hold what the site's build makes
PAGES = [
    ROOT / "README.md",
    ROOT / "CONTRIBUTING.md",
    ROOT / "CHANGELOG.md",
    *(page for page in sorted((ROOT / "docs").rglob("*.md")) if not BUILT & set(page.parts)),
]
FENCE = re.compile(r"^```([^\n`]*)\n(.*?)^```$", re.MULTILINE | re.DOTALL)
LINK = re.compile(r"!?\[[^\]]*\]\(([^)\s]+)\)")
HEADING = re.compile(r"^#+ (.*)$", re.MULTILINE)

INSTALL_AND_RUN = "pip install . && carom run pinball --seconds 20 --out pinball.svg"
GAMES = {"toy", "pinball", "pool"}  # which are played until someone ends them, or for so many seconds
INSTALL_AND_TEST = 'pip install -e ".[dev]" && pytest'


def blocks(page: Path, language: str) -> list[tuple[int, str]]:
    """The page's code blocks in a language, each with the number of lines before it."""
    text = page.read_text(encoding="utf-8")
    return [
        (text.count("\n", 0, found.start(2)), found.group(2))
        for found in FENCE.finditer(text)
        if found.group(1) == language
    ]


def run_python(page: Path, lines_before: int, text: str, names: dict[str, object]) -> None:
    """Run a block of Python, whose names are added to those of the blocks before it."""
    exec(compile("\n" * lines_before + text, str(page), "exec"), names)


def commands(text: str) -> list[list[str]]:
    """The arguments of each `carom` in a block of shell; what installs and tests is run by `.ci/run`."""
    words = [shlex.split(part, comments=True) for line in text.splitlines() for part in line.split("&&")]
    others = {"pip", "pytest", "pre-commit", ".ci/run", "sphinx-build"}
    assert {line[0] for line in words if line} <= {"carom", *others}
    return [line[1:] for line in words if line and line[0] == "carom"]


def anchors(page: Path) -> set[str]:
    """The anchors of the page's headings."""
    headings = HEADING.findall(FENCE.sub("", page.read_text(encoding="utf-8")))
    return {re.sub(r"[^\w\- ]", "", heading.lower()).strip().replace(" ", "-") for heading in headings}


def broken_links(page: Path) -> list[str]:
    """The page's links to files or headings that are not there."""
    broken = []
    for link in LINK.findall(FENCE.sub("", page.read_text(encoding="utf-8"))):
        if link.startswith(("http://", "https://")):
            continue
        path, _, anchor = link.partition("#")
        target = (page.parent / path).resolve() if path else page
        if not target.exists() or (anchor and anchor not in anchors(target)):
            broken.append(link)
    return broken


def test_the_readme_opens_with_a_picture_and_the_two_commands() -> None:
    shell = [line for _, text in blocks(ROOT / "README.md", "sh") for line in text.splitlines()]
    assert shell[:2] == [INSTALL_AND_RUN, INSTALL_AND_TEST]
    text = (ROOT / "README.md").read_text(encoding="utf-8")
    assert text.index("docs/pictures/pinball.svg") < text.index(INSTALL_AND_RUN)


@pytest.mark.parametrize("page", [page for page in PAGES if blocks(page, "python")], ids=named)
def test_the_code_of_a_page_runs_from_top_to_bottom(
    page: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    names: dict[str, object] = {}
    for lines_before, text in blocks(page, "python"):
        run_python(page, lines_before, text, names)


@pytest.mark.slow
@pytest.mark.compiled
@pytest.mark.parametrize("page", [page for page in PAGES if blocks(page, "sh")], ids=named)
def test_the_commands_of_a_page_run_after_the_code_before_them(
    page: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    for driver in ("SDL_VIDEODRIVER", "SDL_AUDIODRIVER"):
        monkeypatch.setenv(driver, "dummy")
    names: dict[str, object] = {}
    steps = sorted([(*block, "python") for block in blocks(page, "python")] + [(*b, "sh") for b in blocks(page, "sh")])
    for lines_before, text, language in steps:
        if language == "python":
            run_python(page, lines_before, text, names)
            continue
        for arguments in commands(text):
            if arguments[0] in GAMES and "--chart" not in arguments:
                arguments += ["--seconds", "0.2"]
            with pytest.raises(SystemExit) as ended:
                main(arguments)
            assert ended.value.code in (0, None), (arguments, capsys.readouterr().err)
            outputs = [Path(after) for word, after in pairwise(arguments) if word == "--out"]
            assert all(path.stat().st_size > 100 for path in outputs)


@pytest.mark.parametrize("page", PAGES, ids=named)
def test_every_block_of_python_is_one_that_runs(page: Path) -> None:
    languages = {found.group(1).lower() for found in FENCE.finditer(page.read_text(encoding="utf-8"))}
    assert {language for language in languages if "py" in language} <= {"python", "{code-cell} ipython3"}


@pytest.mark.parametrize("page", PAGES, ids=named)
def test_links_lead_somewhere(page: Path) -> None:
    assert broken_links(page) == []


@pytest.mark.parametrize("page", [page for page in PAGES if blocks(page, "toml")], ids=named)
def test_the_scenes_of_a_page_can_be_built(page: Path, tmp_path: Path) -> None:
    for place, (_, text) in enumerate(blocks(page, "toml")):
        path = tmp_path / f"{place}.toml"
        path.write_text(text, encoding="utf-8")
        assert len(carom.Scene.load(path).build().shapes) > 0
