"""The house rules that a machine can hold: sizes, docstrings, names, and texts that speak of the project alone."""

import ast
import re
from collections.abc import Iterator
from pathlib import Path

import pytest

from tests.conventions.source_trees import (
    PACKAGE,
    ROOT,
    Function,
    check_each,
    functions,
    kernel_files,
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


def too_long(path: Path) -> Iterator[str]:
    """How long a file is and each of its functions, where that is too much."""
    lines = path.read_text(encoding="utf-8").splitlines()
    if len(lines) > LONGEST_FILE:
        yield f"{len(lines)} lines"
    for function in functions(path):
        if code_lines(function, lines) > LONGEST_FUNCTION:
            yield f"{function.name} has {code_lines(function, lines)} lines of code"


def undocumented(path: Path) -> list[str]:
    """The public names of a file that no sentence tells of."""
    return [node.name for node in public_definitions(path) if not opens_with_a_sentence(node)]


def opens_with_a_sentence(node: Documented | ast.Module) -> bool:
    """Whether a docstring's first line is a sentence."""
    return (ast.get_docstring(node) or "").partition("\n")[0].endswith(".")


def silent_on_misses(path: Path) -> list[str]:
    """The kernels of a file that may miss, where neither they nor the module say so."""
    if "None" in (ast.get_docstring(tree(path)) or ""):
        return []
    return [
        function.name
        for function in functions(path)
        if function.returns is not None and ast.unparse(function.returns).endswith("| None")
        if "None" not in (ast.get_docstring(function) or "")
    ]


def foreign_words(path: Path) -> list[str]:
    """What a text says of a machine, or of how the work was done."""
    text = path.read_text(encoding="utf-8")
    return [found.group() for pattern in (MACHINE_PATH, WORKING_NOTE) for found in pattern.finditer(text)]


def private_names_of_others(path: Path) -> list[str]:
    """The private names that a file uses of anything but the object or the class whose method it stands in."""
    attributes = [node for node in ast.walk(tree(path)) if isinstance(node, ast.Attribute)]
    own = {node.attr for node in attributes if is_own(node.value)}
    return [
        ast.unparse(node)
        for node in attributes
        if re.match(r"_(?!_)", node.attr) and not is_own(node.value) and node.attr not in own
    ]


def is_own(node: ast.expr) -> bool:
    """Whether an expression is the object or the class whose method it stands in."""
    return isinstance(node, ast.Name) and node.id in {"self", "cls"}


def test_files_and_functions_are_short() -> None:
    check_each(python_files(), too_long)


def test_public_names_are_documented_by_a_sentence() -> None:
    check_each(package_files(), undocumented)


def test_a_kernel_that_may_miss_says_so_itself_or_through_its_module() -> None:
    check_each(kernel_files(), silent_on_misses)


def test_no_name_starts_with_get() -> None:
    check_each(package_files(), lambda path: [one.name for one in functions(path) if re.match("_?get_", one.name)])


def test_every_file_says_what_it_is() -> None:
    check_each(python_files(), lambda path: [] if opens_with_a_sentence(tree(path)) else ["no sentence at its top"])


def test_texts_speak_of_the_project_alone() -> None:
    check_each(text_files(), foreign_words)


def test_games_use_no_private_names_of_others() -> None:
    check_each(sorted((PACKAGE / "play").rglob("*.py")), private_names_of_others)


def test_a_long_function_is_seen() -> None:
    text = "def long() -> None:\n" + '    """One.\n\n    Two.\n    """\n' + "    # reason\n\n" + "    x = 1\n" * 61
    function = next(node for node in ast.walk(ast.parse(text)) if isinstance(node, ast.FunctionDef))
    assert code_lines(function, text.splitlines()) == 62


@pytest.mark.parametrize("text", ["see /home/someone/x", "/tmp/plan", "TODO later", "as issue 12 asks", "shared/spec"])
def test_a_foreign_word_is_seen(text: str) -> None:
    assert MACHINE_PATH.search(text) or WORKING_NOTE.search(text)
