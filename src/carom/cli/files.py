"""The files that commands write, by their endings: what each needs of a run, and how it is made."""

from __future__ import annotations

from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

import typer

from carom import draw
from carom.cli import outputs, report
from carom.cli.hits_file import write_hits, write_hits_table
from carom.cli.sources import warnings_told
from carom.draw.film.movie import encoder
from carom.draw.page.page import replay_page
from carom.errors import CaromError
from carom.extras import needed
from carom.record.files import recording_bytes
from carom.record.members import names_in
from carom.scene import Scene

if TYPE_CHECKING:
    from collections.abc import Callable, Collection, Iterator, Mapping, Sequence

    from carom.cli.running import Outcome
    from carom.cli.sources import Source
    from carom.cli.view import View
    from carom.draw import Picture
    from carom.record import Recording
    from carom.world.world import World

    #: How the file of an ending is written.
    Writers = Mapping[str, Callable[[Path], None]]

SVG, PNG, GIF, MP4, PAGE, RUN, STATE = ".svg", ".png", ".gif", ".mp4", ".html", ".carom", ".toml"
HITS = (CSV, PARQUET) = (".csv", ".parquet")
STILLS, FILMS = (SVG, PNG), (GIF, MP4)
#: The forms of scene files.
SCENES = (STATE, ".json")
#: What `run` can write, and what `show` can of a scene and of a recording.
OF_RUN = (*STILLS, *FILMS, PAGE, RUN, *HITS, STATE)
OF_SCENE = STILLS
OF_RECORDING = (*STILLS, *FILMS, PAGE)
#: The files that need every frame of a run.
RECORDED = frozenset({*FILMS, PAGE, RUN})
#: The exit status of a command that Ctrl-C has interrupted, as shells have it.
INTERRUPTED = 130


def check_extras(endings: Collection[str]) -> None:
    """Raise `MissingExtra` where what some endings need is not installed."""
    if not {PNG, *FILMS}.isdisjoint(endings):
        needed("pygame", "pygame-ce", "draw", "raster pictures")
    if not set(FILMS).isdisjoint(endings):
        encoder()
    if PARQUET in endings:
        needed("pyarrow.parquet", "pyarrow", "study", "Parquet files")


def writers_of_run(source: Source, world: World, outcome: Outcome, view: View) -> Writers:
    """How the files of a run are written."""
    shares = [(count.label, count.touches - count.entries) for count in outcome.tally.counts() if count.bounces]

    def picture() -> Picture:
        return draw.picture_of(
            world,
            source.title,
            caption=source.about,
            trace=outcome.trace,
            shares=shares,
            layers=view.layers,
            size=view.size,
        )

    def hits(path: Path) -> None:
        write_hits(path, outcome.hits, names_in(world))

    def hits_table(path: Path) -> None:
        write_hits_table(path, outcome.hits, names_in(world))

    def state(path: Path) -> None:
        Scene.from_world(world).save(path)

    recorded = {} if outcome.recording is None else writers_of_recording(outcome.recording, view)
    return {CSV: hits, PARQUET: hits_table, STATE: state, **recorded, **writers_of_picture(picture, view)}


def writers_of_picture(picture: Callable[[], Picture], view: View, scene: Scene | None = None) -> Writers:
    """How the files of a picture are written, which is made when it is needed; SVG keeps the `scene` that it shows."""

    def vectors(path: Path) -> None:
        path.write_text(draw.svg(picture(), view.theme, scene), encoding="utf-8", newline="\n")

    def pixels(path: Path) -> None:
        path.write_bytes(draw.png(picture(), view.theme))

    return {SVG: vectors, PNG: pixels}


def writers_of_recording(recording: Recording, view: View) -> Writers:
    """How the files of a recording are written, but for the pictures of a moment of it."""

    def film(path: Path) -> None:
        shown = draw.Film(recording, layers=view.layers, theme=view.theme, size=view.size)
        with report.FilmBar(path.suffix[1:]) as bar:
            draw.write_film(shown, path, bar.tell)

    def page(path: Path) -> None:
        path.write_text(replay_page(recording, view.theme, view.page_layers), encoding="utf-8", newline="\n")

    def run(path: Path) -> None:
        path.write_bytes(recording_bytes(recording))

    return {GIF: film, MP4: film, PAGE: page, RUN: run}


def write_all(paths: Sequence[Path], writers: Writers) -> None:
    """Write every file that can be written, say how large each is, and exit with 1 if any could not."""
    failed = False
    with promised(paths) as left, warnings_told():
        for path in paths:
            try:
                size = outputs.write(path, writers[path.suffix.lower()])
            except (OSError, CaromError) as error:
                why = (error.strerror if isinstance(error, OSError) else None) or error
                typer.echo(f"carom: {path}: cannot be written: {why}", err=True)
                failed = True
            else:
                typer.echo(f"wrote {path} ({size / 1000:,.0f} kB)")
            left.remove(path)
    if failed:
        raise typer.Exit(1)


@contextmanager
def promised(paths: Sequence[Path]) -> Iterator[list[Path]]:
    """The files that are still to be written, in a list to take them from.

    Where Ctrl-C interrupts what goes on meanwhile, it says which were left, and exits.
    """
    left = list(paths)
    try:
        yield left
    except KeyboardInterrupt:
        names = ", ".join(str(path) for path in left)
        typer.echo(f"carom: interrupted{names and '; not written: '}{names}", err=True)
        raise typer.Exit(INTERRUPTED) from None
