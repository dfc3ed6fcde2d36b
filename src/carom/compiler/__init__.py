"""Compiling the kernels: which they are, the one door to Numba, the cache on disk, and what the user is told."""
