"""What a replay page holds, read without a browser."""

import json
import re
from dataclasses import replace
from html.parser import HTMLParser

import numpy as np
import pytest

from carom.draw.page.columns import MOST_HITS, kept_hits
from carom.draw.page.page import replay_page
from carom.draw.page.run import MOST_SHARES, page_run, shares
from carom.draw.parts.layers import Layer
from carom.draw.theme import ThemeName
from carom.rows.hit import HIT
from carom.world.hits import HitKind
from tests.pages.runs import NASTY, bare_runs, changing_run, furnished_run, nasty_run


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


def test_themes_and_layers_are_those_asked_for() -> None:
    data = page_run(furnished_run(), ThemeName.DARK, {Layer.BOXES})
    assert data["theme"] == "dark"
    assert [layer["name"] for layer in data["layers"] if layer["on"]] == ["boxes"]
    assert {layer["name"] for layer in data["layers"]} == set(Layer)


def test_no_ink_is_missing_from_a_theme() -> None:
    data = page_run(furnished_run(), ThemeName.AUTO, ())
    inks = {style.get(part) for style in data["styles"] for part in ("stroke", "fill", "ink")} - {None}
    for theme in data["themes"].values():
        assert inks | set(data["ball_inks"]) <= set(theme)


def test_what_is_switched_has_two_looks() -> None:
    data = page_run(changing_run(), ThemeName.AUTO, ())
    assert [shape["switched"] for shape in data["shapes"]] == [0]
    assert data["switches"]["rows"] == 1
    assert data["switches"]["length"] == 31


def hits_of(count: int) -> np.ndarray:
    """So many bounces, each stronger than the one before, and an entry into a sensor first of all."""
    hits = np.zeros(count + 1, HIT)
    hits["time"] = hits["impulse"] = np.arange(count + 1)
    hits["kind"][1:] = HitKind.BOUNCE
    hits["kind"][0] = HitKind.ENTER
    return hits


def test_of_too_many_hits_the_strongest_are_kept_in_order_of_time_and_what_sensors_saw() -> None:
    hits = hits_of(MOST_HITS + 10)
    kept = kept_hits(hits)
    assert len(kept) == MOST_HITS
    assert kept["kind"][0] == HitKind.ENTER
    assert np.array_equal(kept["time"][1:], np.arange(12, MOST_HITS + 11))
    assert len(kept_hits(hits[:MOST_HITS])) == MOST_HITS


def test_the_counts_are_of_names_and_end_with_all_others() -> None:
    counts = dict(shares(furnished_run()))
    hits = furnished_run().hits
    assert sum(counts.values()) == len(hits)
    assert counts["wall"] == sum(furnished_run().label_of(shape) == "wall" for shape in hits["shape"].tolist())


def test_a_long_list_of_counts_is_cut_short(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("carom.draw.page.run.MOST_SHARES", 1)
    first, rest = shares(furnished_run())
    assert rest == ("", len(furnished_run().hits) - first[1])
    assert MOST_SHARES > 1
