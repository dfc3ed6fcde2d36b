"""How fast carom is, beside its peers where they are installed: `python -m benchmarks`."""
