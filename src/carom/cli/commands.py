"""What each command does, once its options are read."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING

import typer
from rich.console import Console
from rich.table import Table
from rich.text import Text

import carom
from carom import draw
from carom.cli import files, outputs, report, running
from carom.cli.mistakes import Mistake
from carom.cli.sources import Source, find, shipped, warnings_told
from carom.cli.tally import shares_of
from carom.limits import LARGEST_RECORDING
from carom.record import Recorder
from carom.scene import Scene
from carom.scene.drawings.converting import converted
from carom.scene.drawings.reading import ENDINGS

if TYPE_CHECKING:
    from collections.abc import Sequence
    from pathlib import Path

    from carom.cli.view import View
    from carom.world.world import World

#: Frames a second that are recorded; fewer where the steps are longer.
FRAMES = 60
#: What a recording keeps of a ball at each frame, in bytes, with what is needed to keep it.
BYTES_OF_BALL = 100
#: More steps than this in one run are a slip of the keys.
MOST_STEPS = 10**12


def tell_version() -> None:
    """Print the version."""
    typer.echo(f"carom {carom.__version__}")


def compile_ahead() -> None:
    """Compile all kernels, and print what was done and where it is."""
    done = carom.compile()
    for name, seconds in done.seconds.items():
        typer.echo(f"{name.replace('_', ' '):<20}{seconds:7.1f} s")
    if done.seconds:
        was_there = f", {report.counted(len(done.kept), 'kernel')} were there" if done.kept else ""
        typer.echo(f"compiled {report.counted(len(done.seconds), 'kernel')}{was_there}; all are kept in {done.folder}")
    elif done.kept:
        typer.echo(f"everything is there: {report.counted(len(done.kept), 'kernel')} in {done.folder}")
    if done.prebuilt:
        typer.echo(f"{report.counted(len(done.prebuilt), 'kernel')} came with carom, compiled")


def run(scene: str, seconds: float, dt: float, paths: Sequence[Path], view: View) -> bool:
    """Run a scene, print what happened, write the files; whether the run came to its end."""
    source = find(scene)
    if source.recording is not None:
        raise Mistake(f"{scene}: is the recording of a run; carom show makes pictures of it")
    outputs.check_outputs(paths, files.OF_RUN, source.path)
    endings = {path.suffix.lower() for path in paths}
    files.check_extras(endings)
    steps = steps_of(seconds, dt)
    world = source.scene().build()
    recorder = None
    if not files.RECORDED.isdisjoint(endings):
        every = max(1, round(1.0 / (FRAMES * dt)))
        check_room(steps // every + 2, len(world.balls), len(world.shapes))
        recorder = Recorder(world, name=source.title, about=source.about, every=every)
    with files.promised(paths), report.Bar(source.name, steps, dt) as bar:
        outcome = running.run(
            world,
            steps,
            dt,
            tell=bar.tell,
            keep_hits=not set(files.HITS).isdisjoint(endings),
            follow=not set(files.STILLS).isdisjoint(endings),
            recorder=recorder,
        )
    Console().print(report.summary(source.name, world, outcome, dt))
    files.write_all(paths, files.writers_of_run(source, world, outcome, view))
    return not outcome.stopped


def convert(drawing: Path, path: Path, tolerance: float | None) -> None:
    """Write what a drawing shows as a scene file that a person can read."""
    if drawing.suffix.lower() not in ENDINGS:
        raise Mistake(f"{drawing}: its ending must be one of {', '.join(ENDINGS)}")
    outputs.check_outputs([path], files.SCENES, drawing)
    with warnings_told():
        scene = converted(drawing, tolerance)
    files.write_all([path], dict.fromkeys(files.SCENES, scene.save))
    typer.echo(f"{report.counted(len(scene.shapes), 'shape')}, {report.counted(len(scene.balls), 'ball')}")


def check_room(frames: int, balls: int, shapes: int) -> None:
    """Raise `Mistake` where a recording would fill the memory."""
    size = frames * (BYTES_OF_BALL * balls + shapes)
    if size > LARGEST_RECORDING:
        raise Mistake(f"a recording of this run would take {size / 1e9:,.0f} GB of memory; make --seconds less")


def steps_of(seconds: float, dt: float) -> int:
    """How many steps of length `dt` make `seconds`."""
    if seconds / dt > MOST_STEPS:
        raise Mistake(f"--seconds {seconds:g} and --dt {dt:g} make more than {MOST_STEPS:g} steps")
    steps = round(seconds / dt)
    if steps == 0 and seconds > 0.0:
        raise Mistake(f"--seconds {seconds:g} is less than half a step of --dt {dt:g}")
    return steps


def show(scene: str, out: Path | None, view: View, at: float | None) -> None:
    """Write a picture of a scene as it stands, or of a recorded run."""
    source = find(scene)
    path = source.picture if out is None else out
    recording = source.recording
    outputs.check_outputs([path], files.OF_SCENE if recording is None else files.OF_RECORDING, source.path)
    ending = path.suffix.lower()
    if at is not None and recording is None:
        raise Mistake(f"--at {at:g}: is for recordings; {source.name} is a scene")
    if at is not None and ending not in files.STILLS:
        raise Mistake(f"--at {at:g}: is for pictures; {path} shows the whole run")
    files.check_extras({ending})
    if recording is None:
        kept = source.scene()
        world = kept.build()
        files.write_all([path], files.writers_of_picture(lambda: still(source, world, view), view, kept))
        return
    first, last = float(recording.times[0]), float(recording.times[-1])
    if at is not None and not first <= at <= last:
        raise Mistake(f"--at {at:g}: the recording goes from {first:g} to {last:g} s")
    frame = len(recording) - 1 if at is None else recording.frame_at(at)

    def picture() -> draw.Picture:
        shares = shares_of(recording, float(recording.times[frame]))
        return draw.picture_at(recording, frame, shares=shares, layers=view.layers, size=view.size)

    writers = files.writers_of_recording(recording, view)
    files.write_all([path], {**writers, **files.writers_of_picture(picture, view)})


def still(source: Source, world: World, view: View) -> draw.Picture:
    """The picture of a scene as it stands."""
    return draw.picture_of(world, source.title, caption=source.about, layers=view.layers, size=view.size)


def check(scene: str) -> None:
    """Say that a scene is good, or raise `SceneError` with all its faults."""
    source = find(scene)
    if source.recording is not None:
        frames, balls = (
            report.counted(len(source.recording), "frame"),
            report.counted(len(source.recording.ids), "ball"),
        )
        typer.echo(f"{source.name}: good: {frames}, {balls}, {report.counted(len(source.recording.hits), 'hit')}")
        return
    described = source.scene()
    world = described.build()
    shapes, balls = report.counted(len(described.shapes), "shape"), report.counted(len(world.balls), "ball")
    added = len(world.shapes) - len(described.shapes)
    guards = f", {report.counted(added, 'guard point')}" if added else ""
    typer.echo(f"{source.name}: good: {shapes}{guards}, {balls}")


def print_schema() -> None:
    """Print the JSON Schema of scene files."""
    typer.echo(json.dumps(Scene.json_schema(), indent=2))


def list_scenes() -> None:
    """Print the shipped scenes, a line each."""
    table = Table(box=None, padding=(0, 2, 0, 0), show_header=False)
    for source in shipped():
        table.add_row(Text(source.name, style="bold"), Text(source.about))
    Console().print(table)
