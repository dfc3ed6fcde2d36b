"""Kernels as Numba compiles them to be called with the address of a `Block`: the arrays are rebuilt inside.

To unbox an array of records takes Numba a while, and a step takes more than a dozen of them; and code that
rebuilds them needs nothing of Numba when it runs. Imported only where Numba is there. Source: Numba's `carray`, which
does the same for one array.
"""

from __future__ import annotations

from typing import Any

from llvmlite import ir
from numba import types
from numba.core import cgutils
from numba.extending import intrinsic
from numba.np.arrayobj import make_array, populate_array

from carom.compiler.kernels import Kernel
from carom.rows.tables import LINE

#: The types of the arguments of each kernel that has been entered, by its name.
_kinds: dict[str, Any] = {}

#: What an entry is compiled for.
SIGNATURE = (types.int64,)


def note_kinds(function: Kernel, kinds: Any) -> None:
    """Have the entry of a kernel, when it is compiled, rebuild arguments of these types: a tuple type of Numba's."""
    _kinds[function.__name__] = kinds


def entered(function: Kernel) -> Kernel:
    """The function that calls a kernel with the arrays of the block at an address: see `note_kinds`.

    It has the kernel's own name, by which it is kept on disk and told of.
    """
    name = function.__name__

    def enter(address: int) -> Any:
        return function(*arguments_at(address, name))  # type: ignore[call-arg]

    enter.__name__ = enter.__qualname__ = name
    return enter


@intrinsic(prefer_literal=True)
def arguments_at(_typing: Any, address: Any, name: Any) -> Any:
    """The arrays whose places stand in the table at an address, as the kernel of that name takes them."""
    kinds = _kinds[name.literal_value]

    def generate(context: Any, builder: Any, _signature: Any, arguments: Any) -> Any:
        words = Words(context, builder, arguments[0])
        return argument_of(context, builder, kinds, words)

    return kinds(address, name), generate


@intrinsic
def _called(_typing: Any, function: Any, block: Any) -> Any:
    """What the function at an address returns, which takes one word and returns one, as C functions do."""

    def generate(context: Any, builder: Any, _signature: Any, arguments: Any) -> Any:
        word = context.get_value_type(types.int64)
        pointer = builder.inttoptr(arguments[0], ir.FunctionType(word, [word]).as_pointer())
        return builder.call(pointer, [arguments[1]])

    return types.int64(function, block), generate


def called(function: Any, block: Any) -> Any:  # noqa: ARG001  # Numba compares the signatures
    """How Numba is to understand `call_at`, of which the interpreter sees a stand-in."""

    def call(function: Any, block: Any) -> Any:
        return _called(function, block)  # type: ignore[call-arg]

    return call


def _fetch(context: Any, builder: Any, signature: Any, arguments: Any) -> Any:
    """Generate code that tells the processor to have a line of an item at hand."""
    array = make_array(signature.args[0])(context, builder, arguments[0])  # type: ignore[no-untyped-call]
    flag, byte = ir.IntType(32), ir.IntType(8).as_pointer()
    kind = ir.FunctionType(ir.VoidType(), [byte, flag, flag, flag])
    fetch = builder.module.declare_intrinsic("llvm.prefetch", [byte], kind)
    item = builder.bitcast(builder.gep(array.data, [arguments[1]]), byte)
    place = builder.gep(item, [builder.mul(arguments[2], arguments[2].type(LINE))])
    # To be read, kept in all caches, of data.
    builder.call(fetch, [place, flag(0), flag(3), flag(1)])
    return context.get_dummy_value()


@intrinsic
def _line_prefetched(_typing: Any, table: Any, place: Any, line: Any) -> Any:
    """The processor is told to have a cache line of an item at hand, one of those after the line in which it begins."""
    return types.none(table, place, line), _fetch


def prefetched(table: Any, place: Any) -> Any:  # noqa: ARG001  # as above
    """How Numba is to understand `prefetch`, which does nothing where it is interpreted."""

    def prefetch(table: Any, place: Any) -> Any:
        _line_prefetched(table, place, 0)  # type: ignore[call-arg]

    return prefetch


def lines_prefetched(table: Any, place: Any, count: Any) -> Any:  # noqa: ARG001  # as above
    """How Numba is to understand `prefetch_lines`."""

    def prefetch_lines(table: Any, place: Any, count: Any) -> Any:
        for line in range(count):
            _line_prefetched(table, place, line)  # type: ignore[call-arg]

    return prefetch_lines


class Words:
    """64-bit words, one after the other, as generated code reads them."""

    def __init__(self, context: Any, builder: Any, address: Any) -> None:
        self._context = context
        self._builder = builder
        self._table = builder.inttoptr(address, context.get_value_type(types.intp).as_pointer())
        self._read = 0

    def next(self) -> Any:
        """The next word."""
        place = cgutils.gep_inbounds(self._builder, self._table, self._read)  # type: ignore[no-untyped-call]
        self._read += 1
        return self._builder.load(place)

    def follow(self) -> Words:
        """The words at the address that is the next word."""
        return Words(self._context, self._builder, self.next())


def argument_of(context: Any, builder: Any, kind: Any, words: Words) -> Any:
    """The argument whose word comes next, or the tuple of those whose words do, by its type."""
    if hasattr(kind, "types"):
        parts = [argument_of(context, builder, each, words) for each in kind.types]
        return context.make_tuple(builder, kind, parts)
    if kind == types.boolean:
        return builder.trunc(words.next(), context.get_value_type(kind))
    # See `carom.compiler.block.HEADER`.
    fields = words.follow()
    data, _dimensions, lengths = fields.next(), fields.next(), fields.follow()
    array = make_array(kind)(context, builder)  # type: ignore[no-untyped-call]
    shape = [lengths.next() for _ in range(kind.ndim)]
    size = context.get_constant(types.intp, context.get_abi_sizeof(context.get_data_type(kind.dtype)))
    strides = [size]
    for length in reversed(shape[1:]):
        strides.insert(0, builder.mul(strides[0], length))
    place = builder.inttoptr(data, context.get_data_type(kind.dtype).as_pointer())
    populate_array(  # type: ignore[no-untyped-call]
        array, data=place, shape=shape, strides=strides, itemsize=size, meminfo=None
    )
    return array._getvalue()
