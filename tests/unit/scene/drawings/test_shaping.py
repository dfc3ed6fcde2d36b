"""Bodies as descriptors."""

from typing import Any

import pytest

from carom.scene.drawings import shaping
from carom.scene.drawings.bodies import Body
from carom.scene.drawings.pieces import Conic, Straight
from carom.scene.drawings.shaping import Shaper
from carom.scene.faults import Faults
from carom.scene.scene import Scene

LINE = [Straight((0.0, 0.0), (4.0, 0.0))]
CORNER = [*LINE, Straight((4.0, 0.0), (4.0, 4.0))]
CIRCLE = [Conic((1.0, 2.0), (3.0, 0.0), (0.0, 3.0))]


def shaped(*bodies: Body) -> Shaper:
    """What is made of some bodies."""
    shaper = Shaper(Faults(Scene), 1e-3)
    shaper.add_all(list(bodies))
    return shaper


def body(outline: list[Any], filled: bool = False, **options: Any) -> Body:
    """A body with an outline and options of its own."""
    written = {key: f"data-carom-{key}" for key in options}
    return Body("here", "name", options, written, frozenset(options), [outline], filled)


def test_descriptors_are_as_if_they_were_made_one_by_one() -> None:
    made = shaped(body(LINE, kick=2.0), body(CIRCLE, filled=True), body(CORNER, kick=2.0), body(CIRCLE, ball=True))
    assert made.shapes == list(
        Scene(
            shapes=[
                {"kind": "segment", "start": (0, 0), "end": (4, 0), "kick": 2.0, "name": "name"},
                {"kind": "circle", "center": (1, 2), "radius": 3.0, "solid": True, "name": "name"},
                {"kind": "segment", "start": (0, 0), "end": (4, 0), "kick": 2.0, "name": "name"},
                {"kind": "segment", "start": (4, 0), "end": (4, 4), "kick": 2.0, "name": "name"},
            ]
        ).shapes
    )
    assert made.balls == list(Scene(balls=[{"position": (1, 2), "radius": 3.0, "name": "name"}]).balls)


def test_what_is_said_of_being_solid_overrules_the_filling() -> None:
    assert shaped(body(CIRCLE, filled=True, solid=False), body(CIRCLE, solid=True)).shapes == list(
        Scene(
            shapes=[
                {"kind": "circle", "center": (1, 2), "radius": 3.0, "solid": solid, "name": "name"}
                for solid in (False, True)
            ]
        ).shapes
    )


def test_a_mirrored_arc_is_the_same_arc() -> None:
    one = Conic((0.0, 0.0), (2.0, 0.0), (0.0, 2.0), 0.25, 1.0)
    other = Conic((0.0, 0.0), (2.0, 0.0), (0.0, -2.0), -0.25, -1.0)
    back = Conic((0.0, 0.0), (2.0, 0.0), (0.0, 2.0), 1.25, -1.0)
    first, second, third = shaped(body([one]), body([other]), body([back])).shapes
    assert first == second
    for arc in (first, third):
        assert (round(arc.start_angle, 12), round(arc.end_angle, 12)) == (0.25, 1.25)


def test_faults_are_told_by_the_words_of_the_drawing() -> None:
    made = shaped(
        body(LINE, kick=-1.0), body(LINE, mass=1.0), body(CORNER, angular_velocity=1.0), body(LINE, ball=True)
    )
    assert [words.partition(";")[0] for words in made._faults.first] == [
        "here: data-carom-kick: must not be negative, not -1.0",
        "here: data-carom-mass: is nothing that a segment has",
        'here: data-carom-angular_velocity: needs a pivot too, such as data-carom-pivot="10 20", for it is 2 pieces '
        "that move as one",
        "here: data-carom-ball: is for circles",
    ]
    assert made.shapes == made.balls == []


def test_a_gate_that_opens_along_itself_is_refused() -> None:
    made = shaped(body(LINE, kind="gate", direction=(1.0, 0.0)), body(LINE, kind="gate"))
    assert "data-carom-direction: must" in made._faults.first[0]
    assert [one.kind for one in made.shapes] == ["gate"]


def test_each_piece_has_its_own_options_however_many_there_are(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(shaping, "MOST_SAMPLES", 3)
    given = [{"elasticity": 0.1 * k, "kick": 1.0 * (k % 2), "velocity": (1.0 * k, 0.0)} for k in range(9)]
    made = shaped(*(body(LINE, motion="kinematic", **options) for options in given), body(CORNER, elasticity=0.5))
    assert len(made._samples) <= 3
    tables: list[dict[str, Any]] = [{"end": (4, 0), "motion": "kinematic", **options} for options in given]
    tables += [{"end": (4, 0), "elasticity": 0.5}, {"start": (4, 0), "end": (4, 4), "elasticity": 0.5}]
    one_by_one = Scene(shapes=[{"kind": "segment", "start": (0, 0), "name": "name", **table} for table in tables])
    assert made.shapes == list(one_by_one.shapes)
    assert made.shapes[0].plain() == one_by_one.shapes[0].plain()


def test_a_wrong_value_among_many_right_ones_is_told() -> None:
    values = [0.5, 0.25, -1.0, 0.0, 0.75]
    made = shaped(*(body(LINE, elasticity=value) for value in values), body(CIRCLE, ball=True, mass=0.0))
    assert [shape.elasticity for shape in made.shapes] == [0.5, 0.25, 0.0, 0.75]
    assert made._faults.first == [
        "here: data-carom-elasticity: must not be negative, not -1.0",
        "here: data-carom-mass: must be positive, not 0.0",
    ]


def test_bodies_are_let_go_when_they_are_made() -> None:
    bodies = [body(LINE) for _ in range(3)]
    shaper = Shaper(Faults(Scene), 1e-3)
    shaper.add_all(bodies)
    assert bodies == []
    assert len(shaper.shapes) == 3
