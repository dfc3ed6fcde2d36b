"""A text that would take too much to read is refused before it is read, one that would not is not."""

import json
from pathlib import Path

import pytest

import carom
from carom import limits


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
