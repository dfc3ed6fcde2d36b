"""What is installed is complete, and importing it is cheap and quiet."""

import re
import subprocess
import sys
import tomllib
from importlib.metadata import entry_points, version
from pathlib import Path
from zipfile import ZipFile

import pytest

import carom

ROOT = Path(__file__).resolve().parents[2]
BUILD = "import sys; from hatchling.build import build_wheel; build_wheel(sys.argv[1])"
HEAVY = {
    "numba",
    "llvmlite",
    "pydantic",
    "pygame",
    "imageio_ffmpeg",
    "matplotlib",
    "pyarrow",
    "typer",
    "rich",
    "tomli_w",
    "platformdirs",
    "filelock",
}


def python(*arguments: str) -> str:
    """What a fresh interpreter prints."""
    return subprocess.run([sys.executable, *arguments], cwd=ROOT, capture_output=True, text=True, check=True).stdout


def loaded_after(statement: str) -> set[str]:
    """Packages that a fresh interpreter has loaded after a statement."""
    return set(
        python("-c", f"{statement}; import sys; print(*{{name.partition('.')[0] for name in sys.modules}})").split()
    )


@pytest.fixture(scope="module")
def wheel(tmp_path_factory: pytest.TempPathFactory) -> ZipFile:
    """The built wheel."""
    folder = tmp_path_factory.mktemp("wheel")
    python("-c", BUILD, str(folder))
    (path,) = folder.glob("*.whl")
    return ZipFile(path)


def test_the_wheel_holds_every_file_of_the_package_its_types_and_its_licence(wheel: ZipFile) -> None:
    names = set(wheel.namelist())
    files = [path for path in (ROOT / "src" / "carom").rglob("*") if path.is_file() and "__pycache__" not in path.parts]
    sources = {path.relative_to(ROOT / "src").as_posix() for path in files}
    assert sources <= names
    assert "carom/draw/replay/template.html" in sources
    assert "carom/py.typed" in names
    assert any(name.endswith("licenses/LICENSE") for name in names)


def test_the_extra_of_the_site_brings_what_the_gallery_asks_for() -> None:
    extras = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]["optional-dependencies"]
    brought = {"docs", *re.findall(r"\w+", extras["docs"][0].partition("[")[2])}
    programs = [path.read_text(encoding="utf-8") for path in (ROOT / "examples").glob("*.py")]
    asked = {name for text in programs for name in re.findall(r"carom\[(\w+)\]", text)}
    assert "drawings" in asked
    assert asked <= brought


def test_the_wheel_holds_nothing_else(wheel: ZipFile) -> None:
    assert {name.partition("/")[0] for name in wheel.namelist()} == {"carom", f"carom-{carom.__version__}.dist-info"}
    assert [name for name in wheel.namelist() if name.endswith((".pyc", ".nbi", ".nbc"))] == []


def test_the_version_is_the_same_wherever_it_is_said(wheel: ZipFile) -> None:
    metadata = wheel.read(f"carom-{carom.__version__}.dist-info/METADATA").decode()
    assert f"\nVersion: {carom.__version__}\n" in metadata
    assert version("carom") == carom.__version__


def test_the_description_shows_nothing_and_leads_nowhere_that_a_package_index_has_not(wheel: ZipFile) -> None:
    metadata = wheel.read(f"carom-{carom.__version__}.dist-info/METADATA").decode()
    head, _, text = metadata.partition("\n\n")
    assert "Description-Content-Type: text/markdown" in head
    assert text.startswith("# carom\n")
    assert [place for place in re.findall(r"\]\(([^)]*)\)", text) if not place.startswith(("https://", "#"))] == []
    named = set(re.findall(r"\(`([^`]+)`\)", text))
    assert "docs/start.md" in named
    assert [path for path in named if not (ROOT / path).is_file()] == []
    readme = (ROOT / "README.md").read_text(encoding="utf-8")
    assert text.count("```") == readme.count("```"), "no program is lost"
    assert text.count("\n#") == readme.count("\n#"), "and no heading"


def test_the_command_is_installed() -> None:
    (command,) = entry_points(group="console_scripts", name="carom")
    assert command.value == "carom.cli:main"
    assert callable(command.load())


@pytest.mark.slow
@pytest.mark.parametrize(
    "statement",
    [
        "import carom",
        "import carom; carom.Segment((0, 0), (1, 0)).detect(carom.Ball((0.5, 0.1), radius=0.2))",
        "import carom; dir(carom); carom.HitKind; carom.SceneError",
    ],
)
def test_shapes_alone_load_neither_the_compiler_nor_any_extra(statement: str) -> None:
    assert loaded_after(statement) & HEAVY == set()


@pytest.mark.slow
def test_a_world_that_is_not_stepped_loads_no_compiler() -> None:
    assert loaded_after("import carom; carom.World().add(carom.Point((0, 0)))") & HEAVY == set()


@pytest.mark.slow
def test_importing_warns_of_nothing() -> None:
    assert python("-W", "error", "-c", "import carom; carom.World; carom.Scene; carom.scenes") == ""


def test_every_public_name_is_there() -> None:
    assert set(carom.__all__) <= set(dir(carom))
    assert [name for name in carom.__all__ if not hasattr(carom, name)] == []
