"""The page on adding a shape names every file that a new kind touches, and no other: found in the sources' trees."""

import ast
import re
from pathlib import Path

import pytest

from carom.rows.shape import KIND_NAMES
from tests.conventions.source_trees import PACKAGE, ROOT, functions, package_files, tree

PAGE = ROOT / "docs" / "how-to-add-a-shape.md"
NAMES = {name for name in KIND_NAMES if name != "ball"}
CODES = {name.upper() for name in NAMES}
CLASSES = {name.title() for name in NAMES}
#: Tables that are made of the kinds there are, and games that are played on them, need no other kind.
TABLES = {"play", "scene/shipped"}
#: A file that names as many kinds by strings deals with kinds. Fewer may be a field, or an ink.
MANY = 3


def imported(module: ast.Module, room: str) -> set[str]:
    """The names that a file imports from a module or from those below it."""
    return {
        alias.name
        for node in ast.walk(module)
        if isinstance(node, ast.ImportFrom) and f"{node.module}.".startswith(f"{room}.")
        for alias in node.names
    }


def said(module: ast.Module) -> set[str]:
    """The names and strings of a file but for its annotations and what it calls: who makes a shape asks nothing."""
    silent: set[int] = set()
    for node in ast.walk(module):
        annotations = [getattr(node, "annotation", None), getattr(node, "returns", None)]
        called = node.func if isinstance(node, ast.Call) else None
        silent.update(id(part) for top in (*annotations, called) if top is not None for part in ast.walk(top))
    loud = [node for node in ast.walk(module) if id(node) not in silent]
    names = {node.id for node in loud if isinstance(node, ast.Name)}
    return names | {node.value for node in loud if isinstance(node, ast.Constant) and isinstance(node.value, str)}


def deals_with_kinds(path: Path) -> bool:
    """Whether a file asks of what kind a shape is, or has something for each kind."""
    module = tree(path)
    if path.parent == PACKAGE / "geometry":
        answers = {name for function in functions(path) for name in function.name.split("_")}
        tuples = {node.name.removesuffix("Geometry") for node in module.body if isinstance(node, ast.ClassDef)}
        return len(answers & NAMES) > 1 or len(tuples & CLASSES) > 1
    words = said(module)
    kinds = imported(module, "carom.shapes") & CLASSES | imported(module, "carom.rows.shape") & CODES
    if path == PACKAGE / "rows" / "shape.py":
        kinds = CODES
    return bool(words & kinds) or (bool(kinds) and len(words & (NAMES | CLASSES)) >= MANY)


def files_that_deal_with_kinds() -> set[str]:
    """They are, below the package, but for the file of each kind's own class, which stands for all of those."""
    paths = [path for path in package_files() if deals_with_kinds(path)]
    found = {path.relative_to(PACKAGE).as_posix() for path in paths}
    found = {name for name in found if not any(name.startswith(f"{room}/") for room in TABLES)}
    own = {f"shapes/{name}.py" for name in NAMES}
    assert own <= found
    return found - own | {"shapes/<kind>.py"}


def named_on_the_page() -> set[str]:
    """The files of the package that the page names."""
    return set(re.findall(r"`([\w/<>]+\.py)`", PAGE.read_text(encoding="utf-8").partition("## Tests")[0]))


@pytest.mark.slow
def test_the_page_names_every_file_that_deals_with_kinds_and_no_other() -> None:
    assert named_on_the_page() - {"geometry/<kind>.py"} == files_that_deal_with_kinds()


def test_the_page_counts_what_it_lists() -> None:
    text = PAGE.read_text(encoding="utf-8")
    always, some = (len(re.findall(rf"^{mark} \*\*`", text, re.MULTILINE)) for mark in (r"\d+\.", "-"))
    assert (always, some) == (17, 5)
    assert "\nSeventeen files at most" in text
    assert "then five that some kinds need" in text


@pytest.mark.parametrize(
    ("text", "deals"),
    [
        ("from carom.rows.shape import ARC\ndef f(kind):\n    return kind == ARC\n", True),
        ("from carom.shapes.arc import Arc\ndef f(shape):\n    return isinstance(shape, Arc)\n", True),
        ("from carom.shapes.arc import Arc\ndef f(arc: Arc) -> Arc:\n    return Arc((0, 0), 1, 2, 3)\n", False),
        ("from carom.shapes.arc import Arc\nTABLE = {'arc': 1, 'gate': 2, 'circle': 3}\n", True),
        ("TABLE = {'arc': 1, 'gate': 2, 'circle': 3}\n", False),
    ],
)
def test_what_counts(text: str, deals: bool, tmp_path: Path) -> None:
    path = tmp_path / "module.py"
    path.write_text(text)
    assert deals_with_kinds(path) == deals
