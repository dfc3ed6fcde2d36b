"""What the build makes of this project: its description and dependencies, and code compiled for one platform.

`CAROM_PREBUILT=all` has a wheel bring its kernels compiled along, so that it does not depend on the compiler. With the
names of some kernels, separated by commas, it brings those alone, and depends on the compiler as any other wheel.
"""

from __future__ import annotations

import atexit
import os
import re
import shutil
import subprocess
import sys
import sysconfig
import tempfile
from pathlib import Path
from platform import machine
from typing import Any

from hatchling.builders.hooks.plugin.interface import BuildHookInterface
from hatchling.metadata.plugin.interface import MetadataHookInterface

#: The variable that has kernels compiled, and what it says for all of them.
VARIABLE, ALL = "CAROM_PREBUILT", "all"
#: What Numba's compiler has to have besides what a compiler needs in use: one kind of pointers, passes over a module.
BUILDING = "numba>=0.62"
#: Makes the library of kernels, in a folder.
BUILD = "import sys; from carom.world.ahead import prebuild; prebuild(*sys.argv[1:])"
#: Where it lies in the package.
PLACE = "carom/compiler/machine_code"

#: A picture on a line of its own, and a link, with a path in this repository each.
PICTURE = re.compile(r"^!\[[^\]]*\]\((?!\w+:)[^)]+\)\n\n?", re.MULTILINE)
LINK = re.compile(r"\[([^\]]+)\]\((?!\w+:|#)([^)]+)\)")
#: The heading of the list of pages, and what stands below it where they cannot be followed.
PAGES, WHERE = "## Read on\n", "\nThese pages come with the source distribution.\n"


class MetadataHook(MetadataHookInterface):
    """Makes the long description, and says what is needed."""

    def update(self, metadata: dict[str, Any]) -> None:
        """Add the description and the dependencies to the metadata."""
        text = (Path(self.root) / "README.md").read_text(encoding="utf-8")
        metadata["readme"] = {"content-type": "text/markdown", "text": description(text)}
        compiler = [] if prebuilt() == ALL else metadata["optional-dependencies"]["compile"]
        metadata["dependencies"] = sorted([*self.config["dependencies"], *compiler])


class PrebuiltHook(BuildHookInterface):  # type: ignore[type-arg]
    """Adds the library of compiled kernels to a wheel, which is then for this platform."""

    def dependencies(self) -> list[str]:
        """What the build needs besides hatchling."""
        return [BUILDING] if prebuilt() and self.target_name == "wheel" else []

    def initialize(self, version: str, build_data: dict[str, Any]) -> None:
        """Compile, and tell hatchling what was made."""
        if not prebuilt():
            return
        if self.target_name != "wheel" or version == "editable":
            raise ValueError(f"{VARIABLE} is for wheels: source distributions and editable installs go without")
        if prebuilt() == ALL and any(name.startswith("numba") for name in self.metadata.core.dependencies):
            raise ValueError(f"{VARIABLE}={ALL} is for a checkout: a source distribution says what it depends on")
        folder = tempfile.mkdtemp()
        atexit.register(shutil.rmtree, folder)
        names = [] if prebuilt() == ALL else prebuilt().split(",")
        path = os.pathsep.join([str(Path(self.root) / "src"), *sys.path])
        command = [sys.executable, "-c", BUILD, folder, *names]
        subprocess.run(command, check=True, env=os.environ | {"PYTHONPATH": path})
        build_data["force_include"][folder] = PLACE
        build_data["pure_python"] = False
        build_data["tag"] = f"py3-none-{platform()}"


def prebuilt() -> str:
    """What is to be compiled ahead: `ALL`, names of kernels, or nothing."""
    return os.environ.get(VARIABLE, "")


def platform() -> str:
    """The platform that code compiled here runs on, as a wheel's tag says it."""
    # A Python for both kinds of Mac compiles for the one that it runs on.
    return re.sub(r"[-.]", "_", sysconfig.get_platform().replace("universal2", machine()))


def description(readme: str) -> str:
    """A README without pictures that lie beside it, and with the paths of pages in place of links to them."""
    text = LINK.sub(r"\1 (`\2`)", PICTURE.sub("", readme))
    return text.replace(PAGES, PAGES + WHERE)
