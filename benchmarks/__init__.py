"""How fast carom is, beside its peers where they are installed: `python -m benchmarks`."""

import os

# What is measured is compiled before any clock runs; where starting up is measured, the clock runs meanwhile.
os.environ.setdefault("CAROM_COMPILE", "wait")
