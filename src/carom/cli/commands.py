"""What each command does, once its options are read."""

from __future__ import annotations

import json
from pathlib import Path
from typing import TYPE_CHECKING

import typer
from rich.console import Console
from rich.table import Table
from rich.text import Text

import carom
from carom import draw
from carom.cli import outputs, report, running
from carom.cli.hits_file import write_hits
from carom.cli.mistakes import Mistake
from carom.cli.sources import Source, find, shipped
from carom.errors import CaromError
from carom.record.members import names_in
from carom.scene import Scene

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping, Sequence

    from carom.world.world import World

PICTURE, HITS, STATE = ".svg", ".csv", ".toml"
#: More steps than this in one run are a slip of the keys.
MOST_STEPS = 10**12


def tell_version(wanted: bool) -> None:
    """Nothing; prints the version and ends the program, if that is wanted."""
    if wanted:
        typer.echo(f"carom {carom.__version__}")
        raise typer.Exit


def run(scene: str, seconds: float, dt: float, paths: Sequence[Path], theme: draw.ThemeName) -> None:
    """Nothing; runs a scene, prints what happened, writes the files."""
    source = find(scene)
    outputs.check_outputs(paths, (PICTURE, HITS, STATE), source.path)
    steps = steps_of(seconds, dt)
    world = source.scene().build()
    endings = {path.suffix.lower() for path in paths}
    with report.Bar(source.name, steps, dt) as bar:
        outcome = running.run(
            world,
            steps,
            dt,
            keep_hits=HITS in endings,
            follow=PICTURE in endings,
            tell=bar.tell,
        )
    Console().print(report.summary(source.name, world, outcome, dt))
    write_all(paths, writers(source, world, outcome, theme))


def steps_of(seconds: float, dt: float) -> int:
    """How many steps of length `dt` make `seconds`."""
    if seconds / dt > MOST_STEPS:
        raise Mistake(f"--seconds {seconds:g} and --dt {dt:g} make more than {MOST_STEPS:g} steps")
    steps = round(seconds / dt)
    if steps == 0 and seconds > 0.0:
        raise Mistake(f"--seconds {seconds:g} is less than half a step of --dt {dt:g}")
    return steps


def writers(
    source: Source, world: World, outcome: running.Outcome, theme: draw.ThemeName
) -> Mapping[str, Callable[[Path], None]]:
    """How the files of a run are written, by their endings."""

    def picture(path: Path) -> None:
        shares = [(count.label, count.bounces) for count in outcome.tally.counts() if count.bounces]
        shown = draw.picture_of(world, source.title, caption=source.about, trace=outcome.trace, shares=shares)
        path.write_text(draw.svg(shown, theme), encoding="utf-8", newline="\n")

    def hits(path: Path) -> None:
        write_hits(path, outcome.hits, names_in(world))

    def state(path: Path) -> None:
        Scene.from_world(world).save(path)

    return {PICTURE: picture, HITS: hits, STATE: state}


def write_all(paths: Sequence[Path], by_ending: Mapping[str, Callable[[Path], None]]) -> None:
    """Nothing; writes every file that can be written, says how large each is, and exits with 1 if any could not."""
    failed = False
    for path in paths:
        try:
            size = outputs.write(path, by_ending[path.suffix.lower()])
        except (OSError, CaromError) as error:
            typer.echo(f"carom: {path}: cannot be written: {error}", err=True)
            failed = True
        else:
            typer.echo(f"wrote {path} ({size / 1000:,.0f} kB)")
    if failed:
        raise typer.Exit(1)


def show(scene: str, out: Path | None, theme: draw.ThemeName) -> None:
    """Nothing; writes a picture of a scene as it stands."""
    source = find(scene)
    path = source.picture if out is None else out
    outputs.check_outputs([path], (PICTURE,), source.path)
    shown = draw.picture_of(source.scene().build(), source.title, caption=source.about)

    def picture(path: Path) -> None:
        path.write_text(draw.svg(shown, theme), encoding="utf-8", newline="\n")

    write_all([path], {PICTURE: picture})


def check(scene: str) -> None:
    """Nothing; says that a scene is good, or raises `SceneError` with all its faults."""
    source = find(scene)
    world = source.scene().build()
    shapes, balls = report.counted(len(world.shapes), "shape"), report.counted(len(world.balls), "ball")
    typer.echo(f"{source.name}: good: {shapes}, {balls}")


def print_schema() -> None:
    """Nothing; prints the JSON Schema of scene files."""
    typer.echo(json.dumps(Scene.json_schema(), indent=2))


def list_scenes() -> None:
    """Nothing; prints the shipped scenes, a line each."""
    table = Table(box=None, padding=(0, 2, 0, 0), show_header=False)
    for source in shipped():
        table.add_row(Text(source.name, style="bold"), Text(source.about))
    Console().print(table)
