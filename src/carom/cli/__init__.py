"""The command line: `carom run`, `show`, `check`, `scenes`, `sweep`."""

from carom.cli.app import main

__all__ = ["main"]
