"""What is said of misspelt commands, options and values that are some few, and what stands in the help.

The commands are walked, so one that is added is tried here too.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
import typer

import carom
from carom.cli import app, files, games
from carom.draw import Layer, ThemeName
from tests.unit.cli.saying import carom_says

#: The commands as typer has them, and the root's own options below "".
ROOT: Any = typer.main.get_command(app.app)
COMMANDS: dict[str, Any] = {"": ROOT, **ROOT.commands}
#: The option by which each kind of value is given, the values, and what is said where none is near.
CHOICES: dict[str, tuple[str, list[str]]] = {
    "theme": ("--theme", [theme.value for theme in ThemeName]),
    "layers": ("--layers", [*(layer.value for layer in Layer), "all"]),
}
#: The endings of what each command writes, and what else it must be given.
ENDINGS: dict[str, tuple[tuple[str, ...], tuple[str, ...]]] = {
    "run": (("toy",), files.OF_RUN),
    "show": (("toy",), files.OF_SCENE),
    "toy": (("--chart",), games.CHARTS),
}


def misspelt(word: str) -> str:
    """A word with its last letter twice."""
    return word + word[-1]


def options_of(name: str) -> list[str]:
    """The options of a command."""
    return [option for parameter in COMMANDS[name].params for option in parameter.opts if option.startswith("--")]


def told(capsys: pytest.CaptureFixture[str], *arguments: str) -> str:
    """The one line that is said of a mistake."""
    status, out, err = carom_says(capsys, *arguments)
    assert (status, out) == (2, "")
    assert err.startswith("carom: ")
    assert err.count("\n") == 1
    assert err.isascii()
    return err.strip()


#: The commands, and the options of theirs whose values are some few.
CHOSEN = [(name, one.name) for name, command in COMMANDS.items() for one in command.params if one.name in CHOICES]


@pytest.fixture(autouse=True)
def elsewhere(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """An empty folder to work in."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("COLUMNS", "80")


def test_the_values_of_all_options_that_have_some_few_are_tried() -> None:
    assert set(CHOSEN) == {(command, kind) for command in ("run", "show") for kind in CHOICES}
    written = {name for name, command in COMMANDS.items() if any(p.name == "out" for p in command.params)}
    assert written == {*ENDINGS, "sweep"}  # which writes a folder


@pytest.mark.parametrize(("command", "kind"), CHOSEN)
def test_a_misspelt_value_is_told_with_the_one_that_was_meant(
    command: str, kind: str, capsys: pytest.CaptureFixture[str]
) -> None:
    option, values = CHOICES[kind]
    for value in values:
        for wrong in (misspelt(value), value.upper()):
            said = told(capsys, command, "toy", option, wrong)
            assert said.startswith(f"carom: {option} {wrong}: no such ")
            assert said.endswith(f"; did you mean {value}?")
    assert told(capsys, command, "toy", option, "qqq").endswith(f"; there are {', '.join(values)}")


@pytest.mark.slow
@pytest.mark.parametrize("command", ["run", "show", "check"])
def test_a_misspelt_scene_is_told_with_the_one_that_was_meant(command: str, capsys: pytest.CaptureFixture[str]) -> None:
    for name in carom.scenes.names():
        for wrong in (misspelt(name), name.upper()):
            assert told(capsys, command, wrong).endswith(f"; did you mean {name}?")
    assert told(capsys, command, "qqq").endswith(f"; shipped are {', '.join(carom.scenes.names())}")


@pytest.mark.parametrize("command", ENDINGS)
def test_a_misspelt_ending_is_told_with_the_one_that_was_meant(
    command: str, capsys: pytest.CaptureFixture[str]
) -> None:
    arguments, endings = ENDINGS[command]
    for ending in endings:
        said = told(capsys, command, *arguments, "--out", "file" + misspelt(ending))
        assert said.endswith(f"one of {', '.join(endings)}; did you mean {ending}?")
    assert told(capsys, command, *arguments, "--out", "file").endswith(f"one of {', '.join(endings)}")


@pytest.mark.parametrize("command", COMMANDS)
def test_a_misspelt_option_is_told_with_the_one_that_was_meant(
    command: str, capsys: pytest.CaptureFixture[str]
) -> None:
    words = [command] if command else []
    for option in [*options_of(command), "--help"]:
        wrong = misspelt(option)
        assert told(capsys, *words, wrong) == f"carom: {wrong}: no such option; did you mean {option}?"
    assert told(capsys, *words, "--qqq") == f"carom: --qqq: no such option; see {' '.join(['carom', *words])} --help"


def test_a_misspelt_command_is_told_with_the_one_that_was_meant(capsys: pytest.CaptureFixture[str]) -> None:
    for command in ROOT.commands:
        wrong = misspelt(command)
        assert told(capsys, wrong, "toy") == f"carom: {wrong}: no such command; did you mean {command}?"
    assert told(capsys, "qqq") == f"carom: qqq: no such command; there are {', '.join(ROOT.commands)}"


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (("run",), "missing argument 'SCENE'; see carom run --help"),
        (("scenes", "x"), "(x); see carom scenes --help"),
        (("show", "toy", "--at"), "option '--at' requires an argument; see "),
        (("toy", "--chart", "--seconds", "3"), "--seconds 3: is for playing, not for --chart"),
        (("toy", "--out", "x.svg"), "--out x.svg: is for --chart"),
    ],
)
def test_what_the_options_do_not_allow_is_told_in_one_line_too(
    arguments: tuple[str, ...], said: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert said in told(capsys, *arguments)


def test_without_a_command_there_is_help_and_it_is_a_mistake(capsys: pytest.CaptureFixture[str]) -> None:
    status, out, err = carom_says(capsys)
    assert (status, out) == (2, "")
    assert err == carom_says(capsys, "--help")[1]


@pytest.mark.parametrize("command", COMMANDS)
def test_the_help_is_for_people(command: str, capsys: pytest.CaptureFixture[str]) -> None:
    status, out, err = carom_says(capsys, *([command] if command else []), "--help")
    assert (status, err) == (0, "")
    assert "<" not in out, "a type of the program's"
    assert "\\" not in out
    assert "[default" not in out, "some versions of typer write it with a backslash"
    assert "..." not in out.partition("\n")[2], "what a command does is told to its end"
    assert max(map(len, out.splitlines())) <= 80
    for option in options_of(command):
        assert out.count(f"  {option} ") == 1
    if "SCENE" in out.partition("\n")[0]:
        assert "SCENE is a scene file" in out
