"""What `import carom` gives, and what it does not load."""

import subprocess
import sys

import pytest

import carom

SLOW = ("numba", "pydantic", "pygame", "pyarrow", "typer", "rich", "gymnasium", "dask", "distributed", "fsspec")


def test_importing_carom_loads_no_slow_module() -> None:
    program = f"import sys, carom; carom.Segment, carom.guard_points; print([m for m in {SLOW} if m in sys.modules])"
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "[]"


def test_importing_carom_loads_nothing_that_only_few_programs_need() -> None:
    program = "import sys, numpy; had = set(sys.modules); import carom; print(*set(sys.modules) - had)"
    loaded = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True).stdout.split()
    assert "carom.shapes.segment" in loaded
    assert not {"bisect", "carom.shapes.covering", "carom.shapes.guard", "difflib", "threading"} & set(loaded)


def test_every_public_name_exists() -> None:
    assert sorted(carom.__all__) == list(carom.__all__)
    for name in carom.__all__:
        assert getattr(carom, name) is not None
        assert name in dir(carom)


@pytest.mark.slow
def test_pictures_and_studies_need_no_import_of_their_own() -> None:
    program = (
        "import sys, carom; before = set(sys.modules)\n"
        "assert not {'carom.draw', 'carom.study'} & before\n"
        "print(carom.draw.svg.__name__, carom.draw.Film.__name__, carom.study.plots.energy.__name__)\n"
        "assert carom.draw is sys.modules['carom.draw'] and 'matplotlib' not in sys.modules"
    )
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "svg Film energy"


def test_only_public_names_are_listed() -> None:
    assert dir(carom) == sorted(carom.__all__)


def test_an_unknown_name_is_an_attribute_error() -> None:
    with pytest.raises(AttributeError, match="module 'carom' has no attribute 'Sphere'"):
        _ = carom.Sphere


def test_bad_input_is_a_value_error_and_a_carom_error() -> None:
    family = (carom.InvalidArgument, carom.SceneError, carom.SnapshotError, carom.RecordingError, carom.NonFiniteState)
    for error in family:
        assert issubclass(error, ValueError)
        assert issubclass(error, carom.CaromError)


def test_what_is_public_says_what_it_is() -> None:
    for name in carom.__all__:
        assert getattr(carom, name).__doc__, name
