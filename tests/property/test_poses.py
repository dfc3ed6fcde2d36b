"""Setting a pose to what it is changes nothing, turning starts from where a shape has travelled, reset is exact."""

from collections.abc import Sequence
from math import cos, sin
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

import carom

#: The fields of a row that say where a shape is, and nothing of what it did in the last substep.
PLACE = ("left", "bottom", "right", "top", "cx", "cy", "ax", "ay", "bx", "by", "tx", "ty", "dx", "dy", "length")
POSE = (*PLACE, "radius", "start_angle", "end_angle", "pivot_x", "pivot_y", "orientation")

small = st.floats(-3.0, 3.0, allow_subnormal=False)
places = st.tuples(small, small)
Mover = carom.Shape | carom.Compound


def parts(mover: Mover) -> Sequence[carom.Shape]:
    """The single shapes of a shape or compound."""
    return [mover.center_point, *mover.shapes] if isinstance(mover, carom.Compound) else [mover]


def poses(mover: Mover, fields: Sequence[str] = POSE) -> list[Any]:
    """The fields that say where all parts of a shape or compound are."""
    return [[part._row[field].item() for field in fields] for part in parts(mover)]


def initial(mover: Mover) -> list[Any]:
    """What resetting promises to restore."""
    return [poses(mover), mover.pivot, mover.orientation]


def made(kind: str, options: dict[str, Any]) -> Mover:
    """A new shape or compound of a kind."""
    if kind == "compound":
        return carom.Compound([made(part, {}) for part in ("segment", "gate", "circle", "arc", "point")], **options)
    shapes: dict[str, Any] = {
        "point": lambda: carom.Point((1.1, 0.3), motion="kinematic", **options),
        "segment": lambda: carom.Segment((0.1, 0.2), (2.3, 0.7), motion="kinematic", **options),
        "gate": lambda: carom.Gate((0.1, 0.2), (2.3, 0.7), direction=(1, 2), motion="kinematic", **options),
        "circle": lambda: carom.Circle((1.1, 0.3), 0.6, motion="kinematic", **options),
        "arc": lambda: carom.Arc((1.1, 0.3), 0.6, 1.0, 2.5, motion="kinematic", **options),
    }
    shape: Mover = shapes[kind]()
    return shape


@st.composite
def movers(draw: st.DrawFn) -> Mover:
    """A shape or compound that moves."""
    kind = draw(st.sampled_from(("point", "segment", "gate", "circle", "arc", "compound")))
    spin = draw(st.sampled_from((0.0, 1.3, -2.1)))
    limits = draw(st.sampled_from((None, (-0.7, 0.9))))
    options = {"pivot": draw(places), "velocity": draw(places), "angular_velocity": spin, "turn_limits": limits}
    return made(kind, options)


def travel(draw: st.DrawFn, mover: Mover, detection: str) -> None:
    """Do what moves a shape: steps of a world, which it leaves again or not, and turns about places of all kinds."""
    for _ in range(draw(st.integers(0, 3))):
        step = draw(st.sampled_from(("turn", "own turn", "world")))
        if step == "world":
            world = mover.world or carom.World(detection=detection, substeps=draw(st.integers(1, 3)))
            if mover.world is None:
                world.add(mover)
            world.step(draw(st.floats(0.0, 0.7)))
            if draw(st.booleans()):
                world.remove(mover)
        else:
            mover.rotate(mover.pivot if step == "own turn" else draw(places), draw(st.floats(-0.7, 0.7)))


@pytest.mark.parametrize("detection", ["discrete", "continuous"])
@given(data=st.data())
def test_setting_what_is_so_already_changes_no_bit(detection: str, data: st.DataObject) -> None:
    mover = data.draw(movers())
    travel(data.draw, mover, detection)
    before = poses(mover)
    mover.rotate(mover.pivot, mover.orientation)
    assert poses(mover) == before
    mover.velocity = mover.velocity
    mover.angular_velocity = mover.angular_velocity
    mover.turn_limits = mover.turn_limits
    if isinstance(mover, carom.Compound):
        mover.orientation = mover.orientation
    assert poses(mover) == before
    fields = [field for field in POSE if field != "orientation"]
    place = poses(mover, fields)
    mover.pivot = mover.pivot
    assert poses(mover, fields) == place
    assert mover.orientation == 0.0
    mover.position = mover.position
    assert poses(mover, fields) == place


@pytest.mark.parametrize("detection", ["discrete", "continuous"])
@given(data=st.data())
def test_turning_starts_from_where_it_has_travelled(detection: str, data: st.DataObject) -> None:
    mover = data.draw(movers())
    travel(data.draw, mover, detection)
    own, turned = mover.pivot, mover.orientation
    pivot = own if isinstance(mover, carom.Compound) and data.draw(st.booleans()) else data.draw(places)
    angle = data.draw(st.floats(-0.7, 0.7))
    expected = []
    for part in parts(mover):
        unturned = rotated(part.position, own, -turned)
        expected.append(rotated(unturned, pivot, angle))
    if pivot == own and isinstance(mover, carom.Compound):
        mover.orientation = angle
    else:
        mover.rotate(pivot, angle)
    assert (mover.pivot, mover.orientation) == (pivot, angle)
    for part, place in zip(parts(mover), expected, strict=True):
        assert part.position == pytest.approx(place, abs=1e-12)


@pytest.mark.parametrize("detection", ["discrete", "continuous"])
@given(data=st.data())
def test_reset_restores_geometry_pivot_and_orientation_bit_for_bit(detection: str, data: st.DataObject) -> None:
    mover = data.draw(movers())
    if data.draw(st.booleans()):
        travel(data.draw, mover, detection)
        mover.pivot = data.draw(places)
    before = initial(mover)
    travel(data.draw, mover, detection)
    mover.reset()
    assert initial(mover) == before


def rotated(place: tuple[float, float], about: tuple[float, float], angle: float) -> tuple[float, float]:
    """A place turned about another."""
    x, y = place[0] - about[0], place[1] - about[1]
    return about[0] + x * cos(angle) - y * sin(angle), about[1] + x * sin(angle) + y * cos(angle)


def test_a_compound_that_has_travelled_stays_where_it_is() -> None:
    compound = carom.Compound([carom.Circle((3, 0), 0.25)], (0, 0), velocity=(2, -1))
    carom.World(detection="discrete").add(compound)
    compound.world.step(0.5)
    compound.orientation = compound.orientation
    assert (compound.shapes[0].position, compound.pivot) == ((4.0, -0.5), (1.0, -0.5))
