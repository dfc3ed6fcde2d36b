"""Charts of bars whose lengths are powers of ten."""

import re
from xml.etree import ElementTree

import pytest

from benchmarks import __main__ as program
from benchmarks import bars, door, startup
from benchmarks.bars import LEFT, RIGHT, Bar, Work
from benchmarks.common import Figure
from carom.draw.paint.painter import Style

SVG = "{http://www.w3.org/2000/svg}"


def lengths(svg: str) -> list[float]:
    """How long the bars of a chart are, in their order."""
    found = []
    for area in ElementTree.fromstring(svg[: svg.rindex(">") + 1]).iter(f"{SVG}polygon"):
        across = [float(number) for number in area.attrib["points"].split()[::2]]
        found.append(max(across) - min(across))
    return found[1:]  # the first is the stage


def test_bars_are_as_long_as_their_powers_of_ten_and_say_what_they_are() -> None:
    works = [
        Work(
            "one", [Bar("carom", 0.01, "little", Style(fill="ball-1")), Bar("other", 10.0, "much", Style(fill="muted"))]
        ),
        Work("two", [Bar("carom", 1.0, "middling", Style(fill="ball-1"))]),
    ]
    svg = bars.draw("title", "unit", works)
    # From a power below the least, 0.001, to the most.
    assert lengths(svg) == pytest.approx([share * (RIGHT - LEFT) for share in (0.25, 1.0, 0.75)], abs=0.02)
    words = re.findall(r">([^<>\n]+)</text>", svg)
    for told in ("title", "unit", "one", "two", "carom", "other", "little", "much", "middling", "0.001", "0.1", "10"):
        assert told in words
    assert "prefers-color-scheme:dark" in svg


def test_the_door_is_drawn_where_the_peers_have_it() -> None:
    figures = [Figure(name, engine, 0.5, "µs") for name in door.SHARED for engine in ("carom", "pymunk", "another")]
    svg = door.chart([*figures, Figure("restore", "carom", 70.0, "µs")])
    assert len(lengths(svg)) == 2 * len(door.SHARED)
    assert all(f">{name}</text>" in svg for name in door.SHARED)
    assert "restore" not in svg


def test_a_start_is_drawn_in_seconds_whatever_it_was_measured_in() -> None:
    figures = [Figure("import", "carom", 100.0, "ms"), Figure("import", "NumPy alone", 50.0, "ms")]
    figures += [Figure("first picture ever", "carom", 10.0, "s"), Figure("first step ever", "carom", 1.0, "s")]
    svg = startup.chart(figures)
    short, middle, long = lengths(svg)  # in the order of the works, those that were not measured left out
    assert (middle - short, long - middle) == pytest.approx(((RIGHT - LEFT) / 3.0,) * 2, abs=0.02)
    for told in ("0.1 s", "1 s", "10 s", startup.CALLED["first picture ever"]):
        assert f">{told}</text>" in svg
    assert [startup.in_words(value) for value in (0.00012, 12.3, 123.4)] == ["0.12 ms", "12 s", "123 s"]


def test_of_many_powers_of_ten_every_second_is_written() -> None:
    svg = bars.draw("title", "unit", [Work("one", [Bar("carom", 10.0**power, "", Style()) for power in (-4, 3)])])
    words = re.findall(r">([^<>\n]+)</text>", svg)
    assert [word for word in words if word in {f"{10.0**power:g}" for power in range(-6, 5)}] == [
        "1e-05",
        "0.001",
        "0.1",
        "10",
        "1000",
    ]


def test_one_chart_is_drawn_at_a_time(capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit):
        program.main(["--only", "door", "--only", "startup", "--chart", "a.svg"])
    assert "or --only startup, or --only door" in capsys.readouterr().err
