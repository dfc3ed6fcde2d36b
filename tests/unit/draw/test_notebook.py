"""Worlds, scenes and recordings show themselves in notebooks."""

from html.parser import HTMLParser
from xml.etree import ElementTree

import pytest

import carom
from carom.draw import notebook
from carom.draw.page.page import replay_page
from carom.pictured import Pictured, Played
from tests.pages.runs import NASTY, furnished, furnished_run, nasty_run


class Frames(HTMLParser):
    """The attributes of the frames in some HTML."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.frames: list[dict[str, str | None]] = []
        self.feed(text)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        assert tag == "iframe"
        self.frames.append(dict(attrs))


def words_in(svg: str) -> str:
    """All words of an SVG text, which must be whole."""
    return " ".join(ElementTree.fromstring(svg).itertext())


def test_a_world_shows_itself_as_it_stands_and_stays_as_it_is() -> None:
    world = furnished()
    world.run(0.2)
    digest = world.digest()
    assert "At 0.2 s." in words_in(world._repr_svg_())
    assert world.digest() == digest


def test_a_scene_shows_itself_by_its_name() -> None:
    assert "pinball" in words_in(carom.scenes.pinball()._repr_svg_())
    assert "Scene" in words_in(carom.Scene()._repr_svg_())


def test_a_recording_shows_itself_as_its_page_in_a_frame() -> None:
    (frame,) = Frames(furnished_run()._repr_html_() or "").frames
    assert frame["srcdoc"] == replay_page(furnished_run())
    assert frame["sandbox"] == "allow-scripts"
    assert frame["title"] == "Furnished"
    assert "Furnished" in words_in(furnished_run()._repr_svg_())


def test_names_stay_in_their_frame() -> None:
    (frame,) = Frames(nasty_run()._repr_html_() or "").frames
    assert frame["title"] == NASTY
    assert frame["srcdoc"] == replay_page(nasty_run())


def test_a_page_too_large_for_a_notebook_is_left_to_the_picture(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(notebook, "LONGEST_PAGE", 1000)
    assert furnished_run()._repr_html_() is None


def test_of_anything_else_there_is_no_picture() -> None:
    class Odd(Played):
        pass

    with pytest.raises(TypeError, match="no pictures of a Pictured"):
        Pictured()._repr_svg_()
    with pytest.raises(TypeError, match="no pages of a Odd"):
        Odd()._repr_html_()
    with pytest.raises(TypeError, match="no pages of a World"):
        notebook.player(furnished())
