"""What a scene may ask for has limits: at each it is taken, one beyond it is refused by name, in little memory."""

import json
from pathlib import Path
from typing import Any

import pytest

import carom
from carom import limits
from carom.scene import files
from tests import fresh

SETTINGS = {
    "substeps": limits.MOST_SUBSTEPS,
    "iterations": limits.MOST_ITERATIONS,
    "levels": limits.MOST_LEVELS,
    "max_impacts": limits.MOST_IMPACTS,
}


@pytest.mark.parametrize("name", SETTINGS)
def test_settings_have_limits_with_reasons(name: str) -> None:
    most = SETTINGS[name]
    settings: dict[str, Any] = {name: most}
    assert getattr(carom.World(**settings), name) == most
    assert getattr(carom.Scene(world=settings).build(), name) == most
    settings[name] += 1
    with pytest.raises(carom.InvalidArgument, match=rf"^{name} must be from 1 to {most} \(.*\), not {most + 1}$"):
        carom.World(**settings)
    with pytest.raises(carom.SceneError, match=rf"^world\.{name}: must be at most {most} \(.*\), not {most + 1}$"):
        carom.Scene(world=settings)


@pytest.mark.slow
@pytest.mark.parametrize("ending", [".toml", ".json"])
def test_the_length_of_a_file(tmp_path: Path, ending: str) -> None:
    path = tmp_path / f"scene{ending}"
    text = b"version = 1 #" if ending == ".toml" else b'{"version": 1}'
    path.write_bytes(text + b" " * (limits.LONGEST_FILE - len(text)))
    assert carom.Scene.load(path) == carom.Scene()
    with path.open("ab") as file:
        file.write(b" ")
    with pytest.raises(carom.SceneError, match=rf"scene\{ending}: is longer than {limits.LONGEST_FILE} bytes$"):
        carom.Scene.load(path)


@pytest.mark.parametrize("ending", [".toml", ".json"])
def test_what_could_not_be_loaded_is_not_saved(tmp_path: Path, ending: str, monkeypatch: pytest.MonkeyPatch) -> None:
    path = tmp_path / f"scene{ending}"
    scene = carom.Scene(name="x" * 500)
    scene.save(path)
    length = path.stat().st_size
    monkeypatch.setattr(files, "LONGEST_FILE", length)
    scene.save(path)
    assert carom.Scene.load(path) == scene
    monkeypatch.setattr(files, "LONGEST_FILE", length - 1)
    with pytest.raises(carom.SceneError, match=f"would be longer than the {length - 1} bytes that can be read again$"):
        scene.save(path)
    assert path.stat().st_size == length


HOSTILE = """
import resource, sys, time
from pathlib import Path
import carom
from tests.unit.scene.test_limits import ATTACKS
resource.setrlimit(resource.RLIMIT_AS, (1_500_000_000, 1_500_000_000))
path = Path(sys.argv[1])
for name, (ending, make) in ATTACKS.items():
    file = path / ("scene" + ending)
    file.write_text("version = 1\\n" + make() if ending == ".toml" else make(), encoding="utf-8")
    try:
        carom.Scene.load(file)
        said = "taken"
    except carom.SceneError as error:
        said = str(error)
    print(name, len(said), said.count("\\n"), sep="|")
"""

MANY = 100_000
ATTACKS: dict[str, tuple[str, Any]] = {
    "parts of a name": (".toml", lambda: ".".join(["a"] * 20_000) + " = 1"),
    "parts of a heading": (".toml", lambda: "[" + ".".join(["a"] * 20_000) + "]"),
    "names with dots": (".toml", lambda: "\n".join(f"a{k}.b.c.d.e.f.g = 1" for k in range(MANY))),
    "headings": (".toml", lambda: "\n".join(f"[a{k}.b.c.d.e.f]" for k in range(MANY))),
    "lists": (".toml", lambda: "\n".join(f"a{k} = []" for k in range(MANY))),
    "brackets": (".toml", lambda: "a = " + "[" * 5_000_000),
    "braces": (".toml", lambda: "a = " + "{a=" * 300_000),
    "quotes": (".toml", lambda: 'a = "' + '\\"' * 500_000),
    "long quotes": (".toml", lambda: 'a = """' + '\\""" ' * 300_000),
    "quotes without ends": (".toml", lambda: "a = '\n" * 300_000),
    "a word": (".toml", lambda: "a" * 5_000_000),
    "blanks": (".toml", lambda: "a" + ". " * 100 + " " * 5_000_000 + "b"),
    "digits": (".toml", lambda: "guard = 0x" + "f" * 300_000),
    "a long name": (".toml", lambda: f'"{"x" * 1_000_000}" = 1'),
    "JSON brackets": (".json", lambda: "[" * 5_000_000),
    "JSON braces": (".json", lambda: '{"a":' * 300_000),
    "JSON quotes": (".json", lambda: '{"a": "' + '\\"' * 500_000),
    "empty shapes": (".json", lambda: '{"version": 1, "shapes": [' + "{}," * MANY + "{}]}"),
    "empty balls": (".json", lambda: '{"version": 1, "balls": [' + "{}," * MANY + "{}]}"),
    "empty parts": (
        ".json",
        lambda: '{"version": 1, "shapes": [{"kind": "compound", "pivot": [0, 0], "shapes": [' + "{}," * MANY + "{}]}]}",
    ),
    "strange names": (
        ".json",
        lambda: '{"version": 1, "balls": [{' + ",".join(f'"{k}":1' for k in range(MANY)) + "}]}",
    ),
    "strange tables": (
        ".json",
        lambda: json.dumps({"version": 1, "balls": [{f"a{k}": k for k in range(limits.MOST_NAMES)}] * 5000}),
    ),
    "long values": (
        ".json",
        lambda: json.dumps({"version": 1, "balls": [{"position": [0] * 50_000, "radius": 1}] * 20}),
    ),
    "long texts": (".json", lambda: json.dumps({"version": 1, "guard": "x" * 5_000_000, "y" * 5_000_000: 1})),
    "wide depth": (".json", lambda: '{"version":' + ("[" * 14 + "]" * 14 + ",") * 3 + "1}"),
    "numbers": (".json", lambda: '{"version": 1, "balls": [' + "1," * MANY + "1]}"),
}


@pytest.mark.slow
def test_hostile_files_are_refused_in_little_memory(tmp_path: Path) -> None:
    lines = fresh.printed(HOSTILE, str(tmp_path)).splitlines()
    told = {name: (int(length), int(breaks)) for name, length, breaks in (line.split("|") for line in lines)}
    assert told.keys() == ATTACKS.keys()
    for name, (length, breaks) in told.items():
        assert 30 < length < 200 * (limits.MOST_FAULTS + 2), name
        assert breaks <= limits.MOST_FAULTS + 1, name
