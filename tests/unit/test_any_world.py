"""Whatever is in a world, it can be drawn, recorded and studied: every public call, on worlds in which little is.

`CALLS` has a call for each public name of `carom.draw`, `carom.record` and `carom.study.plots` that takes a world or a
run, and for what notebooks ask for. A name that is in none of the tables fails, so a new one gets its call here.
"""

from __future__ import annotations

import inspect
from collections.abc import Callable, Iterator
from pathlib import Path
from xml.etree import ElementTree

import pytest

import carom
from carom import draw, record
from carom.draw import Layer
from carom.study import plots

pygame = pytest.importorskip("pygame", reason='no pygame: pip install "carom[draw]"')
pyplot = pytest.importorskip("matplotlib.pyplot", reason='no matplotlib: pip install "carom[study]"')

STEPS, CHANGE, DT = 6, 3, 1 / 60
SIZE, BOX = (160, 120), carom.Aabb(-2.0, -2.0, 12.0, 8.0)
ALL = frozenset(Layer)


class Story:
    """A world, its steps, and what becomes of it half way.

    Args:
        shapes: Whether it has shapes of every kind.
        balls: How many balls it has.
        asleep: Whether they fall asleep in the first step.
        removed: Whether all that there is goes half way.
        added: Whether balls come half way.
    """

    def __init__(
        self, *, shapes: bool = False, balls: int = 0, asleep: bool = False, removed: bool = False, added: bool = False
    ) -> None:
        self.world = carom.World(detection="discrete", sleep_speed=0.5 if asleep else 0.0, sleep_time=0.0)
        self._removed, self._added = removed, added
        for shape in every_shape() if shapes else []:
            self.world.add(shape)
        self._add_balls(balls, speed=0.0 if asleep else 3.0)
        if asleep:
            self.world.step(DT)
            assert all(ball.asleep for ball in self.world.balls)

    def _add_balls(self, count: int, speed: float = 3.0) -> None:
        """Add some balls, two of which meet."""
        for place in range(count):
            way = -1.0 if place % 2 else 1.0
            ball = carom.Ball((3.0 + place, 5.0), radius=0.4, velocity=(way * speed, 0.0), name=f"ball {place}")
            self.world.add(ball)

    def steps(self) -> Iterator[carom.Hits]:
        """The hits of each step."""
        for step in range(STEPS):
            if step == CHANGE and self._removed:
                for member in [*self.world.balls, *self.world.shapes]:
                    self.world.remove(member)
            if step == CHANGE and self._added:
                self._add_balls(3)
            yield self.world.step(DT)

    def recording(self) -> carom.Recording:
        """The recording of all steps."""
        recorder = record.Recorder(self.world, name="a run")
        for hits in self.steps():
            recorder.note(hits)
        return recorder.finish()


def every_shape() -> list[carom.Shape | carom.Compound | carom.Group]:
    """A shape of each kind, none in the way of the balls."""
    return [
        carom.Point((0.0, 0.0)),
        carom.Segment((0.0, 0.0), (10.0, 0.0), name="floor"),
        carom.Circle((1.0, 2.0), 0.5, sensor=True),
        carom.Arc((8.0, 2.0), 1.0, 0.0, 3.0),
        carom.Gate((0.0, 7.0), (10.0, 7.0), direction=(0.0, 1.0)),
        carom.Compound([carom.Segment((4.0, 1.0), (6.0, 1.0))], pivot=(5.0, 1.0), angular_velocity=1.0, name="paddle"),
        carom.Group(carom.outlines.rectangle(4.0, 8.0, 5.0, 9.0), once=True, name="brick"),
    ]


STORIES: dict[str, Callable[[], Story]] = {
    "nothing at all": Story,
    "no balls": lambda: Story(shapes=True),
    "no shapes": lambda: Story(balls=4),
    "one ball asleep": lambda: Story(balls=1, asleep=True),
    "one ball asleep among shapes": lambda: Story(shapes=True, balls=1, asleep=True),
    "all removed half way": lambda: Story(shapes=True, balls=4, removed=True),
    "the last ball removed half way": lambda: Story(balls=1, removed=True),
    "balls added half way": lambda: Story(shapes=True, added=True),
    "balls added half way to nothing": lambda: Story(added=True),
    "all replaced half way": lambda: Story(shapes=True, balls=4, removed=True, added=True),
}


def undisturbed(world: carom.World, look: Callable[[], object]) -> None:
    """Check that a world is the same after it was looked at."""
    before = world.digest()
    look()
    assert world.digest() == before


# -- the calls ---------------------------------------------------------------------------------------------------------


def pictures(story: Story, folder: Path) -> None:
    """Draw the world after each step, with and without a trace, in some size, in SVG and pixels, on every painter."""
    trace = draw.Trace(story.world)
    for step, hits in enumerate(story.steps()):
        trace.note(hits)
        for followed in (None, trace):

            def look(step: int = step, followed: draw.Trace | None = followed) -> None:
                size = (None, 64, (300, 64), (900, 500))[step % 4]
                picture = draw.picture_of(story.world, "world", trace=followed, layers=ALL, size=size)
                ElementTree.fromstring(draw.svg(picture))

            undisturbed(story.world, look)
    assert trace.latest.dtype == trace.hits.dtype
    assert trace.bounces >= len(trace.hits)
    assert len(trace.tracks()) <= len(trace.followed)
    picture = draw.picture_of(story.world, "world", trace=trace, layers=ALL, size=SIZE)
    assert draw.png(picture).startswith(b"\x89PNG")
    for painter in (draw.RasterPainter(picture.frame, draw.ThemeName.DARK), draw.SvgPainter(picture.frame)):
        picture.draw(painter)
        picture.draw_still(painter)
        picture.draw_still_shapes(painter)
        picture.draw_moving(painter)


def each_layer(story: Story, folder: Path) -> None:
    """Draw every layer by itself, of the world and of its recording."""
    for layer in Layer:
        ElementTree.fromstring(draw.svg(draw.picture_of(story.world, "world", layers={layer})))
    recording = story.recording()
    for layer in Layer:
        ElementTree.fromstring(draw.svg(draw.picture_at(recording, layers={layer})))
        ElementTree.fromstring(draw.svg(draw.picture_of(story.world, "world", layers={layer})))


def live(story: Story, folder: Path) -> None:
    """Draw the world while it goes on, with every layer and with none, looked at anew and not."""
    surface = pygame.Surface(SIZE)
    shown = draw.Live(story.world, BOX, SIZE, layers=ALL)
    few = draw.Live(story.world, BOX, SIZE, changing=list(story.world.shapes))
    for step, hits in enumerate(story.steps()):
        for one in (shown, few):
            one.note(hits)
            undisturbed(story.world, lambda one=one: one.draw(surface))
        if step == CHANGE + 1:
            few.refresh()
            shown.layers = frozenset({Layer.BALLS})
            assert shown.layers == {Layer.BALLS}
            shown.layers = ALL
    few.forget()
    few.draw_still(surface, ground=False)
    few.draw_moving(surface)


def partitions(story: Story, folder: Path) -> None:
    """Ask how each broad phase divides the room."""
    for _ in story.steps():
        for broad_phase in ("brute", "grid", "quadtree"):
            story.world.broad_phase = broad_phase
            partition = draw.partition_of(story.world)
            assert len(partition.cells) <= max(partition.leaves, partition.nodes)


def frames(story: Story, folder: Path) -> None:
    """Draw every frame of the recording."""
    recording = story.recording()
    for frame in range(-len(recording), len(recording)):
        ElementTree.fromstring(draw.svg(draw.picture_at(recording, frame, layers=ALL)))


def films(story: Story, folder: Path) -> None:
    """Make pixels of the recording's frames, and files."""
    film = draw.Film(story.recording(), layers=ALL, size=SIZE)
    for frame in reversed(range(len(film.recording))):
        assert film.frame(frame).get_size() == film.pixels
        assert len(film.rgb(frame)) == 3 * film.pixels[0] * film.pixels[1]
    pytest.importorskip("imageio_ffmpeg", reason='no imageio-ffmpeg: pip install "carom[draw]"')
    for name in ("film.gif", "film.mp4"):
        draw.write_film(film, folder / name)
        assert (folder / name).stat().st_size > 0


def pages(story: Story, folder: Path) -> None:
    """Make the page that plays the recording."""
    assert "</html>" in draw.replay_page(story.recording(), layers=ALL)


def notebooks(story: Story, folder: Path) -> None:
    """Show the world, its scene and its recording in a notebook, before and after."""
    for _ in range(2):
        undisturbed(story.world, story.world._repr_svg_)
        ElementTree.fromstring(carom.Scene.from_world(story.world)._repr_svg_())
        recording = story.recording()
        ElementTree.fromstring(recording._repr_svg_())
        assert "<iframe" in str(recording._repr_html_())


def recordings(story: Story, folder: Path) -> None:
    """Record, in one call too, save, load, and ask for all that a recording knows."""
    first = story.recording()
    for recording in (first, record.Recording.of(story.world, 0.1)):
        recording.save(folder / "run.carom")
        same = record.Recording.load(folder / "run.carom")
        assert repr(same) == repr(recording)
        assert len(same.energy()) == len(same.kinetic_energy()) == len(same)
        assert same.frame_at(same.times[0] + same.duration) == len(same) - 1
        for member in (*same.ball_ids, *same.shape_ids.tolist(), 10**6):
            assert same.label_of(int(member))
        for frame in range(len(same)):
            shapes = same.shapes_at(frame)
            same.pose(shapes, 0)
            assert len(shapes) == len(same.shape_ids)


def plots_of(story: Story, folder: Path) -> None:
    """Plot the recording in every way."""
    recording = story.recording()
    for plot in PLOTS.values():
        plot(recording).figure.canvas.draw()
        pyplot.close("all")


#: The plots: all public functions of the module.
PLOTS = {
    name: plot
    for name, plot in inspect.getmembers(plots, inspect.isfunction)
    if plot.__module__ == plots.__name__ and not name.startswith("_") and name != "maxwell"
}

CALLS = [pictures, each_layer, live, partitions, frames, films, pages, notebooks, recordings, plots_of]

#: By which call each public name is tried, of those that take a world or a run.
TRIED: dict[str, set[str]] = {
    "draw": {
        "picture_of", "svg", "png", "Trace", "Picture", "RasterPainter", "SvgPainter", "Layer", "Live", "partition_of",
        "picture_at", "Film", "write_film", "replay_page",
    },
    "record": {"Recorder", "Recording"},
}  # fmt: skip
#: The names that take none: what others hold or answer.
PLAIN = {"draw": {"DEFAULT_LAYERS", "Cell", "Lettering", "Painter", "Partition", "Style", "ThemeName"}, "record": set()}
#: What each class can do, all of it tried above.
MEMBERS: dict[type, set[str]] = {
    draw.Live: {"layers", "note", "forget", "refresh", "draw", "draw_still", "draw_moving"},
    draw.Film: {"recording", "pixels", "frame", "rgb"},
    draw.Trace: {"followed", "note", "latest", "hits", "tracks"},
    draw.Picture: {"draw", "draw_still", "draw_still_shapes", "draw_moving"},
    record.Recorder: {"note", "finish"},
    record.Recording: {
        "of", "load", "save", "duration", "frame_at", "kinetic_energy", "energy", "label_of", "shapes_at", "pose",
        "ball_ids",
    },
}  # fmt: skip


@pytest.mark.slow
@pytest.mark.parametrize("story", STORIES)
@pytest.mark.parametrize("call", CALLS)
def test_every_call_takes_every_world(call: Callable[[Story, Path], None], story: str, tmp_path: Path) -> None:
    call(STORIES[story](), tmp_path)


@pytest.mark.parametrize("module", [draw, record])
def test_every_public_name_is_tried(module: object) -> None:
    name = getattr(module, "__name__", "").rpartition(".")[2]
    assert set(getattr(module, "__all__", ())) == TRIED[name] | PLAIN[name]


@pytest.mark.parametrize("made", MEMBERS, ids=lambda made: made.__name__)
def test_everything_that_a_class_can_do_is_tried(made: type) -> None:
    fields = set(getattr(made, "__dataclass_fields__", ()))
    assert {name for name in vars(made) if not name.startswith("_")} - fields == MEMBERS[made]
