"""The rows that shapes, balls and a world's state live in: NumPy dtypes, each with its row's type, and poses.

A shape is a row: a lone shape owns a table of one row, and a shape in a world owns a row of the world's table. The
kernels see the same rows, so there is one truth and nothing to keep in step. No dtype has padding, so the bytes of a
row are its state and nothing else. Fields that the hot loops read stand first.
"""
