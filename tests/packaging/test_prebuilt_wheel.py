"""A wheel that brings kernels compiled along: for one platform, without Numba if it has all of them, and used."""

import importlib.util
import shutil
import sysconfig
from pathlib import Path
from types import ModuleType
from typing import Any
from zipfile import ZipFile

import pytest

import carom
from tests import fresh

BUILD = "import sys; from hatchling import build; print(getattr(build, sys.argv[1])(sys.argv[2]))"
#: Asks the width of a world, and prints it with the kernel's sort and whether Numba was loaded.
ASK = """
import sys
sys.modules["numba"] = None
from carom.compiler import door
from carom.compiler.block import Block
from carom.world.ahead import examples
from carom.world.kernels.queries.search_grid import width_of_all
(tables,) = (arguments for function, arguments in examples().items() if function is width_of_all)
kernel = door.enter(width_of_all)
print(kernel(Block(tables)), type(kernel).__name__, door.__file__)
"""


@pytest.fixture(scope="module")
def hooks() -> ModuleType:
    """The project's hooks into its build."""
    spec = importlib.util.spec_from_file_location("hatch_build", fresh.ROOT / "hatch_build.py")
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def built(what: str, folder: Path, prebuilt: str) -> Path:
    """What a build made, with `CAROM_PREBUILT` as given."""
    return folder / fresh.printed(BUILD, what, str(folder), CAROM_PREBUILT=prebuilt).split()[-1]


def metadata_of(wheel: ZipFile, name: str = "METADATA") -> str:
    """A file of a wheel's own folder."""
    return wheel.read(f"carom-{carom.__version__}.dist-info/{name}").decode()


@pytest.mark.slow
@pytest.mark.compiled
@pytest.mark.skipif(shutil.which("cc") is None, reason="needs a C compiler")
def test_a_wheel_brings_a_kernel_along_which_is_used_without_numba(tmp_path: Path) -> None:
    path = built("build_wheel", tmp_path, "width_of_all")
    assert path.name.startswith(f"carom-{carom.__version__}-py3-none-")
    assert path.stem.endswith(sysconfig.get_platform().replace("-", "_").replace(".", "_"))
    with ZipFile(path) as wheel:
        made = [name for name in wheel.namelist() if name.startswith("carom/compiler/machine_code/")]
        assert len(made) == 2
        assert "\nRequires-Dist: numba" in metadata_of(wheel), "the other kernels need it"
        assert "Root-Is-Purelib: false" in metadata_of(wheel, "WHEEL")
        wheel.extractall(tmp_path / "site")
    width, sort, place = fresh.printed(ASK, PYTHONPATH=str(tmp_path / "site"), NUMBA_DISABLE_JIT=None).split()
    assert (width, sort) == ("0.0", "At")
    assert Path(place).is_relative_to(tmp_path), "the sources of the checkout were not used"


@pytest.mark.parametrize(("prebuilt", "needed"), [("", True), ("width_of_all", True), ("all", False)])
def test_numba_is_needed_unless_all_kernels_come_compiled(
    prebuilt: str, needed: bool, hooks: ModuleType, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("CAROM_PREBUILT", prebuilt)
    metadata: dict[str, Any] = {"optional-dependencies": {"compile": ["numba>=0.60"]}}
    hooks.MetadataHook(str(fresh.ROOT), {"dependencies": ["numpy>=2.0"]}).update(metadata)
    assert ("numba>=0.60" in metadata["dependencies"]) is needed
    assert "numpy>=2.0" in metadata["dependencies"]


@pytest.mark.slow
@pytest.mark.parametrize("what", ["build_sdist", "build_editable"])
def test_only_a_wheel_brings_kernels_along(what: str, tmp_path: Path) -> None:
    done = fresh.run(BUILD, what, str(tmp_path), CAROM_PREBUILT="all")
    assert done.returncode == 1
    assert b"CAROM_PREBUILT is for wheels" in done.stderr
    assert list(tmp_path.iterdir()) == []


def test_a_build_of_a_wheel_asks_for_the_compiler_where_it_needs_it(
    hooks: ModuleType, monkeypatch: pytest.MonkeyPatch
) -> None:
    def needs(target: str) -> list[str]:
        hook = hooks.PrebuiltHook(str(fresh.ROOT), {}, None, None, "", target)
        needed: list[str] = hook.dependencies()
        return needed

    monkeypatch.setenv("CAROM_PREBUILT", "all")
    assert needs("wheel") == [hooks.BUILDING]
    assert needs("sdist") == []
    monkeypatch.delenv("CAROM_PREBUILT")
    assert needs("wheel") == []


def test_a_wheel_without_numba_is_not_made_of_a_source_distribution(
    hooks: ModuleType, monkeypatch: pytest.MonkeyPatch
) -> None:
    class Told:
        class core:  # noqa: N801  # hatchling's name
            dependencies = ("numba>=0.60",)

    monkeypatch.setenv("CAROM_PREBUILT", "all")
    hook = hooks.PrebuiltHook(str(fresh.ROOT), {}, None, Told, "", "wheel")
    with pytest.raises(ValueError, match="is for a checkout"):
        hook.initialize("standard", {})
