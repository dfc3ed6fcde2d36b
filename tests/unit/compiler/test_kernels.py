"""Which functions are kernels: all that stand in their rooms, and none that stands elsewhere."""

import inspect

from carom.compiler.kernels import KERNEL_ROOMS, kernel_functions, kernel_modules
from carom.geometry import vector
from carom.world.kernels.broad_phase.grid import cell_of
from tests.conventions.source_trees import PACKAGE, kernel_files


def test_every_module_of_a_room_of_kernels_is_one() -> None:
    modules = kernel_modules()
    assert len(set(modules)) == len(modules)
    files = {PACKAGE.parent.joinpath(*name.split(".")).with_suffix(".py") for name in modules}
    assert files == set(kernel_files())
    assert all(any(name.startswith(f"{room}.") for room in KERNEL_ROOMS) for name in modules)


def test_functions_are_those_of_the_modules_each_once() -> None:
    functions = kernel_functions()
    assert len(set(functions)) == len(functions)
    assert {vector.length, cell_of} <= set(functions)
    assert {function.__module__ for function in functions} <= set(kernel_modules())
    # What a module only imports is counted where it is written.
    assert [function.__module__ for function in functions if function.__name__ == "dot"] == ["carom.geometry.vector"]
    assert all(inspect.isfunction(function) for function in functions)
