"""What a page draws: pieces, each with its mover and its switch, and stamps for what happens."""

from itertools import pairwise
from typing import Any

import pytest

import carom
from carom.draw.page.drawing import Cast, draw_cast, names_of, pieces_of, samples_into, stamps_into
from carom.draw.page.painter import PagePainter, record_into
from carom.draw.page.run import page_run
from carom.draw.parts.frame import Frame
from carom.draw.parts.layers import Layer
from carom.draw.theme import ThemeName
from carom.shapes.aabb import Aabb
from tests.pages.runs import changing_run, furnished_run


def test_what_is_switched_has_two_looks() -> None:
    data = page_run(changing_run(), ThemeName.AUTO, ())
    assert [shape["switched"] for shape in data["shapes"]] == [0]
    assert data["switches"]["rows"] == 1
    assert data["switches"]["length"] == 31


def cast_and_pieces(run: carom.Recording) -> tuple[Cast, list[dict[str, Any]]]:
    """Who plays in a run, and what is drawn of them."""
    cast, painter = Cast.of(run), PagePainter()
    frame = Frame.around(Aabb(0.0, 0.0, 12.0, 8.0), 0.0)
    record_into(painter, frame, lambda painter, frame: draw_cast(painter, frame, cast, 1.0))
    return cast, pieces_of(painter, cast)


def test_every_shape_is_a_piece_with_its_mover_and_what_stands_still_has_none() -> None:
    run = furnished_run()
    cast, pieces = cast_and_pieces(run)
    shown = {piece["shape"] for piece in pieces if piece["layer"] in ("shapes", "sensors")}
    assert shown == set(range(len(run.shape_ids)))
    paddle = next(place for place, key in enumerate(run.shape_ids.tolist()) if run.names.get(key) == "paddle")
    assert {piece["shape"] for piece in pieces if piece["mover"] >= 0} == {paddle}
    assert [cast.movers[place] for place in range(len(cast.movers)) if place != paddle] == [-1] * (len(cast.movers) - 1)
    layers = {piece["layer"] for piece in pieces}
    assert {"cells", "boxes", "sectors", "shapes", "sensors"} == layers
    assert all(piece["on"] and not piece["off"] for piece in pieces)


def test_a_piece_that_is_switched_has_marks_for_both_states() -> None:
    cast, pieces = cast_and_pieces(changing_run())
    (target,) = [piece for piece in pieces if piece["layer"] == "shapes"]
    assert len(target["on"]) == len(target["off"]) == 1
    assert target["on"] != target["off"]
    assert target["on"][0][2] == target["off"][0][2]  # in the same place
    assert cast.switches == [0]


def test_names_stand_once_and_those_of_what_moves_apart() -> None:
    labels = names_of(Cast.of(furnished_run()))
    words = [label["words"] for label in labels]
    assert words[0] == "wall \N{MULTIPLICATION SIGN} 3"
    assert len(words) == len(set(words)) == 7
    assert [label["words"] for label in labels if label["mover"] >= 0] == ["paddle"]
    assert len(labels[0]["places"]) == 3


def test_stamps_are_marks_at_the_origin_and_along_x() -> None:
    painter = PagePainter()
    stamps = stamps_into(painter, Frame.around(Aabb(0.0, 0.0, 12.0, 8.0), 0.0))
    assert len(stamps["arrows"]) > 10
    lengths = [max(max(call[3][::2]) for call in calls if call[3]) for calls in stamps["arrows"]]
    steps = [second - first for first, second in pairwise(lengths)]
    assert steps == pytest.approx([stamps["arrow_step"]] * len(steps))
    assert lengths[0] == pytest.approx(stamps["shortest_arrow"])
    assert [call[0] for call in stamps["reticle"]] == ["circle"] + ["segment"] * 4


def test_samples_are_of_the_looks_that_occur_each_beside_its_words() -> None:
    painter = PagePainter()
    samples = samples_into(painter, Cast.of(furnished_run()), ["ball-1", "ball-2"])
    words = [sample["label"] for sample in samples[Layer.SHAPES]]
    assert words == ["wall", "post", "gate, its open way", "moving part, its pivot", "bumper: adds speed"]
    assert [len(samples[layer]) for layer in (Layer.SENSORS, Layer.BALLS, Layer.HITS)] == [1, 1, 1]
