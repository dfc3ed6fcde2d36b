"""Fresh interpreters, for what must hold from process to process."""

import os
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]


def run(code: str, *arguments: str, **environment: str | None) -> subprocess.CompletedProcess[str]:
    """What a program did in a fresh interpreter; variables that are None are taken out of its environment."""
    variables = {name: value for name, value in {**os.environ, **environment}.items() if value is not None}
    return subprocess.run(
        [sys.executable, "-c", code, *arguments], cwd=ROOT, env=variables, capture_output=True, text=True, check=False
    )


def printed(code: str, *arguments: str, **environment: str | None) -> str:
    """What a program printed in a fresh interpreter; fails if it failed."""
    done = run(code, *arguments, **environment)
    assert done.returncode == 0, done.stderr
    return done.stdout
