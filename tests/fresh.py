"""Fresh interpreters, for what must hold from process to process."""

import os
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]


def variables(**changes: str | None) -> dict[str, str]:
    """The variables of this process with some changes; those that are None are taken out."""
    return {name: value for name, value in {**os.environ, **changes}.items() if value is not None}


def run(
    code: str, *arguments: str, given: bytes | None = None, **environment: str | None
) -> subprocess.CompletedProcess[bytes]:
    """What a program did in a fresh interpreter, given bytes to read, with some `variables` changed."""
    command = [sys.executable, "-c", code, *arguments]
    return subprocess.run(
        command, cwd=ROOT, env=variables(**environment), input=given, capture_output=True, check=False
    )


def printed(code: str, *arguments: str, given: bytes | None = None, **environment: str | None) -> str:
    """What a program printed in a fresh interpreter; fails if it failed."""
    done = run(code, *arguments, given=given, **environment)
    assert done.returncode == 0, done.stderr.decode()
    return done.stdout.decode()
