"""Where a scene comes from: a file, or the scenes that are shipped."""

from __future__ import annotations

import inspect
import sys
import warnings
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

import typer

from carom.cli.mistakes import Mistake, meant
from carom.errors import DrawingWarning, LettersWarning
from carom.record import Recording
from carom.scene import Scene, scenes
from carom.scene.drawings.reading import is_drawing

#: The ending of recordings.
RECORDED = ".carom"
#: The endings of what can be a scene, and that is looked for where none is found.
SCENES = (".toml", ".json", ".svg", ".dxf", RECORDED)
#: The warnings that are said in a line.
TOLD = (DrawingWarning, LettersWarning)
#: The headings of shipped scenes whose names have no room for all of it.
TITLES = {"newtons_cradle": "Newton's cradle"}


@dataclass(frozen=True, slots=True)
class Source:
    """A scene that was found, or a recording of a run."""

    name: str
    about: str
    path: Path | None  # of the file it is in; None: shipped
    scene: Callable[[], Scene]
    recording: Recording | None = None

    @property
    def title(self) -> str:
        """The name as a heading."""
        if self.path is not None:
            return self.name
        return TITLES.get(self.name, self.name.replace("_", " ").capitalize())

    @property
    def picture(self) -> Path:
        """The file for a picture of the scene where none is named: in the current folder."""
        if self.path is None:
            return Path(f"{self.name}.svg")
        # The picture of a drawing must not take its place.
        return Path(f"{self.path.stem}{'-picture' if is_drawing(self.path) else ''}.svg")


@contextmanager
def warnings_told() -> Iterator[None]:
    """A while in which what drawings and pictures are without is said on stderr, in a line each."""
    with warnings.catch_warnings(record=True) as caught:
        for category in TOLD:
            warnings.simplefilter("always", category)
        yield
    for warning in caught:
        if issubclass(warning.category, TOLD):
            typer.echo(f"carom: {warning.message}", err=True)
        else:
            warnings.warn_explicit(warning.message, warning.category, warning.filename, warning.lineno)


def shipped() -> tuple[Source, ...]:
    """The scenes that are shipped, in the order of their names."""
    return tuple(
        Source(name, about(getattr(scenes, name)), None, getattr(scenes, name)) for name in sorted(scenes.__all__)
    )


def about(make: Callable[..., Scene]) -> str:
    """The first line that is said of a shipped scene: by its module, if that has its name, else by its function."""
    module = sys.modules[make.__module__]
    teller = module if module.__name__.endswith(f".{make.__name__}") else make
    return (inspect.getdoc(teller) or "").partition("\n")[0]


def find(text: str) -> Source:
    """The scene that `text` means: a shipped one's name, else a file; raises `Mistake` where it is neither."""
    by_name = {source.name: source for source in shipped()}
    if text in by_name:
        return by_name[text]
    if not text:
        raise Mistake(f"the name of a scene must not be empty; shipped are {', '.join(by_name)}")
    path = Path(text)
    try:
        is_file, is_folder, is_there = path.is_file(), path.is_dir(), path.exists()
    except OSError as error:
        raise Mistake(f"{text}: cannot be read: {error.strerror}") from None
    if is_file and path.suffix.lower() == RECORDED:
        recording = Recording.load(path)
        return Source(recording.name or path.stem, recording.about, path, lambda: recording.scene, recording)
    if is_file:
        with warnings_told():
            scene = Scene.load(path)
        return Source(scene.name or path.stem, "", path, lambda: scene)
    if is_folder:
        raise Mistake(f"{text}: is a folder, not a scene file")
    if is_there:
        raise Mistake(f"{text}: is a device or the like, not a scene file")
    hint = meant(text, [*by_name, *files_beside(path)]) or f"shipped are {', '.join(by_name)}"
    raise Mistake(f"{text}: no such file, and no shipped scene of that name; {hint}")


def files_beside(path: Path) -> list[str]:
    """The scene files, drawings and recordings in the folder of a path that is not there, as they would be given."""
    try:
        names = sorted(path.parent.iterdir())
    except OSError:
        return []
    return [str(name) for name in names if name.suffix.lower() in SCENES]
