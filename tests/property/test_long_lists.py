"""The quick ways with long lists do what the slow ways do: the same scenes, worlds and faults, to the bit and word."""

import re
import tomllib
from typing import Any

import pytest
import tomli_w
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

import carom
from carom.scene import files, lists, scene, toml_runs
from carom.scene.balls import described_balls
from carom.scene.capture import described
from carom.scene.descriptors import BallDescriptor
from tests.property.test_scene import balls, changed, nothing_good, places, scene_or_words, tables_of_scenes

quick = settings(suppress_health_check=[HealthCheck.function_scoped_fixture, HealthCheck.too_slow])


@quick
@given(tables_of_scenes, st.data())
def test_lists_in_blocks_have_the_faults_that_they_have_as_a_whole(
    monkeypatch: pytest.MonkeyPatch, table: dict[str, Any], data: st.DataObject
) -> None:
    for _ in range(data.draw(st.integers(0, 3))):
        path = data.draw(st.sampled_from(places(table)[1:] or [("guard",)]))
        table = changed({"guard": False} | table, path, data.draw(nothing_good))
    monkeypatch.setattr(scene, "LISTS", ())
    whole = scene_or_words(carom.Scene, **table)
    monkeypatch.setattr(scene, "LISTS", lists.LISTS)
    for block in (1, 2, 500):
        monkeypatch.setattr(lists, "BLOCK", block)
        assert repr(scene_or_words(carom.Scene, **table)) == repr(whole)


@given(st.lists(balls, max_size=5))
def test_balls_are_added_at_once_as_they_are_one_by_one(tables: list[dict[str, Any]]) -> None:
    made = carom.Scene(balls=tables)
    world, other = made.build(), carom.World()
    for ball in made.balls:
        other.add(ball.build())
    assert world.digest() == other.digest()
    assert [ball.name for ball in world.balls] == [ball.name for ball in made.balls]


@given(st.lists(balls, max_size=5))
def test_balls_of_a_world_are_described_at_once_as_they_are_one_by_one(tables: list[dict[str, Any]]) -> None:
    world = carom.Scene(balls=tables).build()
    assert all(ball.keys() == BallDescriptor.model_fields.keys() for ball in described_balls(world))
    assert repr(carom.Scene.from_world(world).balls) == repr(tuple(described(ball) for ball in world.balls))


def test_a_ball_that_no_number_can_hold_is_a_fault_of_the_scene() -> None:
    with pytest.raises(
        carom.SceneError, match=r"^balls\[0\]\.position: must leave the ball's box finite, not \(1e\+308"
    ):
        carom.Scene(balls=[{"position": (1e308, 0), "radius": 1e308}])


@given(tables_of_scenes)
def test_a_scene_is_written_as_by_the_slow_writer(table: dict[str, Any]) -> None:
    plain = carom.Scene(**table).plain()
    slow = re.sub(r"\[\n((?: *[-+.\w]+,\n)+) *\]", files._on_one_line, tomli_w.dumps(plain))
    assert files._to_toml(plain) == slow


lines = st.sampled_from(
    [
        "radius = 1",
        "radius = -0",
        "radius = 1.50",
        "radius = 1e3",
        "radius = 1E-3",
        "radius = 123456789012345678",
        "radius = 1234567890123456789",
        "radius = 1e999",
        "radius = 1_000",
        "radius = +1",
        "radius = 01",
        "radius = inf",
        "radius=1",
        "position = [1, 2.0]",
        "position = [ -1.5,2 ]",
        "position = [1, 2,]",
        "position = [1, 2, 3]",
        "position = [\n[[balls]]\n]",
        "sensor = true",
        "sensor = True",
        'name = "a, b.c_d-9"',
        'name = "},{"',
        'name = "a = 1"',
        "name = 'a'",
        'name = """',
        '"""',
        "name = '''\n",
        "x.y = 1",
        "# radius = 2",
        "",
        "[balls.more]",
        "[[balls.more]]",
        "[balls]",
        "[[balls]] # a comment",
        "[[ balls ]]",
        "[[shapes]]",
        "[world]",
        "balls = []",
        '"run:balls" = 1',
    ]
)
plain = st.lists(st.sampled_from(["radius = 1", "position = [1, 2]", 'name = "a"']), min_size=1, unique=True)
run = st.lists(plain.map(lambda given: "\n".join(["[[balls]]", *given])), min_size=3, max_size=6).map("\n\n".join)
texts = st.lists(st.one_of(lines, run, run.map(lambda text: text.replace("balls", "shapes"))), max_size=8)


@quick
@given(texts.map("\n".join), st.sampled_from(["\n", ""]), st.integers(1, 3))
def test_toml_with_runs_is_read_as_by_its_own_reader(
    monkeypatch: pytest.MonkeyPatch, text: str, end: str, shortest: int
) -> None:
    monkeypatch.setattr(toml_runs, "_RUN", toml_runs.run_of(shortest))
    monkeypatch.setattr(toml_runs, "SHORTEST_RUN", shortest)

    def said(read: Any) -> str:
        try:
            return repr(read(text + end))
        except tomllib.TOMLDecodeError as error:
            return str(error)

    assert said(toml_runs.read_toml) == said(tomllib.loads)


def test_long_runs_are_read_without_the_slow_reader(monkeypatch: pytest.MonkeyPatch) -> None:
    ball, shape = "[[balls]]\nradius = 1\nposition = [0.5, 1]\n\n", '[[shapes]]\nkind = "point"\nposition = [1, 2]\n'
    text = "version = 1\n" + shape * 2000 + "[world]\nsubsteps = 3\n" + ball * 2000 + "[[balls]]\nradius = 2 # odd\n"
    seen = []

    def slow(given: str) -> dict[str, Any]:
        seen.append(len(given))
        return tomllib_loads(given)

    tomllib_loads = tomllib.loads
    monkeypatch.setattr(tomllib, "loads", slow)
    table = toml_runs.read_toml(text)
    assert sum(seen) < 500
    assert table == tomllib_loads(text)
