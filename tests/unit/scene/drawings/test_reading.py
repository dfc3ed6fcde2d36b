"""Files of drawings as scenes: tolerances, joints, and how long it takes."""

import gc
import subprocess
import sys
import tracemalloc
from pathlib import Path

import pytest

import carom
from carom import draw
from carom.scene.descriptors import WorldDescriptor
from carom.scene.drawings import reading
from carom.scene.drawings.bodies import Body, Drawing
from carom.scene.drawings.converting import converted
from carom.scene.drawings.pieces import Cubic
from carom.scene.drawings.svg import SvgReader
from carom.scene.faults import Faults
from tests.clock import soon
from tests.drawings import drawn, loaded, refusal, svg
from tests.unit.scene.everything import world_of_everything


def arcs_of(scene: carom.Scene) -> int:
    """How many arcs a scene has."""
    return sum(shape.kind == "arc" for shape in scene.shapes)


ELLIPSE = '<ellipse cx="50" cy="50" rx="40" ry="20"/>'


def test_curves_are_as_near_as_they_are_told(tmp_path: Path) -> None:
    default = drawn(tmp_path, ELLIPSE)
    assert arcs_of(default) == arcs_of(loaded(tmp_path, svg(ELLIPSE), tolerance=0.08))
    finer = loaded(tmp_path, svg(ELLIPSE), tolerance=1e-4)
    assert arcs_of(finer) > 2 * arcs_of(default)
    assert arcs_of(finer) == arcs_of(drawn(tmp_path, ELLIPSE, 'width="100" height="100" data-carom-tolerance="1e-4"'))


def test_a_tolerance_must_be_positive_and_is_for_drawings(tmp_path: Path) -> None:
    with pytest.raises(carom.InvalidArgument, match="tolerance must be positive"):
        loaded(tmp_path, svg(ELLIPSE), tolerance=0.0)
    assert "data-carom-tolerance: must be positive, not 0.0" in refusal(tmp_path, ELLIPSE, 'data-carom-tolerance="0"')
    default = carom.Scene()
    default.save(tmp_path / "a.toml")
    with pytest.raises(carom.InvalidArgument, match="tolerance is for drawings"):
        carom.Scene.load(tmp_path / "a.toml", tolerance=0.1)


def test_a_picture_that_keeps_its_scene_has_no_use_for_a_tolerance(tmp_path: Path) -> None:
    scene = carom.scenes.newtons_cradle()
    path = tmp_path / "cradle.svg"
    path.write_text(draw.svg(draw.picture_of(scene.build()), scene=scene), encoding="utf-8")
    assert carom.Scene.load(path) == converted(path) == scene
    for read in (carom.Scene.load, converted):
        with pytest.raises(carom.InvalidArgument, match=r"tolerance 0\.1: is for drawings that others made"):
            read(path, 0.1)


def test_smooth_joints_get_no_guard_point_and_corners_do(tmp_path: Path) -> None:
    # A curve with three digits whose handles are in line but for rounding, and a corner.
    curve = '<path d="M 10 50 C 20 20.001 40 10 50 20 C 60.003 30.001 70 40 80 20 L 90 50"/>'
    world = drawn(tmp_path, curve).build()
    points = [shape.position for shape in world.shapes if shape.kind == "point"]
    assert points == [pytest.approx(place) for place in ((10.0, 50.0), (80.0, 80.0), (90.0, 50.0))]


def test_elements_that_nearly_meet_are_joined(tmp_path: Path) -> None:
    lines = '<line x1="0" y1="0" x2="50" y2="0"/><line x1="50.02" y1="0.01" x2="90" y2="40"/>'
    world = drawn(tmp_path, lines).build()
    assert sum(shape.kind == "point" for shape in world.shapes) == 3


def test_compounds_are_joined_by_themselves(tmp_path: Path) -> None:
    scene = drawn(
        tmp_path,
        '<g data-carom-pivot="0 0"><line x2="50"/></g><line x1="50.02" x2="90" y2="40"/>',
    )
    assert scene.shapes[1].start == (50.02, 100.0)


def test_a_picture_of_a_scene_is_that_scene(tmp_path: Path) -> None:
    scene = carom.Scene.from_world(world_of_everything())
    text = draw.svg(draw.picture_of(scene.build(), "Everything"), scene=scene)
    assert repr(loaded(tmp_path, text)) == repr(scene)


def test_a_picture_of_a_run_is_no_drawing(tmp_path: Path) -> None:
    run = carom.Recording.of(carom.scenes.newtons_cradle().build(), seconds=0.1)
    for theme in draw.ThemeName:
        with pytest.raises(carom.SceneError, match=r"<svg> \(line 1\): is a picture of a run, which keeps no scene"):
            loaded(tmp_path, draw.svg(draw.picture_at(run, 3), theme))


def test_files_that_cannot_be_read_say_why(tmp_path: Path) -> None:
    for name, said in (("none.svg", "cannot be read: No such file"), ("folder.svg", "cannot be read: Is a directory")):
        (tmp_path / "folder.svg").mkdir(exist_ok=True)
        with pytest.raises(carom.SceneError, match=f"{name}: {said}"):
            carom.Scene.load(tmp_path / name)


def test_a_file_that_is_too_long_is_refused(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(reading, "LONGEST_FILE", 100)
    assert "is longer than 100 bytes" in refusal(tmp_path, " " * 100)


def test_drawings_are_known_by_their_endings() -> None:
    assert reading.is_drawing("a.SVG")
    assert reading.is_drawing(Path("a.dxf"))
    assert not reading.is_drawing("a.toml")
    assert not reading.is_drawing(3)


@pytest.mark.parametrize(("ending", "package"), [(".svg", "svgelements"), (".dxf", "ezdxf")])
def test_a_missing_package_is_asked_for(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, ending: str, package: str
) -> None:
    monkeypatch.setitem(sys.modules, package, None)
    with pytest.raises(carom.MissingExtra, match=rf'need {package}: pip install "carom\[drawings\]"'):
        loaded(tmp_path, svg(ELLIPSE), ending)


def test_curves_that_would_become_too_many_arcs_are_refused_before_they_do(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(reading, "MOST_ARCS", 10.0)
    curves = "\n".join(f'<path id="c{k}" d="M 0 {k} c 20 9 30 -9 50 0"/>' for k in range(9))
    said = refusal(tmp_path, curves, 'width="100" height="100" data-carom-tolerance="1"')
    assert '<path id="c2"> (line 4): the curves up to here need more than 10.0 arcs at a tolerance of 1' in said
    monkeypatch.setattr(reading, "MOST_ARCS", 50.0)
    assert len(drawn(tmp_path, curves, 'width="100" height="100" data-carom-tolerance="1"').shapes) >= 18


def test_a_hundred_thousand_curves_are_let_through_and_refused_at_once_where_they_are_followed_closely(
    tmp_path: Path,
) -> None:
    body = Body("", None, {}, outlines=[[Cubic((0.0, 0.0), (3.0, 1.0), (5.0, -1.0), (8.0, 0.0))]])
    reading._refuse_many([body] * 100_000, 3.0)
    with soon(), pytest.raises(carom.SceneError, match="a larger tolerance needs fewer"):
        reading._refuse_many([body] * 100_000, 3e-3)


@pytest.mark.slow
@pytest.mark.parametrize("count", [40_000, 70_000])
def test_where_some_of_many_curves_say_that_they_are_too_many_arcs_the_rest_is_not_read(
    tmp_path: Path, count: int
) -> None:
    curves = "".join(f'<path d="M{k % 97} 0C30 {k % 89} {k % 83} 90 90 {k % 79}"/>' for k in range(count))
    with soon():
        said = refusal(tmp_path, curves)
    assert "<svg> (line 1): the curves need about" in said
    assert "a larger tolerance needs fewer" in said


def test_a_sample_is_believed_where_it_is_sure_and_the_page_is_as_large_as_it_says(tmp_path: Path) -> None:
    path = tmp_path / "a.svg"
    path.write_text(svg('<path d="M1 0C30 50 20 90 90 70"/>' * 20_000, 'width="100" height="100"'))
    reader = SvgReader(path.read_bytes(), Drawing(Faults(WorldDescriptor)))
    sample = reader.sample()
    assert sample is not None
    assert (sample.share, sample.page) == (0.3, 100.0)
    assert 5000 < len(sample.drawing.bodies) < 7000
    reading._refuse_sampled(sample, 0.5)
    reading._refuse_sampled(sample._replace(page=1e6), None)
    with pytest.raises(carom.SceneError, match="a larger tolerance needs fewer"):
        reading._refuse_sampled(sample, 1e-3)
    path.write_text(svg('<path d="M1 0C30 50 20 90 90 70"/>' * 9000))
    assert SvgReader(path.read_bytes(), Drawing(Faults(WorldDescriptor))).sample() is None


MANY = """
import sys, time
from pathlib import Path
import carom
began = time.process_time()
scene = carom.Scene.load(sys.argv[1])
status = Path("/proc/self/status").read_text().split()  # what getrusage tells may be of the process that started this
print(len(scene.shapes), time.process_time() - began, int(status[status.index("VmHWM:") + 1]) / 1000)
"""


@pytest.mark.parametrize(
    "fault",
    [
        '<line x1="q" x2="3"/>',
        '<g><g><line x2="3" data-carom-kick="-1"/></g></g>',
        '<line x2="3" data-carom-mass="1"/>',
    ],
)
def test_a_drawing_is_not_looked_at_any_more_once_there_are_faults_enough(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, fault: str
) -> None:
    monkeypatch.setattr(reading, "ENOUGH_FAULTS", 50)
    said = refusal(tmp_path, fault * 49).splitlines()
    assert said[0].endswith(": 49 faults")
    assert said[-1] == "  and 9 more"
    for count in (50, 60):
        said = refusal(tmp_path, f"<g>{fault * count}</g>").splitlines()
        assert said[0].endswith(": 50 faults, and what comes after them was not looked at")
        assert said[-1] == "  and 10 more"
        assert len(said) == 42


@pytest.mark.slow
@pytest.mark.parametrize("wrong", ['y2="q"', 'y2="2" data-carom-kick="-1"', 'y2="2" data-carom-kik="1"'])
def test_a_hundred_thousand_faults_are_told_soon_of_the_processor(tmp_path: Path, wrong: str) -> None:
    path = tmp_path / "a.svg"
    path.write_text(svg("".join(f'<line id="a{k}" x1="{k}" {wrong}/>' for k in range(100_000))))
    with soon(), pytest.raises(carom.SceneError, match="1000 faults, and what comes after them was not looked at"):
        carom.Scene.load(path)


def test_what_is_made_of_a_drawing_counts_as_old_garbage_and_what_is_frozen_stays_frozen(tmp_path: Path) -> None:
    lines = "".join(f'<line x1="{k}" y1="0" x2="{k}" y2="9"/>' for k in range(3000))
    for frozen in (False, True):
        gc.collect()  # so that none is due soon
        if frozen:
            gc.freeze()
        count = gc.get_freeze_count()
        try:
            scene = drawn(tmp_path, lines)
            assert gc.isenabled()
            assert gc.get_freeze_count() >= 0.9 * count  # some die meanwhile
            # Python 3.12 begins with some that are frozen.
            assert count > 0 or any(one is scene.shapes[7] for one in gc.get_objects(generation=2))
        finally:
            gc.unfreeze()


def test_elements_with_as_many_different_options_take_little_room(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(reading, "LONGEST_FILE", 10**6)  # that much is set aside for the file
    place = '<rect x="{0}" y="{1}" width="5" height="4" data-carom-elasticity="{2}" id="a{0}"/>'
    rectangles = "".join(place.format(9 * (k % 50), 9 * (k // 50), 0.001 * k) for k in range(1, 1001))
    tracemalloc.start()
    try:
        scene = drawn(tmp_path, rectangles)
        _, most = tracemalloc.get_traced_memory()
    finally:
        tracemalloc.stop()
    assert len(scene.shapes) == 4000
    assert most < 4_000_000


@pytest.mark.slow
@pytest.mark.skipif(not Path("/proc/self/status").exists(), reason="only Linux says how much memory a process has had")
def test_a_hundred_thousand_elements_take_seconds_and_no_more_than_their_room(tmp_path: Path) -> None:
    kinds = (
        '<line id="a{0}" x1="{1}" y1="{2}" x2="{3}" y2="{2}"/>',
        '<circle id="a{0}" cx="{1}" cy="{2}" r="2"/>',
        '<path id="a{0}" d="M {1} {2} H {3} "/>',
        '<polyline id="a{0}" points="{1},{2} {3},{2}"/>',
        '<path id="a{0}" d="M {1} {2} c 1 -1.5 3 2.5 5 0.5"/>',
    )
    places = ((k, 9 * (k % 317), 9 * (k // 317), 9 * (k % 317) + 5) for k in range(100_000))
    path = tmp_path / "many.svg"
    path.write_text(svg("\n".join(kinds[place[0] % 5].format(*place) for place in places)))
    told = subprocess.run([sys.executable, "-c", MANY, path], capture_output=True, text=True, check=True).stdout
    count, seconds, megabytes = map(float, told.split())
    assert count >= 100_000  # of a curve there are two or three
    assert megabytes < 500.0
    assert seconds < 30.0  # 10 on a machine of its own
