"""Compiling the kernels: the one place that knows Numba."""
