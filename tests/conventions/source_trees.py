"""Where the project's files are, which of them are kernels, and how a rule is held for all of them."""

import ast
from collections.abc import Callable, Iterable, Iterator
from functools import cache
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
SOURCE = ROOT / "src"
PACKAGE = SOURCE / "carom"
COMPILER_DOORS = [PACKAGE / "compiler" / name for name in ("building.py", "door.py", "entered.py", "pipelines.py")]
KERNEL_LIST = PACKAGE / "compiler" / "kernels.py"

Function = ast.FunctionDef | ast.AsyncFunctionDef


@cache
def tree(path: Path) -> ast.Module:
    """The syntax tree of a source file."""
    return ast.parse(path.read_text(encoding="utf-8"), str(path))


def package_files() -> list[Path]:
    """Every source file of the package."""
    return sorted(PACKAGE.rglob("*.py"))


def python_files() -> list[Path]:
    """Every Python file of the project."""
    rooms = ("src", "tests", "benchmarks", "examples")
    return sorted(path for room in rooms for path in (ROOT / room).rglob("*.py"))


def kernel_files() -> list[Path]:
    """The files whose functions are compiled: all that stand in a room of kernels."""
    for node in tree(KERNEL_LIST).body:
        if isinstance(node, ast.Assign) and ast.unparse(node.targets[0]) == "KERNEL_ROOMS":
            rooms = [SOURCE.joinpath(*room.split(".")) for room in ast.literal_eval(node.value)]
            return sorted(path for room in rooms for path in room.rglob("*.py") if path.name != "__init__.py")
    raise LookupError(f"no KERNEL_ROOMS in {KERNEL_LIST}")


def functions(path: Path) -> Iterator[Function]:
    """Every function and method of a file, nested ones too."""
    return (node for node in ast.walk(tree(path)) if isinstance(node, Function))


def named(path: Path) -> str:
    """A file's path within the project, as a test's id."""
    return path.relative_to(ROOT).as_posix()


def check_each(paths: Iterable[Path], faults: Callable[[Path], Iterable[str]]) -> None:
    """Fail if anything is wrong with any of the files, and name all of it, each behind the file's path."""
    found = [f"{named(path)}: {fault}" for path in paths for fault in faults(path)]
    assert not found, "\n".join(["", *found])
