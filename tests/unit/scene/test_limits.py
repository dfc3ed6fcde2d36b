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


def loaded(tmp_path: Path, text: str, ending: str) -> str:
    """What loading a text says: "taken", or the first line of what is wrong, without the file's name."""
    path = tmp_path / f"scene{ending}"
    path.write_text(text, encoding="utf-8")
    try:
        carom.Scene.load(path)
    except carom.SceneError as error:
        return str(error).removeprefix(f"{path}: ").partition("\n")[0]
    return "taken"


def nested(text: str, opened: str, closed: str, levels: int) -> str:
    """A text in so many brackets."""
    return opened * levels + text + closed * levels


@pytest.mark.parametrize("beyond", [0, 1])
@pytest.mark.parametrize("opened", ["[", "{ x = "])
def test_depth_of_toml(tmp_path: Path, opened: str, beyond: int) -> None:
    text = nested("1", opened, "]" if opened == "[" else "}", limits.DEEPEST + beyond)
    said = loaded(tmp_path, f"version = {text}", ".toml")
    assert said.startswith(f"nested too deeply: more than {limits.DEEPEST} levels" if beyond else "version: must be 1")


@pytest.mark.parametrize("beyond", [0, 1])
@pytest.mark.parametrize("opened", ["[", '{"x": '])
def test_depth_of_json(tmp_path: Path, opened: str, beyond: int) -> None:
    text = nested("1", opened, "]" if opened == "[" else "}", limits.DEEPEST - 1 + beyond)
    said = loaded(tmp_path, f'{{"version": {text}}}', ".json")
    assert said.startswith(f"nested too deeply: more than {limits.DEEPEST} levels" if beyond else "version: must be 1")


@pytest.mark.parametrize("part", ["a", '"a"', "'a.b'", '"[["'])
@pytest.mark.parametrize("form", ["{} = 1", "[{}]", "[[{}]]", "world = {{ {} = 1 }}"])
@pytest.mark.parametrize("beyond", [0, 1])
def test_parts_of_a_name(tmp_path: Path, form: str, part: str, beyond: int) -> None:
    name = " . ".join([part] * (limits.DEEPEST + beyond))
    said = loaded(tmp_path, f"version = 1\n{form.format(name)}", ".toml")
    too_many = f"nested too deeply: a name of more than {limits.DEEPEST} parts"
    assert (said == too_many) == bool(beyond)


@pytest.mark.parametrize(
    "value",
    ['"{}"', "'{}'", '"""\n{}"""', "'''\n{}'''", '"{}\\" {}"', '"""{} \\""" {}"""', '""""{}"""""', "''''{}'''''"],
)
@pytest.mark.parametrize("inside", ["[" * 99, ".a" * 99, "# \\\\", "]" * 99 + "[", "'", "{"])
def test_what_stands_in_strings_and_comments_counts_for_nothing(tmp_path: Path, value: str, inside: str) -> None:
    if value.startswith("'") and "'" in inside:
        inside = "[" * 20
    text = f"version = 1 # {inside} ' \" [[[[[[[[[[[[[[[[[[[[[\nname = {value.replace('{}', inside)}"
    assert loaded(tmp_path, text, ".toml") == "taken"
    assert loaded(tmp_path, json.dumps({"version": 1, "name": f'"{inside}\\" {inside}'}), ".json") == "taken"


KEYS: dict[str, str] = {
    "names": "k{0} = 1",
    "headings": "[k{0}]",
    "lists of tables": "[[k{0}]]",
    "names with dots": "[[x]]\ny.z = 1",
    "quoted names": '[[x]]\n"k{0}" = 1',
    "quoted headings": '["k{0}"]',
}


@pytest.mark.parametrize("kind", KEYS)
@pytest.mark.parametrize("beyond", [0, 1])
def test_different_names_of_a_toml_file(tmp_path: Path, kind: str, beyond: int) -> None:
    lines = [KEYS[kind].format(number) for number in range(limits.MOST_KEYS)]
    # `version`, and the heading of the list where there is one, count too.
    others = 1 + ("[[x]]" in KEYS[kind])
    said = loaded(tmp_path, "\n".join(["version = 1", *lines[: limits.MOST_KEYS - others + beyond]]), ".toml")
    too_many = f"has more than {limits.MOST_KEYS} different names and names with dots: {limits.MOST_KEYS + 1}"
    assert (said == too_many) == bool(beyond), said


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


PLACES: dict[str, Any] = {
    "": lambda table: table,
    "world": lambda table: {"world": table},
    "balls[0]": lambda table: {"balls": [table]},
    "shapes[0]": lambda table: {"shapes": [table]},
}


@pytest.mark.parametrize("place", PLACES)
@pytest.mark.parametrize("beyond", [0, 1])
def test_names_in_a_table(place: str, beyond: int) -> None:
    good = {"kind": "point", "position": (0, 0)} if "shapes" in place else {}
    good |= {"position": (0, 0), "radius": 1} if "balls" in place else {}
    count = limits.MOST_NAMES - len(good) - (place == "")
    table = good | {f"x{number}": 1 for number in range(count + beyond)}
    with pytest.raises(carom.SceneError) as caught:
        carom.Scene(**PLACES[place](table))
    crowd = f"must have at most {limits.MOST_NAMES} names, not {limits.MOST_NAMES + 1}"
    told = ": ".join(filter(None, (place, crowd)))
    assert (str(caught.value) == told) if beyond else str(caught.value).startswith(f"{count} faults\n")


@pytest.mark.parametrize("count", [1, 2, limits.MOST_FAULTS, limits.MOST_FAULTS + 1, 1234])
@pytest.mark.parametrize("kind", ["balls", "shapes", "parts", "lists"])
def test_the_first_faults_are_told_and_all_are_counted(kind: str, count: int) -> None:
    good, bad = {"kind": "circle", "center": (0, 0), "radius": 1}, {"kind": "circle", "center": (0, 0), "radius": -1}
    table: dict[str, Any] = {"shapes": [good, *[bad] * count]}
    path = "shapes[{}].radius"
    if kind == "balls":
        table, path = {"balls": [{"position": (0, 0), "radius": r} for r in (1, *[-1] * count)]}, "balls[{}].radius"
    elif kind == "parts":
        table = {"shapes": [good, {"kind": "compound", "pivot": (0, 0), **table}]}
        path = "shapes[1].shapes[{}].radius"
    elif kind == "lists":
        table |= {"colour": 1, "balls": 3, "version": 2}
    with pytest.raises(carom.SceneError) as caught:
        carom.Scene(**table)
    heading, *lines = str(caught.value).split("\n  ")
    before = ["version: must be 1, not 2", "balls: must be a list, not 3"] if kind == "lists" else []
    after = ["colour: is unknown"] if kind == "lists" else []
    faults = [*before, *[f"{path.format(1 + number)}: must be positive, not -1" for number in range(count)], *after]
    if len(faults) == 1:
        assert [heading, *lines] == faults
        return
    more = len(faults) - limits.MOST_FAULTS
    assert heading == f"{len(faults)} faults"
    assert lines == faults[: limits.MOST_FAULTS] + ([f"and {more} more"] if more > 0 else [])


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
