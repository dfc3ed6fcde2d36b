"""What a command prints, and how it exits."""

import pytest

from carom.cli import main


def carom_says(capsys: pytest.CaptureFixture[str], *arguments: str) -> tuple[int, str, str]:
    """Exit status, stdout and stderr of a command, without what the first run on a machine says of compiling."""
    with pytest.raises(SystemExit) as caught:
        main(list(arguments))
    printed = capsys.readouterr()
    told = [
        line
        for line in printed.err.splitlines(keepends=True)
        if not line.startswith(("carom: compiling ", "carom: compiled "))
    ]
    return int(caught.value.code or 0), printed.out, "".join(told)
