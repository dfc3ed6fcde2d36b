"""Every module has tests of its name, at the same place below `tests/unit` as it has below the package."""

from collections.abc import Iterator
from pathlib import Path

from tests.conventions.source_trees import PACKAGE, ROOT, check_each, functions

#: The rooms whose modules have tests of their name; games are tested as a player meets them, in `tests/play`.
ROOMS = ("cli", "compiler", "draw", "geometry", "record", "rl", "rows", "scene", "shapes", "study", "world", "worlds")

#: What the rows of one table hold, and no more: `tests/unit/rows/test_tables.py` walks these tables.
FIELDS_ALONE = {
    f"rows/{table}.py"
    for table in ("ball", "copies", "flight", "hit", "index", "island", "query", "relation", "saved", "shape", "state")
}


def modules() -> list[Path]:
    """The modules of the rooms; a package's own file only hands on what others have."""
    return [path for room in ROOMS for path in sorted((PACKAGE / room).rglob("*.py")) if path.stem != "__init__"]


def place_of_tests(module: Path) -> Path:
    """Where the tests of a module stand."""
    return ROOT / "tests" / "unit" / module.relative_to(PACKAGE).with_name(f"test_{module.name}")


def test_every_module_has_tests_of_its_name() -> None:
    def missing(module: Path) -> Iterator[str]:
        tests = place_of_tests(module)
        if not tests.exists():
            yield f"has no {tests.relative_to(ROOT)}"
        elif not any(function.name.startswith("test_") for function in functions(tests)):
            yield f"has no tests in {tests.relative_to(ROOT)}"

    check_each([module for module in modules() if name_in(module) not in FIELDS_ALONE], missing)


def test_what_has_no_tests_of_its_name_has_nothing_to_test() -> None:
    def more(module: Path) -> Iterator[str]:
        if any(functions(module)):
            yield "has a function"
        if place_of_tests(module).exists():
            yield "has tests of its name"

    assert {name_in(module) for module in modules()} >= FIELDS_ALONE
    check_each([PACKAGE / name for name in sorted(FIELDS_ALONE)], more)


def name_in(module: Path) -> str:
    """A module's place in the package."""
    return module.relative_to(PACKAGE).as_posix()
