"""What a replay page holds, read without a browser."""

import json
import re
from dataclasses import replace
from html.parser import HTMLParser

import numpy as np
import pytest

from carom.draw.page.page import replay_page
from tests.pages.runs import NASTY, bare_runs, furnished_run, nasty_run


class Outline(HTMLParser):
    """The elements of a page, and the text in each kind of them."""

    def __init__(self, page: str) -> None:
        super().__init__()
        self.tags: list[str] = [""]
        self.words: dict[str, str] = {}
        self.links: list[str] = []
        self.feed(page)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.tags.append(tag)
        self.links += [value or "" for name, value in attrs if name in {"src", "href", "action", "data", "poster"}]

    def handle_data(self, data: str) -> None:
        self.words[self.tags[-1]] = self.words.get(self.tags[-1], "") + data


def given(page: str) -> dict[str, object]:
    """The data in a page."""
    found = re.search(r'<script type="application/json" id="run">(.*?)</script>', page, re.DOTALL)
    assert found is not None
    return dict(json.loads(found[1]))


def test_a_page_links_to_nothing_outside_of_itself() -> None:
    page = replay_page(furnished_run())
    assert [link for link in Outline(page).links if not link.startswith(("#", "data:"))] == []
    assert "http:" not in page
    assert "https:" not in page
    assert "@import" not in page


def test_names_stay_text_whatever_they_hold() -> None:
    page = replay_page(nasty_run())
    outline = Outline(page)
    assert outline.tags.count("script") == page.count("</script") == 2
    assert "b" not in outline.tags
    assert outline.words["title"].strip() == NASTY
    data = given(page)
    assert data["name"] == data["about"] == NASTY


def test_a_name_that_is_no_text_makes_a_page_that_can_be_written() -> None:
    assert replay_page(replace(furnished_run(), name="\ud800")).encode()


@pytest.mark.parametrize("name", bare_runs())
def test_every_run_makes_a_page(name: str) -> None:
    data = given(replay_page(bare_runs()[name]))
    left, bottom, right, top = np.array(data["stage"], float)
    assert right > left
    assert top > bottom


def test_the_policy_allows_the_pages_own_script_alone() -> None:
    page = replay_page(furnished_run())
    assert re.search(r"default-src 'none'; style-src 'unsafe-inline'; script-src 'sha256-[\w+/]{43}='", page)


def test_the_page_is_the_same_every_time() -> None:
    assert replay_page(furnished_run()) == replay_page(furnished_run())
