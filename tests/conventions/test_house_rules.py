"""The house rules that a machine can hold: sizes, docstrings, names, and texts that speak of the project alone."""

import ast
import re
from pathlib import Path

import pytest

from tests.conventions.source_trees import (
    PACKAGE,
    ROOT,
    Function,
    functions,
    kernel_files,
    named,
    package_files,
    python_files,
    tree,
)

LONGEST_FUNCTION = 60
LONGEST_FILE = 500
TEXT_ENDINGS = {".py", ".md", ".toml", ".yaml", ".yml", ".json", ".svg", ".txt"}
MACHINE_PATH = re.compile(r"(?<![\w.])/(?:home|root|tmp|work|Users|opt)/\w|\b[A-Z]:\\\\?Users")
WORKING_NOTE = re.compile(
    r"\b(?:TODO|FIXME|XXX)\b|\bissue\s+#?\d|\bthis (?:session|issue|ticket)\b|\bshared/\w", re.IGNORECASE
)

Documented = Function | ast.ClassDef


def code_lines(function: Function, lines: list[str]) -> int:
    """Lines of a function that hold code: no docstring, no comment, no blank."""
    documented = ast.get_docstring(function) is not None
    body_start = (function.body[0].end_lineno or 0) + 1 if documented else function.body[0].lineno
    header = range(function.lineno, function.body[0].lineno)
    body = range(body_start, (function.end_lineno or 0) + 1)
    texts = [lines[number - 1].strip() for number in (*header, *body)]
    return sum(1 for text in texts if text and not text.startswith("#"))


def public_definitions(path: Path) -> list[Documented]:
    """A file's public functions and classes, and the public methods of its public classes."""
    found: list[Documented] = []
    waiting = list(tree(path).body)
    while waiting:
        node = waiting.pop()
        if isinstance(node, Documented) and not node.name.startswith("_"):
            found.append(node)
            if isinstance(node, ast.ClassDef):
                waiting += node.body
    return [node for node in found if not _is_overload(node)]


def _is_overload(node: Documented) -> bool:
    """Whether a definition only tells types, or is a property's setter, whose getter is documented."""
    decorators = [ast.unparse(decorator) for decorator in node.decorator_list]
    return any(text == "overload" or text.endswith(".setter") for text in decorators)


def text_files() -> list[Path]:
    """Every text of the project but this file, which quotes what it forbids."""
    rooms = [
        path
        for room in ("src", "tests", "benchmarks", "docs", "examples", ".ci", ".github")
        for path in (ROOT / room).rglob("*")
    ]
    texts = [path for path in (*ROOT.iterdir(), *rooms) if path.suffix in TEXT_ENDINGS or path.parent.name == ".ci"]
    return sorted(path for path in texts if path.is_file() and path != Path(__file__))


@pytest.mark.parametrize("path", python_files(), ids=named)
def test_files_and_functions_are_short(path: Path) -> None:
    lines = path.read_text(encoding="utf-8").splitlines()
    assert len(lines) <= LONGEST_FILE
    lengths = {function.name: code_lines(function, lines) for function in functions(path)}
    assert {name: length for name, length in lengths.items() if length > LONGEST_FUNCTION} == {}


@pytest.mark.parametrize("path", package_files(), ids=named)
def test_public_names_are_documented_by_a_sentence(path: Path) -> None:
    first_lines = {node.name: (ast.get_docstring(node) or "").partition("\n")[0] for node in public_definitions(path)}
    assert {name: line for name, line in first_lines.items() if not line.endswith(".")} == {}


@pytest.mark.parametrize("path", kernel_files(), ids=named)
def test_a_kernel_that_may_miss_says_so_itself_or_through_its_module(path: Path) -> None:
    module_says = "None" in (ast.get_docstring(tree(path)) or "")
    silent = [
        function.name
        for function in functions(path)
        if function.returns is not None and ast.unparse(function.returns).endswith("| None")
        if not module_says and "None" not in (ast.get_docstring(function) or "")
    ]
    assert silent == []


@pytest.mark.parametrize("path", package_files(), ids=named)
def test_no_name_starts_with_get(path: Path) -> None:
    assert [function.name for function in functions(path) if re.match("_?get_", function.name)] == []


@pytest.mark.parametrize("path", python_files(), ids=named)
def test_every_file_says_what_it_is(path: Path) -> None:
    assert (ast.get_docstring(tree(path)) or "").partition("\n")[0].endswith(".")


@pytest.mark.parametrize("path", text_files(), ids=named)
def test_texts_speak_of_the_project_alone(path: Path) -> None:
    text = path.read_text(encoding="utf-8")
    assert MACHINE_PATH.findall(text) == []
    assert WORKING_NOTE.findall(text) == []


def test_a_long_function_is_seen() -> None:
    text = "def long() -> None:\n" + '    """One.\n\n    Two.\n    """\n' + "    # reason\n\n" + "    x = 1\n" * 61
    function = next(node for node in ast.walk(ast.parse(text)) if isinstance(node, ast.FunctionDef))
    assert code_lines(function, text.splitlines()) == 62


@pytest.mark.parametrize("text", ["see /home/someone/x", "/tmp/plan", "TODO later", "as issue 12 asks", "shared/spec"])
def test_a_foreign_word_is_seen(text: str) -> None:
    assert MACHINE_PATH.search(text) or WORKING_NOTE.search(text)


@pytest.mark.parametrize("path", sorted((PACKAGE / "play").rglob("*.py")), ids=named)
def test_games_use_no_private_names_of_others(path: Path) -> None:
    own = {node.attr for node in ast.walk(tree(path)) if isinstance(node, ast.Attribute) and is_own(node.value)}
    others = [
        ast.unparse(node)
        for node in ast.walk(tree(path))
        if isinstance(node, ast.Attribute) and re.match(r"_(?!_)", node.attr) and not is_own(node.value)
    ]
    assert [name for name in others if name.rpartition(".")[2] not in own] == []


def is_own(node: ast.expr) -> bool:
    """Whether an expression is the object or the class whose method it stands in."""
    return isinstance(node, ast.Name) and node.id in {"self", "cls"}
