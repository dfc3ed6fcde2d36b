"""Functions by name: what other processes can import, and what they cannot."""

import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

import carom
from carom.study import measures
from carom.study.sweeps.references import function_of, is_reference, reference_of, refuse_while_importing, source_text
from tests.sweeping import told


def nested() -> Any:
    """A function that nobody can import."""

    def inner() -> None:
        pass

    return inner


def test_a_function_is_named_by_its_module() -> None:
    assert reference_of("measure", told) == "tests.sweeping:told"
    assert reference_of("measure", "tests.sweeping:told") == "tests.sweeping:told"
    assert function_of("tests.sweeping:told") is told
    assert function_of(reference_of("measure", measures.energy)) is measures.energy
    assert source_text("tests.sweeping:told").startswith("def told(")
    assert source_text("math:sqrt") == ""
    assert is_reference("a.b:c.d")
    assert not is_reference("table.toml")


@pytest.mark.parametrize(
    ("given", "words"),
    [
        (lambda: 0, "measure must be a function at the top of a module"),
        (nested(), "measure must be a function at the top of a module"),
        (3, "measure must be a function that can be imported, .* not 3"),
        ("no.such.module:f", "measure no.such.module:f cannot be imported: No module named 'no'"),
        ("tests.sweeping:nothing", "measure tests.sweeping:nothing cannot be imported: .*nothing"),
        ("tests.sweeping:SECONDS", "measure tests.sweeping:SECONDS cannot be imported: it is a float"),
        ("a b:c", "measure must be a function at the top of a module"),
    ],
)
def test_what_cannot_be_imported_is_refused_by_name(given: Any, words: str) -> None:
    with pytest.raises(carom.InvalidArgument, match=words):
        reference_of("measure", given)


PROGRAM = """
from carom.study.sweeps.references import reference_of, refuse_while_importing

def measure(world, hits, parameters):
    return {}

def work():
    refuse_while_importing()
    print(reference_of("measure", measure))

"""


@pytest.mark.slow
def test_a_program_s_own_function_is_imported_by_the_program_s_name(tmp_path: Path) -> None:
    program = tmp_path / "study_of_mine.py"
    program.write_text(PROGRAM + 'if __name__ == "__main__":\n    work()\n')
    done = subprocess.run([sys.executable, program], capture_output=True, text=True, check=True)
    assert done.stdout == "study_of_mine:measure\n"
    program.write_text(PROGRAM + "work()\n")
    done = subprocess.run([sys.executable, program], capture_output=True, text=True, check=False)
    assert "put the call below if __name__ == '__main__'" in done.stderr.splitlines()[-1]


def test_nothing_is_refused_while_nothing_is_imported() -> None:
    refuse_while_importing()
