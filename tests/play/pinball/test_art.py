"""The pictures of the pinball table: made by the program, always the same, and where the shapes are."""

from itertools import pairwise
from math import cos, pi, sin

import pygame
import pytest

import carom
from carom.play.pinball.art import back as art_back
from carom.play.pinball.art import parts as art_parts
from carom.play.pinball.art import pictures as art
from carom.play.pinball.art import sprites as art_sprites
from carom.play.pinball.art.lamps import lenses
from carom.play.pinball.art.paint import CORAL, NIGHT, Canvas, bow, glow, mixed, star
from carom.play.pinball.rules import lamps
from carom.play.pinball.rules.table import BALL_RADIUS, Table


@pytest.fixture(scope="module")
def world() -> carom.World:
    return Table().world


@pytest.fixture(scope="module")
def pictures(world: carom.World) -> art.Art:
    return art.Art(world)


def brightness(surface: pygame.Surface, spot: tuple[float, float]) -> float:
    """How bright a picture of the table is at a place of it, from 0 to 255."""
    x, y = art.pixel(spot)
    return max(surface.get_at((int(x), int(y)))[:3])


def test_the_picture_shows_the_whole_table(world: carom.World) -> None:
    assert art.pixel((art.BOX.left, art.BOX.top)) == (0.0, 0.0)
    for shape in world.shapes:
        box = shape.aabb
        assert box.left > art.BOX.left
        assert box.right < art.BOX.right
        assert box.top < art.BOX.top
        assert box.bottom > art.BOX.bottom


@pytest.mark.slow
def test_rails_and_trim_are_bright_where_balls_meet_them(world: carom.World, pictures: art.Art) -> None:
    names = {*art_parts.RAILS, "dome", "left wall", "right wall"}
    seen = set()
    for shape in world.shapes:
        if shape.name in names:
            path = art_parts.path_of(shape)
            ways = [(a, b, share) for a, b in pairwise(path) for share in (0.0, 0.3, 0.6)]
            for (start_x, start_y), (end_x, end_y), share in ways:
                x, y = start_x + share * (end_x - start_x), start_y + share * (end_y - start_y)
                if y > 6.0:
                    assert brightness(pictures.ground, (x, y)) > 150, (shape.name, x, y)
                    seen.add(shape.name)
    assert seen == names


def test_flippers_cover_their_shapes_at_each_angle(world: carom.World, pictures: art.Art) -> None:
    for name, side in (("left flipper", 1.0), ("right flipper", -1.0)):
        (part,) = (shape for shape in world.shapes if shape.name == name)
        low, high = part.turn_limits
        for number in (0, 14, 28):
            picture = pictures.flippers[name][number]
            turn = (high if side > 0.0 else low) * number / 28
            middle = picture.get_width() / 2.0
            outline = art_sprites.turned_about(art.turned_back(part), part.pivot, turn)
            solid = pygame.mask.from_surface(picture, 200).get_bounding_rects()[0]
            xs = [middle + x * art.SCALE for x, _ in outline]
            ys = [middle - y * art.SCALE for _, y in outline]
            sides = (min(xs), max(xs), min(ys), max(ys))
            assert (solid.left, solid.right, solid.top, solid.bottom) == pytest.approx(sides, abs=2.0)


def test_a_ball_is_round_and_as_large_as_balls_are(pictures: art.Art) -> None:
    radius = BALL_RADIUS * art.SCALE
    middle = pictures.ball.get_width() / 2.0
    for number in range(16):
        angle = number * pi / 8.0
        for share, solid in ((0.88, True), (1.12, False)):
            place = (middle + share * radius * cos(angle), middle + share * radius * sin(angle))
            assert (pictures.ball.get_at((int(place[0]), int(place[1])))[3] > 200) is solid


def test_every_lamp_shines_somewhere(world: carom.World, pictures: art.Art) -> None:
    assert {*pictures.lights, *pictures.bumpers, "tilt"} == set(lamps.NAMES)
    for name, lens in lenses(world).items():
        light = pictures.lights[name]
        x, y = (int(pixel) for pixel in art.pixel(lens.grown(-0.1)[0]))
        corner_x, corner_y = light.lens_at
        lit = light.lens.get_at((x - corner_x, y - corner_y))
        unlit = pictures.ground.get_at((x, y))
        assert sum(lit[:3]) > sum(unlit[:3]), f"{name} looks no brighter when it is lit"


def test_bumpers_are_brighter_when_lit(pictures: art.Art) -> None:
    for unlit, lit, kicking in pictures.bumpers.values():
        levels = [sum(pygame.transform.average_color(picture)[:3]) for picture in (unlit, lit, kicking)]
        assert levels[0] < levels[1]
        assert pygame.image.tobytes(lit, "RGBA") != pygame.image.tobytes(kicking, "RGBA")


def test_drop_targets_look_other_when_down(pictures: art.Art) -> None:
    for up, down, _ in pictures.targets.values():
        assert sum(pygame.transform.average_color(up)[:3]) > sum(pygame.transform.average_color(down)[:3])


@pytest.mark.slow
def test_the_art_is_the_same_each_time(world: carom.World, pictures: art.Art) -> None:
    again = art.Art(world)
    assert pygame.image.tobytes(again.ground, "RGB") == pygame.image.tobytes(pictures.ground, "RGB")
    assert pygame.image.tobytes(again.apron, "RGBA") == pygame.image.tobytes(pictures.apron, "RGBA")


def test_bulbs_chase_round_the_painting() -> None:
    backs = art_back.paint_backs()
    assert len({pygame.image.tobytes(back, "RGB") for back in backs}) == art_back.BULBS
    inside = art_back.PAINTING.inflate(-30, -30)
    assert len({pygame.image.tobytes(back.subsurface(inside), "RGB") for back in backs}) == 1


def test_outlines_join_shapes_in_any_order_and_direction() -> None:
    first, second = carom.Segment((0, 0), (1, 0), name="a"), carom.Segment((0, 0), (0, 1), name="a")
    apart, other = carom.Segment((5, 5), (6, 5), name="a"), carom.Segment((1, 0), (2, 0), name="b")
    assert art_parts.outlines([first, second, apart, other], ("a",)) == [
        [(0.0, 1.0), (0.0, 0.0), (1.0, 0.0)],
        [(5.0, 5.0), (6.0, 5.0)],
    ]
    assert len(art_parts.path_of(carom.Circle((0, 0), 1))) > 20
    assert art_parts.path_of(carom.Point((0, 0))) == []
    assert art_parts.outlines([carom.Point((0, 0), name="a")], ("a",)) == []


def test_a_world_without_shoulders_is_painted_too() -> None:
    canvas = Canvas(carom.Aabb(0, 0, 4, 4), 10.0)
    before = pygame.image.tobytes(canvas.picture, "RGBA")
    art_parts.paint_shoulder(canvas, [], "left")
    assert pygame.image.tobytes(canvas.picture, "RGBA") == before


def test_a_canvas_lays_light_colours_over_what_is_there() -> None:
    canvas = Canvas(carom.Aabb(0, 0, 4, 4), 10.0)
    assert canvas.size == (40, 40)
    assert canvas.pixel((1.0, 1.0)) == (10, 30)
    canvas.disc((2, 2), 1.5, CORAL)
    canvas.stroke([(0, 2), (4, 2)], 0.5, (*NIGHT, 128))
    canvas.clear([(3, 3), (4, 3), (4, 4), (3, 4)])
    picture = canvas.finished()
    assert picture.get_at((20, 20))[:3] == pytest.approx(mixed(CORAL, NIGHT, 0.5), abs=8)
    assert picture.get_at((38, 2))[3] == 0


def test_light_is_brightest_in_the_middle() -> None:
    shine = glow(20, (255, 200, 100), 0.5)
    assert shine.get_size() == (41, 41)
    assert shine.get_at((20, 20))[0] == pytest.approx(127, abs=1)
    assert shine.get_at((0, 0))[0] == 0
    assert mixed((0, 0, 0), (100, 50, 10), 0.5) == (50, 25, 5)
    assert len(star((0, 0), 1.0, 0.5)) == 8
    assert bow((0, 0), 1.0, 0.0, pi)[-1] == pytest.approx((-1.0, 0.0))
