"""The commands that open games: what they print, what they need, how they exit."""

import sys
from pathlib import Path

import pytest

from tests.unit.cli.saying import carom_says

pytest.importorskip("pygame", reason='no pygame: pip install "carom[play]"')

GAMES = ("toy", "pinball", "pool")


@pytest.fixture(autouse=True)
def here(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder to work in, with a home of its own, and neither screen nor sound card."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("XDG_DATA_HOME", str(tmp_path / "data"))
    monkeypatch.setenv("SDL_VIDEODRIVER", "dummy")
    monkeypatch.setenv("SDL_AUDIODRIVER", "dummy")
    return tmp_path


@pytest.mark.slow
@pytest.mark.compiled
@pytest.mark.parametrize("game", GAMES)
def test_a_game_is_played_for_the_seconds_that_are_given(game: str, capsys: pytest.CaptureFixture[str]) -> None:
    status, out, err = carom_says(capsys, game, "--seconds", "0.3")
    assert (status, err) == (0, "")
    assert out.startswith(f"{game}: ")
    assert " ms of work each (median), 99 % within " in out


@pytest.mark.slow
@pytest.mark.compiled
@pytest.mark.parametrize("game", GAMES)
def test_without_a_sound_card_one_line_says_so_and_the_game_goes_on(
    game: str, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("SDL_AUDIODRIVER", "nonsense")
    status, out, err = carom_says(capsys, game, "--seconds", "0.1")
    assert status == 0
    assert out.startswith(f"{game}: ")
    assert err.startswith("carom: no sound: ")
    assert err.count("\n") == 1


@pytest.mark.parametrize("game", GAMES)
def test_without_a_screen_one_line_says_so(
    game: str, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("SDL_VIDEODRIVER", "nonsense")
    status, out, err = carom_says(capsys, game, "--seconds", "0.1")
    assert (status, out) == (1, "")
    assert err.startswith("carom: no window can be opened: ")
    assert err.count("\n") == 1


@pytest.mark.parametrize(
    ("arguments", "missing", "told"),
    [
        (("toy",), "pygame_gui", 'panels of games need pygame_gui: pip install "carom[play]"'),
        (("toy",), "pygame", 'games need pygame-ce: pip install "carom[play]"'),
        (("pinball",), "pygame", 'games need pygame-ce: pip install "carom[play]"'),
        (("pool",), "pygame", 'games need pygame-ce: pip install "carom[play]"'),
        (("toy", "--chart"), "matplotlib", 'charts need matplotlib: pip install "carom[study]"'),
    ],
)
def test_a_missing_package_is_asked_for(
    arguments: tuple[str, ...],
    missing: str,
    told: str,
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setitem(sys.modules, missing, None)
    assert carom_says(capsys, *arguments) == (1, "", f"carom: {told}\n")


@pytest.mark.parametrize(
    ("arguments", "told"),
    [
        (("toy", "--out", "chart.svg"), "--out chart.svg: is for --chart"),
        (("toy", "--chart", "--out", "chart.txt"), "chart.txt: its ending must be one of .svg, .png, .pdf"),
        (("pool", "--seconds", "0"), "--seconds 0: must be above 0"),
        (("pool", "--balls", "9"), "--balls 9: must be a whole number from 1 to 8"),
        (("pool", "--balls", "all"), "--balls all: must be a whole number from 1 to 8"),
        (("pinball", "--seconds", "long"), "--seconds long: is no number"),
    ],
)
def test_a_mistake_is_told_before_anything_is_opened(
    arguments: tuple[str, ...], told: str, here: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    status, out, err = carom_says(capsys, *arguments)
    assert (status, out) == (2, "")
    assert err.startswith(f"carom: {told}")
    assert list(here.iterdir()) == []


@pytest.mark.slow
def test_a_chart_is_written(here: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch) -> None:
    pytest.importorskip("matplotlib", reason='no matplotlib: pip install "carom[study]"')
    from carom.play.toy import chart

    monkeypatch.setattr(chart, "FEW", (2, 4))
    monkeypatch.setattr(chart, "MANY", (10,))
    status, out, _ = carom_says(capsys, "toy", "--chart")
    assert status == 0
    assert (here / "toy-chart.svg").read_text(encoding="utf-8").count("<svg") == 1
    assert "wrote toy-chart.svg" in out
