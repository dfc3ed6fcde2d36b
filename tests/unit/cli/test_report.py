"""What a run says at its end and on its way."""

import numpy as np
import pytest
from rich.console import Console

import carom
from carom.cli.report import MOST_ROWS, Bar, FilmBar, counted, pace, summary
from carom.cli.running import Outcome
from carom.cli.tally import Tally
from carom.rows.hit import HIT
from carom.world.hits import HitKind


def told(world: carom.World, *, steps: int = 60, asked: int = 60, hits: np.ndarray | None = None) -> str:
    """The summary of a run, as it is printed."""
    tally = Tally.of(world)
    tally.add(np.zeros(0, HIT) if hits is None else hits)
    outcome = Outcome(steps, asked, 0.5, tally, np.zeros(0, HIT), None, None)
    console = Console(width=100)
    with console.capture() as capture:
        console.print(summary("table", world, outcome, 1 / 60))
    return capture.get()


def world_of_points(count: int) -> carom.World:
    """A world of points that have no names."""
    world = carom.World()
    for x in range(count):
        world.add(carom.Point((x, 0)))
    return world


def one_hit_each(world: carom.World, kind: HitKind = HitKind.BOUNCE) -> np.ndarray:
    """A hit of each shape, of speed 2 and impulse 3."""
    hits = np.zeros(len(world.shapes), HIT)
    hits["kind"] = kind
    hits["shape"] = [shape.id for shape in world.shapes]
    hits["speed"], hits["impulse"] = 2.0, 3.0
    return hits


def test_the_summary_names_the_run_its_counters_and_its_digest() -> None:
    world = carom.World()
    text = told(world)
    assert "in 60 steps" in text
    assert "no hits" in text
    assert "box tests" in text
    assert "stalled" not in text
    assert world.digest() in text


def test_a_run_that_was_stopped_says_so() -> None:
    assert "stopped before the end: 10 s were asked for" in told(carom.World(), asked=600)
    assert "stopped" not in told(carom.World())


def test_the_table_of_hits_ends_with_how_many_more_there_are() -> None:
    world = world_of_points(MOST_ROWS + 5)
    lines = told(world, hits=one_hit_each(world)).splitlines()
    assert sum(line.startswith(" point at") for line in lines) == MOST_ROWS
    assert any(line.split() == ["5", "more", "5", "5"] for line in lines)


def test_a_sensor_counts_entries() -> None:
    world = world_of_points(1)
    line = next(line for line in told(world, hits=one_hit_each(world, HitKind.ENTER)).splitlines() if "point" in line)
    assert line.split()[-4:] == ["1", "1", "0", "0"]


@pytest.mark.parametrize(
    ("steps", "took", "words"), [(600, 0.1, "100x real time"), (6, 1.0, "0.1x real time"), (0, 0.0, ""), (5, 0.0, "")]
)
def test_a_pace_is_told_where_there_is_one(steps: int, took: float, words: str) -> None:
    assert pace(steps, 1 / 60, took) == words


@pytest.mark.parametrize(("number", "words"), [(0, "0 balls"), (1, "1 ball"), (2000, "2,000 balls")])
def test_one_thing_is_no_plural(number: int, words: str) -> None:
    assert counted(number, "ball") == words


def test_the_bar_shows_time_and_pace_on_a_terminal(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("FORCE_COLOR", "1")
    monkeypatch.setenv("COLUMNS", "100")
    with Bar("table", 600, 1 / 60) as bar:
        bar.tell(300, 0.5)
    shown = capsys.readouterr().err
    assert "table" in shown
    assert "5.0 of 10 s" in shown
    assert "10x real time" in shown


def test_the_bar_is_silent_where_there_is_no_terminal(capsys: pytest.CaptureFixture[str]) -> None:
    with Bar("table", 600, 1 / 60) as bar:
        bar.tell(300, 0.5)
    assert capsys.readouterr() == ("", "")


def test_the_bar_of_a_film_shows_its_frames_and_goes(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("FORCE_COLOR", "1")
    monkeypatch.setenv("TERM", "xterm")
    with FilmBar("gif") as bar:
        for done in (1, 2, 40):
            bar.tell(done, 40)
    assert "40 of 40 frames" in capsys.readouterr().err
