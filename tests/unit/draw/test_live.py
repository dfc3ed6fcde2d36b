"""A world drawn live: what moves is drawn anew, what stays is kept, what was is remembered for a while."""

from typing import Any

import numpy as np
import pytest

import carom
from carom import draw
from carom.draw import Layer

pygame = pytest.importorskip("pygame", reason='no pygame: pip install "carom[draw]"')

BOX = carom.Aabb(0.0, 0.0, 10.0, 10.0)
SIZE = (200, 200)


def room() -> carom.World:
    """A floor, a wall, a paddle that can turn, and a ball that falls."""
    world = carom.World(gravity=(0.0, -10.0))
    world.add(carom.Segment((0.0, 1.0), (10.0, 1.0), elasticity=0.5, name="floor"))
    world.add(carom.Segment((9.0, 1.0), (9.0, 9.0), name="wall"))
    world.add(carom.Compound([carom.Segment((2.0, 5.0), (4.0, 5.0))], pivot=(3.0, 5.0), name="paddle"))
    world.add(carom.Ball((6.0, 2.0), radius=0.5, name="ball"))
    return world


def drawn(live: draw.Live) -> Any:
    """What is drawn now: the pixels, (columns, lines, 3)."""
    surface = pygame.Surface(SIZE)
    live.draw(surface)
    return pygame.surfarray.array3d(surface).astype(int)


def at(pixels: Any, live: draw.Live, x: float, y: float) -> Any:
    """The colour at a place of the world."""
    column, line = live.frame.pixel(x, y)
    return pixels[int(column), int(line)]


def test_the_box_fills_the_picture_and_places_come_back() -> None:
    live = draw.Live(room(), carom.Aabb(0.0, 0.0, 20.0, 10.0), (400, 300))
    assert live.frame.pixel(0.0, 0.0) == (0.0, 250.0)
    assert live.frame.pixel(20.0, 10.0) == (400.0, 50.0)
    assert live.frame.world(*live.frame.pixel(3.0, 4.0)) == pytest.approx((3.0, 4.0))


def test_a_ball_is_drawn_where_it_is_now() -> None:
    world = room()
    live = draw.Live(world, BOX, SIZE, layers={Layer.BALLS, Layer.SHAPES})
    ball = world.balls[0]
    before = at(drawn(live), live, 6.0, 2.0)
    ball.position = (6.0, 7.0)
    after = drawn(live)
    assert (at(after, live, 6.0, 7.0) == before).all()
    assert not (at(after, live, 6.0, 2.0) == before).all()


def test_a_paddle_is_drawn_as_it_has_turned() -> None:
    world = room()
    live = draw.Live(world, BOX, SIZE, layers={Layer.SHAPES})
    ground = at(drawn(live), live, 3.0, 5.8)
    world.shapes[2].rotate((3.0, 5.0), np.pi / 2.0)
    assert not (at(drawn(live), live, 3.0, 5.8) == ground).all()


def test_what_changes_is_drawn_as_it_is_now() -> None:
    world = room()
    floor = world.shapes[0]
    assert isinstance(floor, carom.Segment)
    live = draw.Live(world, BOX, SIZE, layers={Layer.SHAPES}, changing=[floor])
    before = drawn(live)
    floor.can_collide = False
    assert (drawn(live) != before).any()


def test_what_stays_is_kept_until_it_is_looked_at_anew() -> None:
    world = room()
    live = draw.Live(world, BOX, SIZE, layers={Layer.SHAPES})
    before = drawn(live)
    world.add(carom.Segment((1.0, 8.0), (5.0, 8.0)))
    assert (drawn(live) == before).all()
    live.refresh()
    assert (drawn(live) != before).any()


def test_layers_are_switched_at_any_time() -> None:
    world = room()
    live = draw.Live(world, BOX, SIZE, layers=set())
    bare = drawn(live)
    for layer in (Layer.SHAPES, Layer.BALLS, Layer.BOXES, Layer.CELLS, Layer.NAMES):
        live.layers = frozenset({layer})
        assert live.layers == {layer}
        assert (drawn(live) != bare).any(), layer
    with pytest.raises(carom.InvalidArgument, match="layers must be among"):
        live.layers = frozenset({"colours"})  # type: ignore[arg-type]


def test_hits_and_tracks_are_those_of_the_last_seconds_until_they_are_forgotten() -> None:
    world = room()
    live = draw.Live(world, BOX, SIZE, layers={Layer.TRACKS, Layer.HITS})
    bare = drawn(live)
    for _ in range(30):
        live.note(world.step(1 / 60))
    seen = drawn(live)
    assert (at(seen, live, 6.0, 1.0) != at(bare, live, 6.0, 1.0)).any()
    live.forget()
    assert (drawn(live) == bare).all()


@pytest.mark.parametrize("layer", [Layer.LIGHTS, Layer.RETICLES, Layer.TANGENTS, Layer.NORMALS])
def test_what_was_just_hit_is_marked(layer: Layer) -> None:
    world = carom.World(gravity=(0.0, -10.0))
    world.add(carom.Segment((0.0, 1.0), (10.0, 1.0)))
    world.add(carom.Circle((3.0, 5.0), 1.0, solid=True))
    world.add(carom.Arc((7.0, 5.0), 1.0, 0.0, 3.0))
    for x, y in ((5.0, 1.6), (3.0, 6.6), (7.0, 6.6)):
        world.add(carom.Ball((x, y), radius=0.5, velocity=(0.0, -6.0)))
    live = draw.Live(world, BOX, SIZE, layers={layer})
    bare = drawn(live)
    for _ in range(3):
        live.note(world.step(1 / 60))
    seen = drawn(live)
    for x, y in ((5.0, 1.0), (3.0, 6.0), (7.0, 6.0)):
        column, line = (round(place) for place in live.frame.pixel(x, y))
        around = slice(column - 12, column + 13), slice(line - 12, line + 13)
        assert (seen[around] != bare[around]).any(), (x, y)


@pytest.mark.compiled
def test_old_hits_fade_away() -> None:
    world = room()
    world.balls[0].velocity = (0.0, -3.0)
    live = draw.Live(world, BOX, SIZE, layers={Layer.HITS})
    bare = drawn(live)
    for _ in range(600):
        live.note(world.step(1 / 60))
    assert world.balls[0].velocity[1] == pytest.approx(0.0, abs=0.2)
    assert (drawn(live) == bare).all()


def test_the_way_of_a_ball_is_shown_while_it_is_there() -> None:
    world = room()
    live = draw.Live(world, BOX, SIZE, layers={Layer.TRACKS})
    bare = drawn(live)
    first = world.balls[0]
    first.velocity = (0.0, 8.0)
    for _ in range(6):
        live.note(world.step(1 / 60))
    assert (drawn(live) != bare).any()
    world.remove(first)
    live.note(world.step(1 / 60))
    assert (drawn(live) == bare).all()


def test_a_ball_that_comes_later_is_drawn_at_its_size_and_its_way_is_shown() -> None:
    world = room()
    live = draw.Live(world, BOX, SIZE, layers={Layer.TRACKS, Layer.BALLS})
    live.note(world.step(1 / 60))
    before = drawn(live)
    world.add(carom.Ball((3.0, 8.0), radius=1.5, velocity=(20.0, 0.0)))
    for _ in range(12):
        live.note(world.step(1 / 60))
    seen = drawn(live)
    x, y = world.balls[1].position
    assert (at(seen, live, x, y + 1.3) != at(before, live, x, y + 1.3)).any(), "as large as it is"
    assert (seen[64:80, 30:60] != before[64:80, 30:60]).any(), "its way"


def test_a_ball_that_grows_is_drawn_as_large_as_it_is() -> None:
    world = room()
    live = draw.Live(world, BOX, SIZE, layers={Layer.BALLS})
    before = drawn(live)
    world.balls[0].radius = 1.5
    after = drawn(live)
    assert (at(after, live, 6.0, 3.3) != at(before, live, 6.0, 3.3)).any()


def test_a_ball_that_sleeps_looks_different_and_sleeps_on() -> None:
    world = carom.World(sleep_speed=0.1, sleep_time=0.02)
    ball = world.add(carom.Ball((5.0, 5.0), radius=2.0))
    live = draw.Live(world, BOX, SIZE, layers={Layer.BALLS})
    awake = at(drawn(live), live, 5.0, 5.0)
    for _ in range(3):
        live.note(world.step(1 / 60))
    assert ball.asleep
    assert (at(drawn(live), live, 5.0, 5.0) != awake).any()
    live.note(world.step(1 / 60))
    assert ball.asleep


def test_the_still_part_can_be_drawn_over_something_else() -> None:
    live = draw.Live(room(), BOX, SIZE, layers={Layer.SHAPES})
    surface = pygame.Surface(SIZE)
    surface.fill((1, 2, 3))
    live.draw_still(surface, ground=False)
    pixels = pygame.surfarray.array3d(surface)
    assert (at(pixels, live, 5.0, 5.0) == (1, 2, 3)).all()
    assert (at(pixels, live, 5.0, 1.0) != (1, 2, 3)).any()


def test_a_size_is_in_whole_pixels() -> None:
    with pytest.raises(carom.InvalidArgument, match="size"):
        draw.Live(room(), BOX, (200, 10))


@pytest.mark.parametrize("box", [carom.Aabb(1.0, 0.0, 1.0, 5.0), carom.Aabb(0.0, 2.0, 5.0, 2.0)])
def test_a_box_without_extent_is_refused(box: carom.Aabb) -> None:
    with pytest.raises(carom.InvalidArgument, match="box must have a width and a height"):
        draw.Live(room(), box, SIZE)


@pytest.mark.parametrize("broad_phase", ["grid", "quadtree", "brute"])
def test_a_partition_is_that_of_the_world_as_it_is_set(broad_phase: str) -> None:
    world = room()
    world.broad_phase = broad_phase
    world.levels = 3
    for k in range(30):
        world.add(carom.Point((0.3 * k, 9.0)))
    partition = draw.partition_of(world)
    if broad_phase == "brute":
        assert partition == draw.Partition(0, 0, ())
        return
    assert 0 < len(partition.cells) <= partition.leaves
    assert sum(cell.shapes for cell in partition.cells) >= 32
    if broad_phase == "quadtree":
        # Every node that is no leaf has four children.
        assert partition.nodes == 1 + 4 * (partition.nodes - partition.leaves)
        assert partition.leaves <= 4**3
    else:
        assert partition.nodes == 0


def test_a_zoomed_picture_shows_the_same_in_finer_pixels() -> None:
    world = room()
    small = draw.Live(world, BOX, SIZE, layers=set(Layer))
    large = draw.Live(world, BOX, (400, 400), layers=set(Layer), zoom=2)
    hits = world.step(0.2)
    for live in (small, large):
        live.note(hits)
    surface = pygame.Surface((400, 400))
    large.draw(surface)
    halved = pygame.surfarray.array3d(surface).astype(float).reshape(200, 2, 200, 2, 3).mean(axis=(1, 3))
    means = [pixels.reshape(20, 10, 20, 10, 3).mean(axis=(1, 3)) for pixels in (halved, drawn(small))]
    assert np.abs(means[0] - means[1]).max() < 20.0
    assert large.frame.pixel(3.0, 4.0) == small.frame.pixel(3.0, 4.0), "places are those of the layout"
    wide = draw.Live(world, BOX, (400, 400), layers=set(Layer))
    wide.draw(surface)
    thinner = pygame.surfarray.array3d(surface).astype(float).reshape(200, 2, 200, 2, 3).mean(axis=(1, 3))
    assert np.abs(thinner - halved).max() > 20.0, "its lines are not as wide"


@pytest.mark.parametrize("zoom", [0, 9, 1.5])
def test_a_zoom_that_there_is_not_is_refused(zoom: Any) -> None:
    with pytest.raises(carom.InvalidArgument, match="zoom"):
        draw.Live(room(), BOX, SIZE, zoom=zoom)


def test_compounds_and_groups_may_be_said_to_change() -> None:
    world = carom.World()
    brick = world.add(carom.Group(carom.outlines.rectangle(0.0, 0.0, 1.0, 1.0), name="brick"))
    mill = world.add(carom.Compound([carom.Segment((0, 5), (1, 5))], pivot=(0, 5)))
    draw.Live(world, BOX, SIZE, changing=[brick, mill])
    with pytest.raises(carom.InvalidArgument, match="changing must be shapes"):
        draw.Live(world, BOX, SIZE, changing=[carom.Ball((0, 0), 1)])  # type: ignore[list-item]
