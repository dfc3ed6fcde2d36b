"""Kernels keep to the Python that Numba compiles to the very same bits, and one module alone imports Numba."""

import ast
from collections.abc import Iterator
from functools import cache
from pathlib import Path

import pytest

from tests.conventions.source_trees import (
    COMPILER_DOORS,
    check_each,
    functions,
    kernel_files,
    named,
    package_files,
    tree,
)

MATH = {"atan2", "ceil", "copysign", "cos", "fabs", "floor", "inf", "isfinite", "pi", "sin", "sqrt"}
FORBIDDEN_NAMES = {
    "dict",
    "eval",
    "exec",
    "fastmath",
    "frozenset",
    "hypot",
    "parallel",
    "pow",
    "print",
    "prange",
    "set",
    "sum",
}
FORBIDDEN_NODES = {
    ast.Assert: "assert",
    ast.AsyncFunctionDef: "async",
    ast.Await: "await",
    ast.ClassDef: "a class",
    ast.Delete: "del",
    ast.Dict: "a dict",
    ast.DictComp: "a dict",
    ast.GeneratorExp: "a generator",
    ast.Global: "global",
    ast.Lambda: "lambda",
    ast.ListComp: "a list",
    ast.List: "a list",
    ast.Nonlocal: "nonlocal",
    ast.Raise: "raise",
    ast.Set: "a set",
    ast.SetComp: "a set",
    ast.Try: "try",
    ast.With: "with",
    ast.Yield: "yield",
}
#: What a room of kernels may hold besides functions: the dtypes of rows, and the types of rows and of groups of floats.
DATA_CLASSES = {"IntEnum", "NamedTuple", "Protocol", "TypedDict"}
DATA_CALLS = ("np.dtype(", "dtype_of(", "Annotated[")
DATA_MODULES = {"enum", "numpy", "numpy.typing", "typing"}
MOST_ARGUMENTS = 10
FORBIDDEN_OPERATORS = {ast.Pow: "**", ast.MatMult: "@"}


def is_data(node: ast.stmt) -> bool:
    """Whether a statement of a module defines what rows are, or imports what that needs; it is never compiled."""
    if isinstance(node, ast.ClassDef):
        return any(ast.unparse(base).partition("[")[0] in {*DATA_CLASSES, "CourseRow"} for base in node.bases)
    if isinstance(node, ast.Assign):
        return ast.unparse(node.value).startswith(DATA_CALLS)
    if isinstance(node, ast.FunctionDef):  # what makes a dtype
        return node.returns is not None and ast.unparse(node.returns).startswith("np.dtype[")
    if isinstance(node, ast.Import):
        return {alias.name for alias in node.names} <= DATA_MODULES
    return isinstance(node, ast.ImportFrom) and node.module in DATA_MODULES


@cache
def groups() -> dict[str, set[str]]:
    """The fields of each group of numbers that kernels hand on as one argument, by its name."""
    return {
        node.name: {ast.unparse(part.target) for part in node.body if isinstance(part, ast.AnnAssign)}
        for path in kernel_files()
        for node in tree(path).body
        if isinstance(node, ast.ClassDef) and [ast.unparse(base) for base in node.bases] == ["NamedTuple"]
    }


def fields_read(function: ast.FunctionDef) -> Iterator[ast.Attribute]:
    """The attributes in a function that are fields of its arguments: what else has some is no number."""
    given = {argument.arg: ast.unparse(argument.annotation or ast.Constant(None)) for argument in function.args.args}
    for node in ast.walk(function):
        if isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name):
            group = given.get(node.value.id, "")
            if isinstance(node.ctx, ast.Load) and node.attr in groups().get(group, set()):
                yield node


def refusals(module: ast.Module) -> list[str]:
    """What a kernel module does that it must not, each with its line."""
    module = ast.Module([node for node in module.body if not is_data(node)], [])
    fields = [node for part in module.body if isinstance(part, ast.FunctionDef) for node in fields_read(part)]
    found = [(node, text) for node in ast.walk(module) if node not in fields for text in _faults(node)]
    found += [
        (inner, "a nested function")
        for outer in ast.walk(module)
        if isinstance(outer, ast.FunctionDef)
        for inner in ast.walk(outer)
        if inner is not outer and isinstance(inner, ast.FunctionDef)
    ]
    return [f"line {getattr(node, 'lineno', '?')}: {text}" for node, text in found]


def _faults(node: ast.AST) -> Iterator[str]:
    """What is wrong with one node."""
    if type(node) in FORBIDDEN_NODES:
        yield FORBIDDEN_NODES[type(node)]
    elif isinstance(node, ast.BinOp | ast.AugAssign) and type(node.op) in FORBIDDEN_OPERATORS:
        yield FORBIDDEN_OPERATORS[type(node.op)]
    elif isinstance(node, ast.Name) and node.id in FORBIDDEN_NAMES:
        yield node.id
    elif isinstance(node, ast.Attribute):
        yield f"the attribute .{node.attr}"
    elif isinstance(node, ast.Import):
        yield f"import {node.names[0].name}"
    elif isinstance(node, ast.ImportFrom):
        yield from _import_faults(node)
    elif isinstance(node, ast.FunctionDef):
        yield from _signature_faults(node)


def _import_faults(node: ast.ImportFrom) -> Iterator[str]:
    """Imports from elsewhere than carom and the agreed part of `math`."""
    module = node.module or ""
    if module == "math":
        yield from (f"math.{alias.name}" for alias in node.names if alias.name not in MATH)
    elif module != "__future__" and module.partition(".")[0] != "carom":
        yield f"from {module}"


def _signature_faults(node: ast.FunctionDef) -> Iterator[str]:
    """Defaults, gathered arguments, decorators."""
    arguments = node.args
    if arguments.defaults or any(arguments.kw_defaults):
        yield f"{node.name} has a default argument"
    if arguments.vararg or arguments.kwarg or arguments.kwonlyargs:
        yield f"{node.name} gathers arguments or names them"
    if node.decorator_list:
        yield f"{node.name} is decorated"


def optional_functions() -> set[str]:
    """Names of the kernels that may return None."""
    return {
        function.name
        for path in kernel_files()
        for function in functions(path)
        if function.returns is not None and "None" in ast.unparse(function.returns).split(" | ")[1:]
    }


def indexed_results(function: ast.AST, optional: set[str]) -> list[str]:
    """Variables that hold an optional tuple and are indexed."""
    holders = {
        target.id
        for node in ast.walk(function)
        if isinstance(node, ast.Assign) and isinstance(node.value, ast.Call) and isinstance(node.value.func, ast.Name)
        if node.value.func.id in optional
        for target in node.targets
        if isinstance(target, ast.Name)
    }
    return [
        f"line {node.lineno}: {node.value.id}[...]"
        for node in ast.walk(function)
        if isinstance(node, ast.Subscript) and isinstance(node.value, ast.Name) and node.value.id in holders
    ]


def imports_numba(module: ast.Module) -> bool:
    """Whether a module imports Numba or its LLVM, anywhere in it."""
    names = [alias.name for node in ast.walk(module) if isinstance(node, ast.Import) for alias in node.names]
    names += [node.module or "" for node in ast.walk(module) if isinstance(node, ast.ImportFrom)]
    return any(name.partition(".")[0] in {"numba", "llvmlite"} for name in names)


def bare_arguments(path: Path) -> list[str]:
    """The arguments of a file's functions that have no annotation."""
    return [
        f"{function.name}({argument.arg})"
        for function in functions(path)
        for argument in function.args.args
        if argument.annotation is None and argument.arg != "self"
    ]


def test_a_kernel_module_uses_only_what_compiles_to_the_same_bits() -> None:
    check_each(kernel_files(), lambda path: refusals(tree(path)))


def test_a_kernel_unpacks_optional_results_and_never_indexes_them() -> None:
    optional = optional_functions()
    check_each(
        kernel_files(),
        lambda path: [text for function in functions(path) for text in indexed_results(function, optional)],
    )


def test_every_argument_of_a_kernel_is_annotated() -> None:
    check_each(kernel_files(), bare_arguments)


def many_arguments(path: Path) -> list[str]:
    """The functions of a file that take more than ten arguments."""
    return [function.name for function in functions(path) if len(function.args.args) > MOST_ARGUMENTS]


def test_no_function_of_geometry_takes_more_than_ten_arguments() -> None:
    check_each((path for path in kernel_files() if path.parent.name == "geometry"), many_arguments)


def test_the_compiler_is_imported_at_its_door_alone() -> None:
    assert [named(path) for path in package_files() if imports_numba(tree(path))] == list(map(named, COMPILER_DOORS))


def test_the_compiler_is_never_told_to_reorder_arithmetic() -> None:
    keywords = {node.arg for path in package_files() for node in ast.walk(tree(path)) if isinstance(node, ast.keyword)}
    assert keywords.isdisjoint({"fastmath", "parallel"})


@pytest.mark.parametrize(
    "line",
    [
        "return x**2",
        "return pow(x, 2.0)",
        "return hypot(x, x)",
        "return x @ x",
        "return np.dot(x, x)",
        "x **= 2.0",
        "raise ValueError",
        "assert x > 0.0",
        "return (lambda: x)()",
        "return max({x})",
        "return time.time()",
        "import random",
        "from math import hypot",
        "from random import random",
        "for key in {1: 2}:\n        x += key",
        "try:\n        return x\n    finally:\n        x = 0.0",
        "def inner() -> float:\n        return x\n    return inner()",
    ],
)
def test_the_refusals_refuse(line: str) -> None:
    assert refusals(ast.parse(f"def kernel(x: float) -> float:\n    {line}\n")) != []


@pytest.mark.parametrize("signature", ["x: float = 1.0", "*x: float", "**x: float", "*, x: float"])
def test_signatures_that_are_not_plain_are_refused(signature: str) -> None:
    assert refusals(ast.parse(f"def kernel({signature}) -> float:\n    return 1.0\n")) != []


def test_what_kernels_are_made_of_is_not_refused() -> None:
    text = "from math import sqrt\ndef kernel(x: float, y: float) -> float | None:\n    return sqrt(x * x + y * y)\n"
    assert refusals(ast.parse(text)) == []


def test_a_field_of_an_argument_may_be_read_and_no_other_attribute() -> None:
    text = "def kernel(path: Path, x: float) -> float:\n    {}\n    return x\n"
    assert refusals(ast.parse(text.format("x = path.gx"))) == []
    for line in ("x = path.spin", "x = x.gx", "path.gx = x", "x = other.gx", "x = path.count(x)", "x = path.gx.real"):
        assert refusals(ast.parse(text.format(line))) != []


def test_indexing_an_optional_result_is_found() -> None:
    text = "def kernel(x: float) -> float:\n    hit = miss(x)\n    return hit[0]\n"
    assert indexed_results(ast.parse(text), {"miss"}) == ["line 3: hit[0]".replace("0", "...")]


def test_every_constant_is_set_once() -> None:
    (constants,) = (path for path in package_files() if path.name == "constants.py")
    names = [
        ast.unparse(target) for node in tree(constants).body if isinstance(node, ast.Assign) for target in node.targets
    ]
    assert len(names) > 50
    assert len(names) == len(set(names))
