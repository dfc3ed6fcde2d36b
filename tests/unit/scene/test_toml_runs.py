"""Long runs of tables are read as TOML's own reader does, and without it."""

import tomllib
from typing import Any

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from carom.scene import toml_runs

quick = settings(suppress_health_check=[HealthCheck.function_scoped_fixture, HealthCheck.too_slow])
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


@pytest.mark.slow
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
