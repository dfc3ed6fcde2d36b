"""Options in words."""

from collections.abc import Callable
from typing import Any

import pytest
from pydantic import ValidationError

from carom.scene.descriptors import BallDescriptor, WorldDescriptor
from carom.scene.drawings import keywords
from carom.scene.shape_descriptors import CompoundDescriptor


@pytest.mark.parametrize(
    ("name", "text", "option"),
    [
        ("kick", "4", ("kick", 4.0)),
        ("angular-velocity", "-3e1", ("angular_velocity", -30.0)),
        ("turn_limits", "-1, 2", ("turn_limits", (-1.0, 2.0))),
        ("velocity", "3 4", ("velocity", (3.0, 4.0))),
        ("sensor", "", ("sensor", True)),
        ("rotating", "No", ("rotating", False)),
        ("layer", "0b101", ("layer", 5)),
        ("motion", "kinematic", ("motion", "kinematic")),
        ("friction", "0.2", ("friction", 0.2)),
        ("kind", "gate", ("kind", "gate")),
        ("direction", "1,0", ("direction", (1.0, 0.0))),
        ("ball", "true", ("ball", True)),
        ("pivot", "1 2", ("pivot", (1.0, 2.0))),
    ],
)
def test_options_have_the_types_of_their_fields(name: str, text: str, option: tuple[str, Any]) -> None:
    assert keywords.of_shape(name, text) == option


@pytest.mark.parametrize("name", sorted(keywords.NOT_NEGATIVE | keywords.POSITIVE))
def test_signs_are_what_the_descriptors_want_them_to_be(name: str) -> None:
    for value in (-1e-300, -0.0, 0.0, 1e-300, 1e300):
        for model, table in (
            (keywords.SHAPES["segment"], {"start": (0, 0), "end": (1, 0)}),
            (BallDescriptor, {"position": (0, 0), "radius": 1}),
        ):
            if name not in model.model_fields:
                continue
            try:
                model(**table, **{name: value})
                fault = ""
            except ValidationError as error:
                fault = error.errors()[0]["type"]
            told = ""
            try:
                keywords.check_signs({"layer": 1, name: value}, {name: "here"})
            except ValueError as error:
                told = str(error)
            must = "be positive" if name == "mass" else "not be negative"
            assert told == (f"here: must {must}, not {value}" if fault else "")


def is_known(read: Callable[[str, str], Any], name: str) -> bool:
    """Whether a keyword is known, if only to refuse its value."""
    try:
        read(name, "?")
    except ValueError as error:
        return "is unknown" not in str(error) and "is drawn, not written" not in str(error)
    return True


def test_every_keyword_of_the_scene_format_can_be_said_or_is_drawn() -> None:
    for model in (*keywords.SHAPES.values(), CompoundDescriptor, BallDescriptor):
        unknown = {name for name in model.model_fields if not is_known(keywords.of_shape, name)}
        assert unknown == keywords.DRAWN & set(model.model_fields)
    assert all(is_known(keywords.of_world, name) for name in WorldDescriptor.model_fields)


@pytest.mark.parametrize(
    ("name", "text", "said"),
    [
        ("kik", "3", "is unknown; did you mean kick?"),
        ("bounciness", "3", "is unknown; did you mean elasticity?"),
        ("radius", "3", "is drawn, not written"),
        ("kick", "much", "must be a number, not 'much'"),
        ("kick", "inf", "must be a number, not 'inf'"),
        ("velocity", "3", "must be 2 numbers, not '3'"),
        ("sensor", "maybe", "must be true or false, not 'maybe'"),
        ("layer", "1.5", "must be a whole number, not '1.5'"),
        ("kind", "segment", "must be one of gate, point, for all else is drawn, not 'segment'"),
    ],
)
def test_what_is_wrong_with_an_option_is_said(name: str, text: str, said: str) -> None:
    with pytest.raises(ValueError) as caught:
        keywords.of_shape(name, text)
    assert str(caught.value) == said


def test_the_world_has_options_of_its_own() -> None:
    assert keywords.of_world("gravity", "0 -9.8") == ("gravity", (0.0, -9.8))
    assert keywords.of_world("bounds", "0 0 1 1") == ("bounds", (0.0, 0.0, 1.0, 1.0))
    assert keywords.of_world("substeps", "4") == ("substeps", 4)
    assert keywords.of_world("tolerance", "1e-3") == ("tolerance", 1e-3)
    with pytest.raises(ValueError, match="did you mean gravity"):
        keywords.of_world("gravty", "0 0")


@pytest.mark.parametrize(
    ("text", "name", "options"),
    [
        ("bumper kick=4 elasticity=0.9", "bumper", [("kick", "4"), ("elasticity", "0.9")]),
        ("left flipper pivot=1,2", "left flipper", [("pivot", "1,2")]),
        ('kick=4 name="a b"', "", [("kick", "4"), ("name", "a b")]),
        ("Layer 1", "Layer 1", []),
        (" ", "", []),
    ],
)
def test_a_label_is_a_name_and_then_options(text: str, name: str, options: list[tuple[str, str]]) -> None:
    assert keywords.label(text) == (name, options)


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("bumper kick=4 sensor", "'sensor' after kick=: options stand at the end, without blanks: kick=4"),
        ("cue ball=true velocity=3 4", "'4' after velocity=: options stand at the end"),
        ("bumper kick= 4", "'4' after kick=: options stand at the end"),
        ("bumper kick = 4", "'kick = 4': options stand at the end"),
        ("bumper kick: 4", "'kick: 4': options stand at the end"),
        ("arm turn-limits: -1,1", "'turn-limits: -1,1': options stand at the end"),
    ],
)
def test_options_that_a_label_writes_otherwise_are_no_part_of_a_name(text: str, said: str) -> None:
    with pytest.raises(ValueError) as caught:
        keywords.labelled("label", text)
    assert str(caught.value).startswith(f"label: {said}")


@pytest.mark.parametrize("text", ["Layer 1", "Ebene: 1", "cue ball", "layer: cut", "kick 4", "a = b"])
def test_words_that_may_be_a_name_are_one(text: str) -> None:
    assert keywords.labelled("label", text) == (text, [])
