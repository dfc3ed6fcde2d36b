"""The lists of a scene, checked block by block, have the faults that they have as a whole."""

from typing import Any

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

import carom
from carom import limits
from carom.scene import lists, scene
from tests.scene_tables import changed, nothing_good, places, scene_or_words, tables_of_scenes

quick = settings(suppress_health_check=[HealthCheck.function_scoped_fixture, HealthCheck.too_slow])


@quick
@given(tables_of_scenes, st.data())
def test_lists_in_blocks_have_the_faults_that_they_have_as_a_whole(
    monkeypatch: pytest.MonkeyPatch, table: dict[str, Any], data: st.DataObject
) -> None:
    for _ in range(data.draw(st.integers(0, 3))):
        path = data.draw(st.sampled_from(places(table)[1:] or [("guard",)]))
        table = changed({"guard": False} | table, path, data.draw(nothing_good))
    monkeypatch.setattr(scene, "LISTS", ())
    whole = scene_or_words(carom.Scene, **table)
    monkeypatch.setattr(scene, "LISTS", lists.LISTS)
    for block in (1, 2, 500):
        monkeypatch.setattr(lists, "BLOCK", block)
        assert repr(scene_or_words(carom.Scene, **table)) == repr(whole)


@pytest.mark.parametrize("kind", ["compound", "group"])
def test_faults_of_a_long_list_of_parts_stand_in_their_place(kind: str) -> None:
    good, bad = ({"kind": "circle", "center": (0, 0), "radius": radius} for radius in (1, -1))
    pivot = {"pivot": 3} if kind == "compound" else {}
    parts = [good] * lists.BLOCK + [bad, bad]
    item = {"kind": kind, "name": 5, **pivot, "colour": 1, "shapes": parts}
    with pytest.raises(carom.SceneError) as caught:
        carom.Scene(shapes=[bad, good, item, bad])
    told = str(caught.value).split("\n  ")[1:]
    fields = {"compound": ("name", "pivot"), "group": ("name",)}[kind]
    paths = [f"shapes[2].{field}" for field in fields]
    paths += [f"shapes[2].shapes[{lists.BLOCK + place}].radius" for place in range(2)]
    assert [line.split(":")[0] for line in told] == ["shapes[0].radius", *paths, "shapes[2].colour", "shapes[3].radius"]


@pytest.mark.parametrize("kind", [[], {}, None, 3])
def test_a_kind_that_is_no_word(kind: object) -> None:
    parts = [{"kind": "circle", "center": (0, 0), "radius": 1}] * (lists.BLOCK + 1)
    with pytest.raises(carom.SceneError, match=r"shapes\[0\]\.kind: "):
        carom.Scene(shapes=[{"kind": kind, "shapes": parts}])


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
    before = ["version: must be 1, not 2"] if kind == "lists" else []
    after = ["balls: must be a list, not 3", "colour: is unknown"] if kind == "lists" else []
    faults = [*before, *[f"{path.format(1 + number)}: must be positive, not -1" for number in range(count)], *after]
    if len(faults) == 1:
        assert [heading, *lines] == faults
        return
    more = len(faults) - limits.MOST_FAULTS
    assert heading == f"{len(faults)} faults"
    assert lines == faults[: limits.MOST_FAULTS] + ([f"and {more} more"] if more > 0 else [])
