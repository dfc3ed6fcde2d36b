"""The commands and their options; what they do is in the modules beside this one."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Annotated, Any, NoReturn

import typer
from typer.core import TyperGroup

from carom.cli import commands, files, games, sweeping, watching
from carom.cli.mistakes import Mistake, meant, no_such
from carom.cli.quantities import non_negative, number, positive
from carom.cli.view import View
from carom.draw import Layer, ThemeName
from carom.errors import CaromError, RecordingError, SceneError

#: What is raised where a command is not called as it must be; typer has a public name only for one of its kind.
UsageError: Any = typer.BadParameter.__bases__[0]


class Commands(TyperGroup):
    """The commands; a name that none has is a mistake like any other."""

    def resolve_command(self, ctx: Any, args: list[str]) -> Any:
        """The command that the first of the arguments names, and the rest of them."""
        if args[0] not in self.commands:
            raise no_such("command", args[0], self.commands)
        return super().resolve_command(ctx, args)


app = typer.Typer(
    name="carom",
    cls=Commands,
    # As plain text: typer's boxes say of options that take no value that they take a `<bool>`. Defaults stand in the
    # options' own words, for some versions of typer write them as for a box even so.
    rich_markup_mode=None,
    help="Exact, fast 2D collisions: run a scene, look at it, check it, play.",
    epilog="SCENE is a scene file (.toml, .json), a drawing (.svg, .dxf), or the name of a shipped scene. "
    "Exit status: 0 done, 1 a failure of the program or the machine, 2 a mistake in what was asked, "
    "130 interrupted by Ctrl-C.",
    invoke_without_command=True,
    add_completion=False,
    pretty_exceptions_enable=False,
)

# Hidden: what SCENE is, each command says in its own words; typer would say that it is a `<str>`.
SceneName = Annotated[str, typer.Argument(metavar="SCENE", hidden=True)]
Theme = Annotated[
    str,
    typer.Option(
        metavar="NAME",
        show_default=False,
        help=f"Colours of a picture: {', '.join(ThemeName)}; auto follows the reader's own setting where it can, "
        "else it is light. By default auto.",
    ),
]
Layers = Annotated[
    str | None,
    typer.Option(
        metavar="NAMES",
        help="What a picture shows, and a page at first, separated by commas: all, or some of "
        f"{', '.join(sorted(Layer))}. By default shapes, sensors, balls, hits and tracks.",
    ),
]
StepLength = Annotated[
    str,
    typer.Option(metavar="S", show_default=False, help="Length of a step: a number or a fraction. By default 1/60."),
]
Seconds = Annotated[
    str | None,
    typer.Option("--seconds", metavar="S", help="Close the window after so long, and print what frames took."),
]
Size = Annotated[str | None, typer.Option(metavar="PIXELS", help="Size of a picture: 1280x720, or its longer side.")]


def main(arguments: list[str] | None = None) -> None:
    """Run the command line (of this process, or `arguments`) and raise `SystemExit` with its status."""
    try:
        # A command returns nothing; what comes back is the status of one that was ended early.
        status = app(arguments, prog_name="carom", standalone_mode=False)
    except UsageError as error:
        fail(misused(error), 2)
    except (KeyboardInterrupt, typer.Abort):
        status = files.INTERRUPTED
    except (Mistake, SceneError, RecordingError) as error:
        fail(error, 2)
    except (CaromError, OSError) as error:
        fail(error, 1)
    sys.exit(status or 0)


def misused(error: Any) -> str:
    """What typer says of a command that was not called as it must be, in one line, as all else is said."""
    context = error.ctx
    if hasattr(error, "possibilities") and context is not None:
        options = [option for parameter in context.command.get_params(context) for option in parameter.opts]
        told, hint = f"{error.option_name}: no such option", meant(error.option_name, options)
    else:
        said = error.format_message().rstrip(".")
        told, hint = f"{said[:1].lower()}{said[1:]}", ""
    return f"{told}; {hint or f'see {context.command_path if context else app.info.name} --help'}"


def fail(error: Exception | str, status: int) -> NoReturn:
    """Say on stderr what went wrong and exit with `status`."""
    typer.echo(f"carom: {error}", err=True)
    sys.exit(status)


@app.callback()
def root(
    context: typer.Context,
    version: Annotated[bool, typer.Option("--version", help="Show the version and exit.")] = False,
) -> None:
    """Take the options of `carom` itself; without any, and without a command, say what there is."""
    if version:
        commands.tell_version()
        raise typer.Exit
    if context.invoked_subcommand is None:
        typer.echo(context.get_help(), err=True)
        raise typer.Exit(2)


@app.command()
def run(
    scene: SceneName,
    seconds: Annotated[
        str, typer.Option(metavar="S", show_default=False, help="Simulated time to run for, in seconds. By default 10.")
    ] = "10",
    dt: StepLength = "1/60",
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
    watch: Annotated[
        bool, typer.Option("--watch", help="Go on, and make all anew whenever the file is saved; Ctrl-C ends it.")
    ] = False,
    theme: Theme = ThemeName.AUTO.value,
    layers: Layers = None,
    size: Size = None,
) -> None:
    """Run a scene, show progress, and print what happened.

    SCENE is a scene file, a drawing, or the name of a shipped scene. Ctrl-C stops the run; what was asked for is still
    written, unless Ctrl-C comes again.
    """
    view = View.of(theme, layers, size)
    span, step = non_negative("--seconds", seconds), positive("--dt", dt)
    if watch:
        watching.watch(scene, lambda: commands.run(scene, span, step, out or [], view))
    else:
        commands.run(scene, span, step, out or [], view)


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
    theme: Theme = ThemeName.AUTO.value,
    layers: Layers = None,
    size: Size = None,
    at: Annotated[
        str | None, typer.Option(metavar="S", help="Of a recording: the time to show. By default its end.")
    ] = None,
) -> None:
    """Make a picture of a scene as it stands, or of a recorded run.

    SCENE is a scene file, a drawing, a recording, or the name of a shipped scene.
    """
    view = View.of(theme, layers, size)
    commands.show(scene, out, view, None if at is None else number("--at", at))


@app.command()
def check(scene: SceneName) -> None:
    """Say whether a scene file is good, and all that is wrong with it.

    SCENE is a scene file, a drawing, a recording, or the name of a shipped scene.
    """
    commands.check(scene)


@app.command()
def convert(
    drawing: Annotated[Path, typer.Argument(metavar="DRAWING", hidden=True)],
    file: Annotated[Path, typer.Argument(metavar="FILE", hidden=True)],
    tolerance: Annotated[
        str | None,
        typer.Option(
            metavar="LENGTH",
            help="How far arcs may be from the curves that they stand for. By default a thousandth of the drawing.",
        ),
    ] = None,
) -> None:
    """Write what a drawing shows as a scene file.

    DRAWING is an .svg or .dxf file, FILE a .toml or .json one. Bodies have the names that they have in the drawing, and
    numbers are rounded to the tolerance.
    """
    commands.convert(drawing, file, None if tolerance is None else positive("--tolerance", tolerance))


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
def compile() -> None:
    """Compile now what worlds need.

    None of them has to wait for it then, or is interpreted at first. It takes some minutes, once on a machine; compiled
    code is kept in the user's cache folder, or in CAROM_CACHE_DIR.
    """
    commands.compile_ahead()


@app.command()
def sweep(
    scene: SceneName,
    out: Annotated[
        str | None,
        typer.Option(metavar="FOLDER", help="Keep the sweep in this folder, or at an address that fsspec knows."),
    ] = None,
    seconds: Annotated[str | None, typer.Option(metavar="S", help="Simulated time of each run, in seconds.")] = None,
    vary: Annotated[
        list[str] | None,
        typer.Option(
            metavar="NAME=VALUES",
            help='What differs between runs: a path, an argument of a shipped scene, or seed; "world.friction=0,0.5", '
            '"world.gravity=(0,-30),(0,-40)", "seed=0:1000" up to 999. All values of one go with all of the others.',
        ),
    ] = None,
    measure: Annotated[
        str,
        typer.Option(
            metavar="NAME",
            show_default=False,
            help="What is kept of a run: hits-by-shape, hits-by-kind, impact-speeds, energy, last-state, statistics, "
            "or a function of yours as module:function. By default hits-by-shape.",
        ),
    ] = "hits-by-shape",
    dt: StepLength = "1/60",
    cluster: Annotated[
        str | None,
        typer.Option(
            metavar="ADDRESS",
            help="A running Dask scheduler, or serial for one process. By default a process for each core.",
        ),
    ] = None,
    resume: Annotated[bool, typer.Option("--resume", help="Go on with the sweep that is in the folder.")] = False,
) -> None:
    """Run a scene many times and keep a table.

    SCENE is a scene file, the name of a shipped scene, or a function as module:function. Ctrl-C stops the sweep, and
    --resume goes on with it, as it does after anything else that ended it.
    """
    # All three must be given; where typer is told so, some of its versions write that with a backslash.
    folder = sweeping.given("--out", out, "where the sweep is to be kept, like --out results")
    simulated = sweeping.given("--seconds", seconds, "how long each run is to be, like --seconds 60")
    varied = sweeping.given("--vary", vary, 'what differs between runs, like --vary "seed=0:100"')
    length, step = non_negative("--seconds", simulated), positive("--dt", dt)
    sweeping.sweep(scene, varied, measure, length, step, folder, cluster, resume)


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
    """Play with collisions, on a table with a panel.

    On the panel is everything that can be changed, counted and shown; F1 is help.
    """
    if chart and seconds is not None:
        raise Mistake(f"--seconds {seconds}: is for playing, not for --chart")
    if chart:
        games.toy_chart(out or Path("toy-chart.svg"))
    elif out is not None:
        raise Mistake(f"--out {out}: is for --chart")
    else:
        games.toy(span(seconds))


@app.command()
def pinball(seconds: Seconds = None) -> None:
    """Play pinball.

    Left and Right, or the shift keys, are the flippers, space held and let go is the
    plunger, F1 is help.
    """
    games.pinball(span(seconds))


@app.command()
def pool(
    balls: Annotated[
        str,
        typer.Option(
            metavar="NUMBER",
            show_default=False,
            help="Balls to pot, 1 to 8; several within so many shots, 3 in 5, 8 in 13. By default 1.",
        ),
    ] = "1",
    seconds: Seconds = None,
) -> None:
    """Play the end of a game of pool.

    The mouse aims, a click shoots with the power shown; its button held draws the cue
    instead. F1 is help.
    """
    if balls not in map(str, range(1, games.MOST_BALLS + 1)):
        raise Mistake(f"--balls {balls}: must be a whole number from 1 to {games.MOST_BALLS}")
    games.pool(span(seconds), int(balls))


def span(seconds: str | None) -> float | None:
    """How long a game is to be played, or None for as long as the player likes."""
    return None if seconds is None else positive("--seconds", seconds)
