"""Where a scene comes from: a file, or the scenes that are shipped."""

from __future__ import annotations

import inspect
from collections.abc import Callable
from dataclasses import dataclass
from difflib import get_close_matches
from pathlib import Path

from carom.cli.mistakes import Mistake
from carom.scene import Scene, scenes


@dataclass(frozen=True, slots=True)
class Source:
    """A scene that was found: its name, a line about it, the file it is in (None: shipped), and how to make it."""

    name: str
    about: str
    path: Path | None
    scene: Callable[[], Scene]

    @property
    def title(self) -> str:
        """The name as a heading."""
        return self.name if self.path is not None else self.name.replace("_", " ").capitalize()

    @property
    def picture(self) -> Path:
        """The file for a picture of the scene where none is named: in the current folder."""
        return Path(f"{self.name if self.path is None else self.path.stem}.svg")


def shipped() -> tuple[Source, ...]:
    """The scenes that are shipped, in the order of their names."""
    return tuple(
        Source(name, about(getattr(scenes, name)), None, getattr(scenes, name)) for name in sorted(scenes.__all__)
    )


def about(make: Callable[..., Scene]) -> str:
    """The first line of a function's docstring, without marks of code."""
    return (inspect.getdoc(make) or "").partition("\n")[0].replace("`", "")


def find(text: str) -> Source:
    """The scene that `text` means: a shipped one's name, else a file; raises `Mistake` where it is neither."""
    by_name = {source.name: source for source in shipped()}
    if text in by_name:
        return by_name[text]
    path = Path(text)
    if path.is_file():
        scene = Scene.load(path)
        return Source(scene.name or path.stem, "", path, lambda: scene)
    if path.is_dir():
        raise Mistake(f"{text}: is a folder, not a scene file")
    near = get_close_matches(text, by_name, n=1)
    hint = f"did you mean {near[0]}?" if near else f"shipped are {', '.join(by_name)}"
    raise Mistake(f"{text}: no such file, and no shipped scene of that name; {hint}")
