"""What is drawn of hits: reticles, tangents, normals, lights."""

from xml.etree import ElementTree

import numpy as np
import pytest

import carom
from carom import draw
from carom.draw import Layer
from carom.draw.parts.moment import LATEST, MOST_LATEST
from tests.unit.draw.svg_marks import SVG, at_end, fallen, of_world
from tests.worlds import crowded


def test_the_latest_hits_have_reticles_tangents_and_normals() -> None:
    layers = (Layer.RETICLES, Layer.TANGENTS, Layer.NORMALS)
    recording = fallen()
    marks = at_end(recording, *layers)
    frame = draw.picture_at(recording, layers=layers).frame
    ring = next(mark for mark in marks["reticles"] if mark.tag == f"{SVG}circle")
    assert (float(ring.get("cx")), float(ring.get("cy"))) == pytest.approx(frame.pixel(1.0, 0.0), abs=0.02)
    assert len(marks["reticles"]) == 5
    (tangent,) = marks["tangents"]
    assert len({place.split()[1] for place in tangent.get("d")[1:].split("L")}) == 1
    assert len(marks["normals"]) == 2
    late = at_end(fallen(0.45 + 1.2 * LATEST), *layers)
    assert len(late["reticles"]) == 5  # of the second bounce


def test_a_reticle_turns_as_time_goes_by() -> None:
    seen = {ElementTree.tostring(at_end(fallen(time), Layer.RETICLES)["reticles"][1]) for time in (0.5, 0.6, 0.7)}
    assert len(seen) == 3


def test_only_the_latest_hits_are_marked() -> None:
    world = crowded(40)
    trace = draw.Trace(world)
    for _ in range(40):
        trace.note(world.step(1 / 60))
    assert len(trace.latest) == MOST_LATEST
    assert (np.diff(trace.latest["time"]) >= 0.0).all()
    recording = carom.Recording.of(crowded(40), 40 / 60)
    kept = draw.picture_at(recording).moment.latest
    assert kept.tobytes() == trace.latest.tobytes()


def test_without_a_run_tangents_and_normals_are_those_of_shapes() -> None:
    world = carom.World()
    for shape in (
        carom.Segment((0, 0), (4, 0)),
        carom.Arc((0, 0), 3, 0.5, 2.0),
        carom.Circle((0, 0), 2),
        carom.Circle((0, 0), 0.01),
        carom.Point((1, 1)),
    ):
        world.add(shape)
    marks = of_world(world, Layer.TANGENTS, Layer.NORMALS, Layer.RETICLES, Layer.LIGHTS)
    assert len(marks["tangents"]) == 6
    assert len([mark for mark in marks["normals"] if mark.tag == f"{SVG}path"]) == 3
    assert marks["reticles"] == marks["lights"] == []


def test_what_was_hit_glows_for_a_moment() -> None:
    assert len(at_end(fallen(0.4), Layer.LIGHTS)["lights"]) == 0
    assert len(at_end(fallen(0.5), Layer.LIGHTS)["lights"]) == 3
    assert len(at_end(fallen(0.9), Layer.LIGHTS)["lights"]) == 0


def test_posts_and_moving_parts_glow_too() -> None:
    world = carom.World()
    world.add(carom.Point((0, 0)))
    world.add(carom.Segment((2, -1), (2, 1), motion="kinematic"))
    world.add(carom.Ball((-1, 0), 0.5, velocity=(6, 0)))
    world.add(carom.Ball((1, 0), 0.4, velocity=(6, 0)))
    assert len(at_end(carom.Recording.of(world, 0.2), Layer.LIGHTS)["lights"]) == 6
