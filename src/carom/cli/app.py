"""The commands and their options; what they do is in the modules beside this one."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Annotated, NoReturn

import typer

from carom.cli import commands, games
from carom.cli.mistakes import Mistake
from carom.cli.quantities import non_negative, number, positive
from carom.cli.view import View
from carom.draw import Layer, ThemeName
from carom.errors import CaromError, RecordingError, SceneError

app = typer.Typer(
    name="carom",
    help="Exact, fast 2D collisions: run a scene, look at it, check it, play.",
    epilog="SCENE is a scene file (.toml, .json) or the name of a shipped scene. "
    "Exit status: 0 done, 1 a failure of the program or the machine, 2 a mistake in what was asked.",
    no_args_is_help=True,
    add_completion=False,
    pretty_exceptions_enable=False,
)

SceneName = Annotated[str, typer.Argument(metavar="SCENE", help="A scene file, or the name of a shipped scene.")]
Theme = Annotated[
    ThemeName,
    typer.Option(help="Colours of a picture; auto follows the reader's own setting where it can, else it is light."),
]
Layers = Annotated[
    str | None,
    typer.Option(
        metavar="NAMES",
        help="What a picture shows, and a page at first, separated by commas: all, or some of "
        f"{', '.join(sorted(Layer))}. By default shapes, sensors, balls, hits and tracks.",
    ),
]
Seconds = Annotated[
    str | None,
    typer.Option("--seconds", metavar="S", help="Close the window after so long, and print what frames took."),
]
Size = Annotated[str | None, typer.Option(metavar="PIXELS", help="Size of a picture: 1280x720, or its longer side.")]


def main(arguments: list[str] | None = None) -> None:
    """Nothing; runs the command line (of this process, or `arguments`) and raises `SystemExit` with its status."""
    try:
        app(arguments, prog_name="carom")
    except (Mistake, SceneError, RecordingError) as error:
        fail(error, 2)
    except (CaromError, OSError) as error:
        fail(error, 1)


def fail(error: Exception, status: int) -> NoReturn:
    """Nothing; says on stderr what went wrong and exits with `status`."""
    typer.echo(f"carom: {error}", err=True)
    sys.exit(status)


@app.callback()
def root(
    version: Annotated[
        bool,
        typer.Option("--version", callback=commands.tell_version, is_eager=True, help="Show the version and exit."),
    ] = False,
) -> None:
    """Take the options of `carom` itself."""


@app.command()
def run(
    scene: SceneName,
    seconds: Annotated[str, typer.Option(metavar="S", help="Simulated time to run for, in seconds.")] = "10",
    dt: Annotated[str, typer.Option(metavar="S", help="Length of a step: a number or a fraction.")] = "1/60",
    out: Annotated[
        list[Path] | None,
        typer.Option(
            metavar="FILE",
            help="Write a file, by its ending: .svg or .png a picture of the run, .gif or .mp4 an animation, "
            ".html a page that plays it, .carom the recording, .csv or .parquet all hits, "
            ".toml the end state as a scene. "
            "Can be given several times.",
        ),
    ] = None,
    theme: Theme = ThemeName.AUTO,
    layers: Layers = None,
    size: Size = None,
) -> None:
    """Run a scene, show progress, and print what happened.

    Ctrl-C stops the run; what was asked for is still written.
    """
    view = View.of(theme, layers, size)
    commands.run(scene, non_negative("--seconds", seconds), positive("--dt", dt), out or [], view)


@app.command()
def show(
    scene: SceneName,
    out: Annotated[
        Path | None,
        typer.Option(
            metavar="FILE",
            help="The picture, .svg or .png; of a recording (.carom) .gif, .mp4 and .html too. "
            "By default the scene's name and .svg, here.",
        ),
    ] = None,
    theme: Theme = ThemeName.AUTO,
    layers: Layers = None,
    size: Size = None,
    at: Annotated[
        str | None, typer.Option(metavar="S", help="Of a recording: the time to show. By default its end.")
    ] = None,
) -> None:
    """Make a picture of a scene as it stands, or of a recorded run."""
    view = View.of(theme, layers, size)
    commands.show(scene, out, view, None if at is None else number("--at", at))


@app.command()
def check(scene: SceneName) -> None:
    """Say whether a scene file is good, and all that is wrong with it."""
    commands.check(scene)


@app.command()
def scenes(
    schema: Annotated[bool, typer.Option("--schema", help="Print the JSON Schema of scene files.")] = False,
) -> None:
    """List the shipped scenes."""
    if schema:
        commands.print_schema()
    else:
        commands.list_scenes()


@app.command()
def toy(
    chart: Annotated[
        bool, typer.Option("--chart", help="Write a chart of box tests against balls instead, for the broad phases.")
    ] = False,
    out: Annotated[
        Path | None, typer.Option(metavar="FILE", help="The chart, .svg, .png or .pdf. By default toy-chart.svg, here.")
    ] = None,
    seconds: Seconds = None,
) -> None:
    """Play with collisions: the table, and a panel with everything that can be changed, counted and shown."""
    if chart:
        games.toy_chart(out or Path("toy-chart.svg"))
    elif out is not None:
        raise Mistake(f"--out {out}: is for --chart")
    else:
        games.toy(span(seconds))


@app.command()
def pinball(seconds: Seconds = None) -> None:
    """Play pinball: the flippers are the shift keys, space is the plunger, F1 is help."""
    games.pinball(span(seconds))


@app.command()
def pool(seconds: Seconds = None) -> None:
    """Play the end of a game of pool: the mouse aims, its button draws the cue back, F1 is help."""
    games.pool(span(seconds))


def span(seconds: str | None) -> float | None:
    """How long a game is to be played, or None for as long as the player likes."""
    return None if seconds is None else positive("--seconds", seconds)
