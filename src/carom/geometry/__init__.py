"""Plain functions of floats that return floats, tuples or None: interpreted for single calls, compiled in a world.

Numba compiles these very functions, and the answers are the same bits. So they square by `x*x`, guard every division
and root, keep one type per variable, and unpack an optional tuple, never index it. A miss is None throughout.

Numbers that always travel together are one argument: a path (`path`), a shape's numbers (`figures`). A NamedTuple of
floats is taken apart by the compiler, so that it costs nothing.
"""
