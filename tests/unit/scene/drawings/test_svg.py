"""SVG drawings as scenes: groups, transforms, references, and what is refused."""

from math import cos, hypot, radians, sin
from pathlib import Path

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

import carom
from tests.clock import soon
from tests.drawings import drawn, refusal


def test_a_table_is_read_as_it_is_drawn(tmp_path: Path) -> None:
    scene = drawn(
        tmp_path,
        '<title>My table</title><rect id="frame" x="10" y="10" width="80" height="60" rx="5"/>'
        '<circle id="post" cx="50" cy="50" r="5" fill="red" data-carom-elasticity="0.5"/>'
        '<circle id="ring" cx="20" cy="30" r="5"/>'
        '<circle id="ball" cx="30" cy="20" r="2" data-carom-ball="" data-carom-velocity="3 4" data-carom-mass="2"/>',
        'width="100mm" height="100mm" viewBox="0 0 100 100" data-carom-gravity="0 -9.8"',
    )
    assert (scene.name, scene.guard, scene.world.gravity) == ("My table", True, (0.0, -9.8))
    by_name: dict[str, list[carom.Shape]] = {}
    for shape in scene.build().shapes:
        by_name.setdefault(shape.name, []).append(shape)
    assert [shape.kind for shape in by_name["frame"]] == ["segment", "arc"] * 4
    (post,), (ring,) = by_name["post"], by_name["ring"]
    assert (post.center, post.radius, post.solid, post.elasticity) == ((50.0, 50.0), 5.0, True, 0.5)
    assert (ring.center, ring.solid) == ((20.0, 70.0), False)
    (ball,) = scene.balls
    assert ball.plain() == {
        "name": "ball", "position": [30.0, 80.0], "radius": 2.0, "velocity": [3.0, 4.0], "mass": 2.0,
    }  # fmt: skip


NUMBERS = st.floats(-20.0, 20.0).map(lambda x: round(x, 3))


@settings(max_examples=40, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(st.tuples(*[NUMBERS] * 4), st.floats(0.2, 5.0).map(lambda x: round(x, 3)), NUMBERS, st.booleans())
def test_groups_turn_mirror_and_scale_what_is_in_them(
    tmp_path: Path, places: tuple[float, ...], scale: float, turn: float, mirrored: bool
) -> None:
    x, y, cx, cy = places
    flip = "scale(-1,1)" if mirrored else ""
    scene = drawn(
        tmp_path,
        f'<g transform="translate({x} {y}) {flip}"><g transform="rotate({turn}) scale({scale})">'
        f'<circle cx="{cx}" cy="{cy}" r="2"/><path d="M {cx} {cy} h 2 a 1 1 0 0 1 1 1"/></g></g>',
    )
    circle, line, arc = scene.shapes

    def place(px: float, py: float) -> tuple[float, float]:
        c, s = cos(radians(turn)), sin(radians(turn))
        qx, qy = scale * (c * px - s * py), scale * (s * px + c * py)
        return x + (-qx if mirrored else qx), 100.0 - (y + qy)

    assert circle.center == pytest.approx(place(cx, cy), abs=1e-9)
    assert circle.radius == pytest.approx(2.0 * scale, rel=1e-12)
    assert sorted([line.start, line.end]) == [
        pytest.approx(end, abs=1e-9) for end in sorted([place(cx, cy), place(cx + 2.0, cy)])
    ]
    built = arc.build()
    assert built.center == pytest.approx(place(cx + 2.0, cy + 1.0), abs=1e-9)
    for end in (place(cx + 2.0, cy), place(cx + 3.0, cy + 1.0)):
        assert min(hypot(end[0] - px, end[1] - py) for px, py in (built.p0, built.p1)) < 1e-9
    assert built.length == pytest.approx(1.5707963267948966 * scale, rel=1e-9)


def test_options_and_names_are_handed_down_and_overruled(tmp_path: Path) -> None:
    scene = drawn(
        tmp_path,
        '<g inkscape:label="walls elasticity=0.5 kick=1"><line x2="9"/><line id="floor" x2="9" y1="5" y2="5" '
        'data-carom-kick="2"/><circle id="b" r="3" data-carom-ball=""/></g>',
    )
    assert [(one.name, one.elasticity, one.kick) for one in scene.shapes] == [("walls", 0.5, 1.0), ("floor", 0.5, 2.0)]
    assert scene.balls[0].elasticity == 0.5


@pytest.mark.parametrize(
    "pivot",
    ['data-carom-pivot="10 20">', '><circle cx="10" cy="20" r="1" inkscape:label="pivot"/>'],
)
def test_a_group_with_a_pivot_is_a_compound(tmp_path: Path, pivot: str) -> None:
    scene = drawn(
        tmp_path,
        f'<g transform="translate(5 5)"><g id="flipper" data-carom-angular-velocity="2" {pivot}'
        '<line x1="10" y1="20" x2="40" y2="20"/><circle id="tip" cx="40" cy="20" r="2"/></g></g>',
    )
    (compound,) = scene.shapes
    assert (compound.kind, compound.name, compound.pivot) == ("compound", "flipper", (15.0, 75.0))
    assert compound.angular_velocity == 2.0
    assert [(part.kind, part.name) for part in compound.shapes] == [("segment", "flipper"), ("circle", "tip")]
    assert scene.build().shapes[0].pivot == (15.0, 75.0)


def test_an_outline_of_one_piece_turns_by_itself_and_of_more_as_a_compound(tmp_path: Path) -> None:
    moving = 'data-carom-motion="kinematic" data-carom-pivot="1 2" data-carom-turn-limits="0 1"'
    one, more = drawn(tmp_path, f'<line x2="9" {moving}/><polyline points="0,0 5,0 5,5" {moving}/>').shapes
    assert (one.kind, one.motion, one.pivot, one.turn_limits) == ("segment", "kinematic", (1.0, 98.0), (0.0, 1.0))
    assert (more.kind, len(more.shapes), more.pivot, more.turn_limits) == ("compound", 2, (1.0, 98.0), (0.0, 1.0))


def test_gates_and_points_are_said(tmp_path: Path) -> None:
    gate, point = drawn(
        tmp_path,
        '<line x2="9" data-carom-kind="gate" data-carom-direction="0 1"/>'
        '<circle cx="5" r="1" data-carom-kind="point"/>',
    ).shapes
    assert (gate.kind, gate.direction) == ("gate", (0.0, 1.0))
    assert (point.kind, point.position) == ("point", (5.0, 100.0))


def test_what_is_referred_to_is_drawn_where_it_is_referred_to(tmp_path: Path) -> None:
    scene = drawn(
        tmp_path,
        '<defs><circle id="c" r="1"/><symbol id="s" viewBox="0 0 10 10"><circle cx="5" cy="5" r="5"/></symbol></defs>'
        '<use href="#c" x="10" y="20"/><use xlink:href="#s" x="40" y="40" width="20" height="20"/>'
        '<svg x="80" y="80" width="10" height="10" viewBox="0 0 1 1"><circle r="0.1"/></svg>',
    )
    assert [(one.center, one.radius) for one in scene.shapes] == [
        ((10.0, 80.0), 1.0),
        ((50.0, 50.0), 10.0),
        (pytest.approx((80.0, 20.0)), pytest.approx(1.0)),
    ]


@pytest.mark.parametrize(
    "hidden",
    [
        '<g style="display:none"><circle r="1"/></g>',
        '<circle r="1" visibility="hidden"/>',
        '<circle r="1" stroke="none"/>',
        "<style>.h{display:none}</style><circle class='h' r='1'/>",
        '<defs><circle r="1"/></defs><clipPath><circle r="1"/></clipPath>',
        '<metadata><circle r="1"/></metadata>',
    ],
)
def test_what_is_not_seen_is_no_body(tmp_path: Path, hidden: str) -> None:
    assert drawn(tmp_path, hidden + '<line x2="9"/>').shapes[0].kind == "segment"
    assert len(drawn(tmp_path, hidden + '<line x2="9"/>').shapes) == 1


def test_a_part_as_freecad_exports_it_comes_out_without_its_dimensions(tmp_path: Path) -> None:
    # Up is positive within a group that mirrors; widths have a unit, titles are Python's; circles are two arcs whose
    # radii differ in the tenth digit, turned by what FreeCAD takes for the angle of their axes.
    line = 'stroke="#191919" stroke-width="0.35 px" style="stroke-width:0.35;stroke-dasharray:none;fill:none"'
    with pytest.warns(carom.errors.DrawingWarning, match=r"left out: dimension \(2\)$"):
        scene = drawn(
            tmp_path,
            f"""<g id="Plate" transform="translate(2.0,62.0) scale(1,-1)"><path id="Plate_nwe0000" {line}
              d="M 0.0 0.0 L 30.0 0.0 A 4.999999999372275 4.999999999372275 -129.133238 0 1 35.0 5.0 L 35.0 20.0 Z "/>
              <title>b'Plate'</title></g>
            <g id="Hole" transform="translate(2.0,62.0) scale(1,-1)"><path {line}
              d="M 12.0 10.0 A 2.0 2.0 0.0 0 0 8.0 10.0 A 2.0 2.0 0.0 0 0 12.0 10.0 "/></g>
            <g id="Dimension"><g freecad:basepoint1="0 0" freecad:basepoint2="30 0" freecad:dimpoint="15 -9">
              <path {line} d="M 0 -9 L 30 -9"/><text>30.00</text></g></g>
            <path freecad:dimpoint="3 4" {line} d="M 0 0 L 30 9"/>""",
            'width="104mm" height="64mm" viewBox="0 0 104 64"'
            ' xmlns:freecad="https://wiki.freecad.org/index.php?title=Svg_Namespace"',
        )
    assert [(one.kind, one.name) for one in scene.shapes] == [
        *((kind, "Plate_nwe0000") for kind in ("segment", "arc", "segment", "segment")),
        *[("arc", "Hole")] * 2,
    ]
    plate, corner, *_, hole = (shape for shape in scene.build().shapes if shape.kind != "point")
    assert (plate.start, plate.end) == (pytest.approx((2.0, 2.0)), pytest.approx((32.0, 2.0)))
    assert (corner.center, corner.radius) == (pytest.approx((32.0, 7.0)), pytest.approx(5.0))
    assert hole.center == pytest.approx((12.0, 12.0))


def test_what_is_not_understood_is_listed_once(tmp_path: Path) -> None:
    with pytest.warns(carom.errors.DrawingWarning) as told:
        scene = drawn(
            tmp_path,
            '<text>a</text><text>b</text><image href="file:///etc/passwd"/><circle r="1" fill="url(#g)"/>'
            '<line x2="9" clip-path="url(#c)"/><use href="other.svg#x"/>',
        )
    assert len(told) == 1
    assert str(told[0].message).partition("left out: ")[2] == (
        "text (2), image (1), gradient or pattern (1), clipping (1), reference to what is not in the drawing (1)"
    )
    assert [one.kind for one in scene.shapes] == ["circle", "segment"]
    assert scene.shapes[0].solid


def test_every_mistake_names_the_element_and_what_would_be_right(tmp_path: Path) -> None:
    said = refusal(
        tmp_path,
        '<circle id="a" r="9" data-carom-kik="3"/>\n<circle id="b" r="9" data-carom-kick="-3"/>\n'
        '<g id="g" data-carom-elasticity="-1"><circle r="9"/></g>\n<line id="h" x2="3" data-carom-mass="3"/>\n'
        '<rect id="i" width="9" height="9" data-carom-ball=""/>\n<g transform="foo(3)"/>\n'
        '<rect id="j" width="9" height="9" data-carom-angular-velocity="1"/>\n'
        '<ellipse id="k" rx="9" ry="8" data-carom-kind="gate"/>',
        'data-carom-gravty="0 1" data-carom-substeps="0"',
    )
    for words in (
        "<svg> (line 1): data-carom-gravty: is unknown; did you mean gravity?",
        '<circle id="a"> (line 2): data-carom-kik: is unknown; did you mean kick?',
        '<circle id="b"> (line 3): data-carom-kick: must not be negative, not -3.0',
        '<circle> (line 4): data-carom-elasticity of <g id="g"> (line 4): must not be negative, not -1.0',
        '<line id="h"> (line 5): data-carom-mass: is nothing that a segment has; only balls have one, Ball(mass=...)',
        '<rect id="i"> (line 6): data-carom-ball: is for circles',
        "<g> (line 7): transform: must be matrix, translate, scale, rotate or skew with numbers, not 'foo(3)'",
        '<rect id="j"> (line 8): data-carom-angular-velocity: needs a pivot too, such as data-carom-pivot="10 20"',
        '<ellipse id="k"> (line 9): data-carom-kind: a gate is straight',
        "<svg> (line 1): data-carom-substeps: must be at least 1, not 0",
    ):
        assert words in said
    assert "10 faults" in said


@pytest.mark.parametrize(
    ("inside", "said"),
    [
        (
            '<g id="a" data-carom-pivot="5 5"><circle id="b" r="3" data-carom-ball=""/></g>',
            '<circle id="b"> (line 2): data-carom-ball: a ball is no part of what moves as one; move it out of <g id',
        ),
        (
            '<g id="a" data-carom-angular-velocity="3"><line x2="4"/></g>',
            "must not be set unless motion is 'kinematic', not 3.0; what moves as one needs data-carom-pivot=",
        ),
        (
            '<circle id="a" r="3" inkscape:label="cue velocity=3,4"/>',
            "label velocity: must not be set unless motion is 'kinematic', not (3.0, 4.0); a ball says ball=true",
        ),
        ('<circle id="a" data-carom-ball=""/>', '<circle id="a"> (line 2): draws nothing: it needs r above 0'),
        (
            '<g transform="scale(0)"><rect id="a" width="3" height="3" data-carom-kick="1"/></g>',
            "draws nothing: it needs",
        ),
        (
            '<g id="a"><circle r="1" data-carom-pivot=""/>\n<circle id="b" r="1" data-carom-pivot=""/></g>',
            "must turn about",
        ),
    ],
)
def test_what_is_likely_missing_is_said(tmp_path: Path, inside: str, said: str) -> None:
    assert said in refusal(tmp_path, inside)


@pytest.mark.parametrize("inside", ["", '<g style="display:none"><circle r="1"/></g>', "<text>a</text>"])
def test_a_drawing_of_nothing_says_so(tmp_path: Path, inside: str) -> None:
    with pytest.warns(carom.errors.DrawingWarning, match="there is nothing in it that is seen and can be met") as heard:
        assert drawn(tmp_path, inside).shapes == ()
    assert len(heard) == 1


@pytest.mark.parametrize(
    ("inside", "told"),
    [
        ('<circle cx="3"/><polygon points="1,1"/>', "circle without a size (1), polygon without a size (1)"),
        ('<path d="M 1 1"/><path d="M 1 1 z"/>', "path without a size (2)"),
        ('<g transform="scale(0)"><circle r="3"/></g>', "circle without a size (1)"),
        ('<g transform="scale(2, 0)"><ellipse rx="3" ry="4"/></g>', "ellipse without a size (1)"),
        ('<circle r="3" inkscape:label="pivot"/>', "pivot outside of a group (1)"),
    ],
)
def test_what_draws_nothing_is_listed(tmp_path: Path, inside: str, told: str) -> None:
    with pytest.warns(carom.errors.DrawingWarning) as heard:
        scene = drawn(tmp_path, inside + '<line x2="9"/>')
    assert [str(one.message).partition("left out: ")[2] for one in heard] == [told]
    assert len(scene.build().shapes) == 3  # the line and its ends


@pytest.mark.parametrize(
    ("inside", "said"),
    [
        ('<g id="a"><use href="#a"/></g>', "is drawn again by what is in it, without end"),
        ('<g id="a"><use href="#b"/></g><g id="b"><use href="#a"/></g>', "without end"),
        (
            "".join(f'<g id="n{k}">' + f'<use href="#n{k + 1}"/>' * 10 + "</g>" for k in range(12)) + '<g id="n12"/>',
            "draws more than",
        ),
        ("".join(f'<g id="n{k}"><use href="#n{k + 1}"/></g>' for k in range(5000)), "nested too deeply by reference"),
        (f'<polyline points="{"1 1 " * 1_000_000}"/>', "too many points"),
        (f'<path d="M0 0{"l1 1" * 1_000_000}"/>', "too many points"),
        (
            f'<path id="p" d="M0 0{"t1 2" * 125_001}"/>',
            '<path id="p"> (line 2): a drawing may have at most 125000 curves',
        ),
        (f'<path id="p" d="M0 0{"t1 2" * 2000}"/>' + '<use href="#p"/>' * 80, "at most 125000 curves"),
        ('<g id="g">' + '<ellipse rx="1" ry="2"/>' * 500 + "</g>" + '<use href="#g"/>' * 250, "at most 125000 curves"),
        (f'<path d="M{"1" * 5_000_000} 0"/>', "numbers with more than 1000 digits"),
        ('<g data-carom-pivot="1 1"><g id="in" data-carom-pivot="1 1"/></g>', "has one, and this is in it"),
        ('<line x2="1e200"/>', "is too large"),
        ("</svg><svg>", "line 2: is not well-formed XML"),
    ],
)
def test_hostile_drawings_are_refused_soon(tmp_path: Path, inside: str, said: str) -> None:
    with soon():
        assert said in refusal(tmp_path, inside)


def test_only_svg_is_svg(tmp_path: Path) -> None:
    (tmp_path / "a.svg").write_text("<html/>")
    with pytest.raises(carom.SceneError, match=r"a.svg: <html> \(line 1\): must be an svg element"):
        carom.Scene.load(tmp_path / "a.svg")
