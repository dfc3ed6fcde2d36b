"""How fast carom is, beside its peers where they are installed: `python -m benchmarks`."""

import os

# What is measured is compiled before any clock runs, except where starting up is what is measured.
os.environ.setdefault("CAROM_COMPILE", "wait")
