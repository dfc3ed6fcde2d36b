"""The commands as a user meets them: what they print, what they write, how they exit."""

import csv
import json
import os
import signal
import subprocess
import sys
from pathlib import Path
from xml.etree import ElementTree

import pytest

import carom
from carom.cli.hits_file import COLUMNS
from carom.compiler import door
from carom.compiler.cache import cache_folder
from tests.drawings import svg
from tests.unit.cli.saying import carom_says

GOOD = """version = 1
[world]
gravity = [0, -10]
[[shapes]]
kind = "segment"
start = [-5, 0]
end = [5, 0]
name = "floor, {shiny} [bold]"
elasticity = 0.8
[[balls]]
position = [0, 2]
radius = 0.5
"""
BAD = GOOD + 'color = "red"\n[[balls]]\nposition = [0, 1]\nradius = -1\n'


@pytest.fixture
def here(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder to work in, with a good and a bad scene file."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("COLUMNS", "120")
    (tmp_path / "good.toml").write_text(GOOD)
    (tmp_path / "bad.toml").write_text(BAD)
    (tmp_path / "broken.carom").write_text("no recording")
    return tmp_path


@pytest.mark.usefixtures("here")
def test_a_run_prints_what_happened(capsys: pytest.CaptureFixture[str]) -> None:
    status, out, err = carom_says(capsys, "run", "good.toml", "--seconds", "2")
    world = carom.Scene.load("good.toml").build()
    hits = world.run(2.0)
    assert status == 0
    assert err == ""
    assert "2 s simulated in 120 steps" in out
    assert f"floor, {{shiny}} [bold] {len(hits)} " in " ".join(out.split())
    assert world.digest() in out


def test_a_run_writes_what_is_asked_for_and_nothing_else(here: Path, capsys: pytest.CaptureFixture[str]) -> None:
    names = ("run.svg", "run.csv", "run.toml")
    outs = [argument for name in names for argument in ("--out", name)]
    before = set(here.iterdir())
    status, out, _ = carom_says(capsys, "run", "good.toml", "--seconds", "1", "--dt", "1/100", *outs)
    assert status == 0
    assert {path.name for path in set(here.iterdir()) - before} == set(names)
    assert all(f"wrote {name}" in out for name in names)
    world = carom.Scene.load("good.toml").build()
    hits = world.run(1.0, dt=1 / 100)
    assert ElementTree.parse(here / "run.svg").getroot().find("{*}title").text == "good"
    assert carom.Scene.load("run.toml").balls[0].position == world.balls[0].position
    with (here / "run.csv").open(newline="") as file:
        header, *lines = csv.reader(file)
    assert tuple(header) == COLUMNS
    assert [float(line[0]) for line in lines] == hits["time"].tolist()
    assert {line[5] for line in lines} == {"floor, {shiny} [bold]"}
    assert [(float(line[6]), float(line[7])) for line in lines] == [tuple(point) for point in hits["point"].tolist()]


def test_a_table_of_hits_needs_pyarrow(
    here: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(sys.modules, "pyarrow.parquet", None)
    status, _, err = carom_says(capsys, "run", "good.toml", "--seconds", "1", "--out", "run.parquet")
    assert status == 1
    assert err == 'carom: Parquet files need pyarrow: pip install "carom[study]"\n'
    assert not (here / "run.parquet").exists()


@pytest.mark.usefixtures("here")
def test_a_run_of_no_time_is_the_scene_as_it_stands(capsys: pytest.CaptureFixture[str]) -> None:
    status, out, _ = carom_says(capsys, "run", "good.toml", "--seconds", "0", "--out", "same.toml")
    assert status == 0
    assert "no hits" in out
    loaded, saved = (carom.Scene.load(name).build() for name in ("good.toml", "same.toml"))
    assert saved.digest() == loaded.digest()


def test_a_shipped_scene_runs_by_its_name(here: Path, capsys: pytest.CaptureFixture[str]) -> None:
    status, out, _ = carom_says(capsys, "run", "pinball", "--seconds", "1", "--out", "pinball.svg", "--theme", "dark")
    assert status == 0
    assert out.startswith("pinball  1 s simulated in 60 steps")
    assert "Pinball" in (here / "pinball.svg").read_text(encoding="utf-8")


@pytest.mark.parametrize(
    ("arguments", "told"),
    [
        (("run", "pinbal"), "did you mean pinball?"),
        (("run", "missing.toml"), "no such file"),
        (("run", "."), "is a folder"),
        (("run", "good.toml", "--dt", "fast"), "--dt fast: is no number, nor a fraction like 1/60"),
        (("run", "good.toml", "--dt", "0"), "--dt 0: must be above 0"),
        (("run", "good.toml", "--seconds", "-1"), "--seconds -1: must not be below 0"),
        (("run", "good.toml", "--seconds", "1/1000"), "less than half a step"),
        (("run", "good.toml", "--seconds", "1e300"), "more than 1e+12 steps"),
        (
            ("run", "good.toml", "--out", "run.bmp"),
            "run.bmp: its ending must be one of .svg, .png, .gif, .mp4, .html, .carom, .csv, .parquet, .toml",
        ),
        (("run", "good.toml", "--layers", "hit"), "--layers hit: no such layer; did you mean hits?"),
        (("run", "good.toml", "--layers", "balls,zzz"), "--layers zzz: no such layer; there are cells, boxes,"),
        (("run", "good.toml", "--size", "12"), "--size 12: must be from 64 to 8192 pixels"),
        (("show", "good.toml", "--size", "1280*720"), "--size 1280*720: must be a width and a height like 1280x720"),
        (("show", "good.toml", "--size", "1x2x3"), "--size 1x2x3: must be a width and a height"),
        (("show", "good.toml", "--at", "1"), "--at 1: is for recordings; good is a scene"),
        (("show", "good.toml", "--at", "x"), "--at x: is no number"),
        (("run", "gas", "--seconds", "1e6", "--out", "gas.mp4"), "GB of memory; make --seconds less"),
        (("show", "good.toml", "--out", "run.gif"), "its ending must be one of .svg, .png"),
        (("show", "broken.carom"), "broken.carom: is damaged or no recording"),
        (("run", "good.toml", "--out", "no/run.svg"), "there is no folder no"),
        (("run", "good.toml", "--out", "good.toml"), "is the scene itself"),
        (("run", "good.toml", "--out", "a.svg", "--out", "a.svg"), "asked for twice"),
        (("show", "good.toml", "--out", "run.csv"), "its ending must be one of .svg"),
        (("show", "missing"), "no such file"),
        (("check", "missing"), "no such file"),
        (("check", "n" * 300), "File name too long"),
        (("run", "good.toml", "--out", "n" * 300 + ".svg"), "File name too long"),
    ],
)
def test_a_mistake_is_told_in_one_line_before_anything_runs(
    here: Path, capsys: pytest.CaptureFixture[str], arguments: tuple[str, ...], told: str
) -> None:
    before = set(here.iterdir())
    status, out, err = carom_says(capsys, *arguments)
    assert status == 2
    assert out == ""
    assert told in err
    assert err.startswith("carom: ")
    assert err.count("\n") == 1
    assert set(here.iterdir()) == before


@pytest.mark.usefixtures("here")
@pytest.mark.parametrize("command", ["run", "show", "check"])
def test_a_bad_scene_is_refused_with_all_its_faults(capsys: pytest.CaptureFixture[str], command: str) -> None:
    status, out, err = carom_says(capsys, command, "bad.toml")
    assert status == 2
    assert out == ""
    assert "balls[0].color" in err
    assert "balls[1].radius" in err
    assert "Traceback" not in err


@pytest.mark.usefixtures("here")
def test_a_good_scene_is_said_to_be_good(capsys: pytest.CaptureFixture[str]) -> None:
    assert carom_says(capsys, "check", "good.toml") == (0, "good: good: 1 shape, 1 ball\n", "")
    assert carom_says(capsys, "check", "newtons_cradle")[0] == 0


def test_a_picture_goes_to_this_folder_under_the_scene_s_name(here: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (here / "scenes").mkdir()
    (here / "scenes" / "table.toml").write_text(GOOD)
    assert carom_says(capsys, "show", "scenes/table.toml")[:2] == (0, "wrote table.svg (2 kB)\n")
    assert carom_says(capsys, "show", "stadium")[0] == 0
    assert carom_says(capsys, "show", "good.toml", "--out", "other.svg", "--theme", "light")[0] == 0
    for name in ("table.svg", "stadium.svg", "other.svg"):
        assert ElementTree.parse(here / name).getroot().tag.endswith("svg")


@pytest.mark.usefixtures("here")
def test_the_shipped_scenes_are_listed_a_line_each(capsys: pytest.CaptureFixture[str]) -> None:
    status, out, _ = carom_says(capsys, "scenes")
    assert status == 0
    assert [line.split()[0] for line in out.splitlines() if not line.startswith(" ")] == list(carom.scenes.names())


def test_the_schema_is_json(capsys: pytest.CaptureFixture[str]) -> None:
    status, out, _ = carom_says(capsys, "scenes", "--schema")
    assert status == 0
    assert json.loads(out) == carom.Scene.json_schema()


def test_the_version_is_told(capsys: pytest.CaptureFixture[str]) -> None:
    assert carom_says(capsys, "--version") == (0, f"carom {carom.__version__}\n", "")


def test_a_file_that_cannot_be_written_in_the_end_fails_alone(
    here: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    def full(*_: object) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr("carom.cli.files.write_hits", full)
    status, out, err = carom_says(capsys, "run", "good.toml", "--seconds", "1", "--out", "run.csv", "--out", "run.svg")
    assert status == 1
    assert "run.csv" in err
    assert "No space left" in err
    assert "wrote run.svg" in out
    assert sorted(path.name for path in here.iterdir()) == ["bad.toml", "broken.carom", "good.toml", "run.svg"]


@pytest.mark.usefixtures("here")
def test_a_world_that_fails_is_the_program_s_failure(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    def fail(*_: object, **__: object) -> None:
        raise carom.NonFiniteState("balls 1 are not finite")

    monkeypatch.setattr(carom.World, "run", fail)
    status, _, err = carom_says(capsys, "run", "good.toml")
    assert (status, err) == (1, "carom: balls 1 are not finite\n")


def command(*arguments: str) -> list[str]:
    """The command line in a process of its own."""
    return [sys.executable, "-c", "from carom.cli import main; main()", *arguments]


@pytest.mark.slow
def test_the_command_is_the_same_in_a_process_of_its_own(here: Path, capsys: pytest.CaptureFixture[str]) -> None:
    done = subprocess.run(command("check", "good.toml"), cwd=here, capture_output=True, text=True, check=False)
    assert (done.returncode, done.stdout) == (0, "good: good: 1 shape, 1 ball\n")
    done = subprocess.run(command("run", "nothing"), cwd=here, capture_output=True, text=True, check=False)
    assert (done.returncode, done.stdout) == (2, "")
    assert "Traceback" not in done.stderr


#: The command line, in a process that says when the first step is made.
LOUD = """
import sys
from carom.cli import main, report
tell = report.Bar.tell
def loud(bar, steps, took):
    if steps == 1:
        print("stepping", file=sys.stderr, flush=True)
    tell(bar, steps, took)
report.Bar.tell = loud
main()
"""


@pytest.mark.slow
@pytest.mark.skipif(os.name != "posix", reason="signals are sent the way of POSIX")
def test_ctrl_c_stops_a_run_and_writes_what_was_asked(here: Path) -> None:
    outs = ("--out", "run.svg", "--out", "run.csv", "--out", "run.toml")
    process = subprocess.Popen(
        [sys.executable, "-c", LOUD, "run", "good.toml", "--seconds", "1e7", *outs],
        cwd=here,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )
    assert "stepping\n" in process.stderr
    process.send_signal(signal.SIGINT)
    out, err = process.communicate(timeout=120)
    assert process.returncode == 0
    assert "Traceback" not in err
    assert "stopped before the end" in out
    assert ElementTree.parse(here / "run.svg").getroot().tag.endswith("svg")
    assert carom.Scene.load(here / "run.toml").balls
    assert (here / "run.csv").read_text().startswith("time,kind,")


#: The command line, in a process that says when the first frame of a film is encoded, and then takes its time.
SLOW_FILM = """
import sys, time
from carom.cli import main, report
tell = report.FilmBar.tell
def slow(bar, done, total):
    if done == 1:
        print("encoding", file=sys.stderr, flush=True)
    time.sleep(0.2)
    tell(bar, done, total)
report.FilmBar.tell = slow
main()
"""
#: Likewise for a page.
SLOW_PAGE = """
import sys, time
from carom.cli import files, main
def slow(*_):
    print("encoding", file=sys.stderr, flush=True)
    time.sleep(60)
files.replay_page = slow
main()
"""


@pytest.mark.slow
@pytest.mark.skipif(os.name != "posix", reason="signals are sent the way of POSIX")
@pytest.mark.parametrize(("code", "name"), [(SLOW_FILM, "run.gif"), (SLOW_FILM, "run.mp4"), (SLOW_PAGE, "run.html")])
def test_ctrl_c_while_a_file_is_written_says_what_was_not(here: Path, code: str, name: str) -> None:
    pytest.importorskip("imageio_ffmpeg", reason='no imageio-ffmpeg: pip install "carom[draw]"')
    before = set(here.iterdir())
    outs = ("--out", "run.toml", "--out", name, "--out", "run.csv", "--size", "64")
    process = subprocess.Popen(
        [sys.executable, "-c", code, "run", "good.toml", "--seconds", "5", *outs],
        cwd=here,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        start_new_session=True,
    )
    assert process.stderr is not None
    while process.stderr.readline() not in ("encoding\n", ""):
        pass
    os.killpg(process.pid, signal.SIGINT)  # as a terminal does: to all that were started there
    out, err = process.communicate(timeout=120)
    assert process.returncode == 130
    assert "wrote run.toml" in out
    assert err == f"carom: interrupted; not written: {name}, run.csv\n"
    assert {path.name for path in set(here.iterdir()) - before} == {"run.toml"}


def test_compile_says_what_it_did_and_where(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    took: dict[str, float | None] = {"step_discrete": 21.5, "nearest_many": 1.25}
    monkeypatch.setattr(door, "keep", lambda function, arguments: took.pop(function.__name__, None))
    monkeypatch.setenv("CAROM_CACHE_DIR", str(tmp_path))
    status, out, err = carom_says(capsys, "compile")
    assert (status, err) == (0, "")
    one, other, last = out.splitlines()
    assert (one.split(), other.split()) == (["step", "discrete", "21.5", "s"], ["nearest", "many", "1.2", "s"])
    assert last == f"compiled 2 kernels, 8 kernels were there; all are kept in {cache_folder()}"
    assert carom_says(capsys, "compile") == (0, f"everything is there: 10 kernels in {cache_folder()}\n", "")


def test_compile_says_that_kernels_came_compiled(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(door, "ready_made", lambda function: function)
    monkeypatch.setattr(door, "keep", lambda function, arguments: pytest.fail("nothing is left to compile"))
    assert carom_says(capsys, "compile") == (0, "10 kernels came with carom, compiled\n", "")


def test_compile_fails_where_nothing_can_be_compiled(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("CAROM_COMPILE", "off")
    status, out, err = carom_says(capsys, "compile")
    assert (status, out, err) == (1, "", "carom: nothing is compiled: CAROM_COMPILE is 'off'\n")


TABLE = svg(
    '<rect id="frame" width="90" height="90"/><ellipse id="egg" cx="30" cy="30" rx="20" ry="10"/>'
    '<circle id="ball" cx="60" cy="60" r="5" data-carom-ball="" data-carom-velocity="30 40"/>'
)


@pytest.mark.slow
def test_a_drawing_is_checked_run_and_shown(here: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (here / "table.svg").write_text(TABLE)
    status, out, _ = carom_says(capsys, "check", "table.svg")
    shapes = len(carom.Scene.load("table.svg").shapes)
    assert (status, out) == (0, f"table: good: {shapes} shapes, 4 guard points, 1 ball\n")
    status, out, _ = carom_says(capsys, "run", "table.svg", "--seconds", "1")
    assert (status, "frame" in out) == (0, True)
    assert carom_says(capsys, "show", "table.svg")[0] == 0
    assert carom.Scene.load("table-picture.svg") == carom.Scene.load("table.svg")
    assert (here / "table.svg").read_text() == TABLE


def test_a_drawing_is_converted_to_a_scene_file(here: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (here / "table.svg").write_text(TABLE)
    status, out, _ = carom_says(capsys, "convert", "table.svg", "table.toml", "--tolerance", "0.01")
    assert (status, "wrote table.toml" in out, "1 ball" in out) == (0, True, True)
    assert 'name = "egg"' in (here / "table.toml").read_text()
    fine, coarse = carom.Scene.load("table.toml"), carom.Scene.load("table.svg")
    assert len(fine.shapes) > len(coarse.shapes)


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["good.toml", "a.toml"], "good.toml: its ending must be one of .svg, .dxf"),
        (["table.svg", "a.svg"], "a.svg: its ending must be one of .toml, .json"),
        (["none.svg", "a.toml"], "none.svg: cannot be read: No such file"),
        (["table.svg", "a.toml", "--tolerance", "0"], "--tolerance"),
        (["bad.svg", "a.toml"], "bad.svg: <line> (line 2): data-carom-kik: is unknown; did you mean kick?"),
    ],
)
def test_what_cannot_be_converted_is_said(
    here: Path, capsys: pytest.CaptureFixture[str], arguments: list[str], said: str
) -> None:
    (here / "table.svg").write_text(TABLE)
    (here / "bad.svg").write_text(svg('<line x2="9" data-carom-kik="1"/>'))
    status, _, err = carom_says(capsys, "convert", *arguments)
    assert (status, said in err) == (2, True)
    assert not (here / "a.toml").exists()


def test_a_watched_drawing_is_run_anew_when_it_is_saved(
    here: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    path = here / "table.svg"
    path.write_text(TABLE)
    saves = iter([TABLE.replace('"30 40"', '"30 400"'), "<svg", None, TABLE])

    def save(_: float) -> None:
        text = next(saves, "end")
        if text == "end":
            raise KeyboardInterrupt
        if text is not None:
            path.write_text(text)

    monkeypatch.setattr("carom.cli.watching.sleep", save)
    status, out, err = carom_says(capsys, "run", "table.svg", "--seconds", "0.1", "--watch", "--out", "a.csv")
    assert status == 0
    assert out.count("0.1 s simulated") == out.count("wrote a.csv") == 3
    assert "table.svg: line 1: is not well-formed XML" in err
    assert err.count("watching table.svg; Ctrl-C ends it") == 4
