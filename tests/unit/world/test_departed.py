"""What has left a world: kept for as long as hits may name it, and taken out once."""

import gc

import pytest

import carom


def busy_corner(detection: str = "discrete") -> carom.World:
    """A world in which two balls of two have several hits each in the first step."""
    world = carom.World(detection=detection, substeps=8)
    world.add(carom.Compound([carom.Segment((-5, 0), (5, 0))], (0, 0)), carom.Segment((0, 0), (0, 9)))
    world.add(carom.Circle((2, 2), 5, sensor=True, solid=True))
    world.add_balls([(1.1, 1.2), (-1.1, 1.3)], [(-20, -20), (20, -20)], 1.0)
    return world


@pytest.mark.parametrize("detection", ["discrete", "continuous"])
@pytest.mark.parametrize("what", ["ball", "shape", "several"])
def test_what_several_hits_name_is_removed_at_the_first_and_the_others_are_no_mistake(
    what: str, detection: str
) -> None:
    world = busy_corner(detection)
    hits = world.step(0.2)
    named = [
        hit.ball if what != "shape" else hit.shape.compound or hit.shape for hit in hits if hit.shape.kind != "ball"
    ]
    assert len({id(thing) for thing in named}) < len(named)
    if what == "several":
        world.remove(*named)
        world.remove(*named, *named)
    for thing in named:
        world.remove(thing)
    assert all(thing.world is None for thing in named)
    after = world.digest()
    for hit in world.step(0.0):  # the exits of what has been removed
        world.remove(*[thing for thing in (hit.ball, hit.shape) if thing in named])
    assert len(world.balls) == (2 if what == "shape" else 0)
    assert after != world.digest()


def test_strays_that_left_in_the_step_may_be_removed_again() -> None:
    world = carom.World(bounds=(-5, -5, 5, 5), remove_strays=True)
    world.add(carom.Point((0, 0)))
    world.add_balls([(-2, 0)], (20, 0), 1)
    for hit in world.run(2.0):
        world.remove(hit.ball)


def test_what_is_in_another_world_by_now_is_not_removed_from_the_one_that_it_left() -> None:
    world, other = busy_corner(), carom.World()
    (ball, *_) = [hit.ball for hit in world.step(0.2)]
    world.remove(ball)
    other.add(ball)
    with pytest.raises(carom.InvalidArgument, match="must be in this world"):
        world.remove(ball)
    assert ball.world is other
    part = carom.Compound([carom.Point((0, 9))], (0, 0))
    world.add(part)
    world.remove(part)
    world.remove(part)
    with pytest.raises(carom.InvalidArgument, match="must not be part of a compound"):
        world.remove(part.shapes[0])


@pytest.mark.slow
def test_hits_know_what_has_left_since_even_if_nobody_else_does() -> None:
    world = carom.World()
    world.add(carom.Segment((-5, 0), (5, 0)))
    world.add_balls([(0, 0.9), (3, 0.9)], (0, -1), 1.0)
    hits = world.step(0.1)
    positions = [ball.position for ball in world.balls]
    for ball in list(world.balls):
        world.remove(ball)
    del ball
    gc.collect()
    assert [hit.ball.position for hit in hits] == positions


def test_an_exit_knows_what_was_removed_even_if_nobody_else_does() -> None:
    world = carom.World()
    world.add(carom.Circle((0, 0), 3, sensor=True, solid=True, name="eye"))
    world.add_balls([(0, 0)], radius=1.0)
    world.step(0.1)
    world.remove(world.balls[0])
    gc.collect()
    (leave,) = world.step(0.1)
    assert (leave.kind, leave.shape.name, leave.ball.position) == (carom.HitKind.EXIT, "eye", (0, 0))


def test_the_hits_of_strays_know_them() -> None:
    world = carom.World(bounds=(-5, -5, 5, 5), remove_strays=True)
    world.add(carom.Point((0, 0)))
    world.add(carom.Point((0, 3)))
    known = world.add(carom.Ball((-2, 0), 1, (20, 0), name="known"))
    world.add_balls([(-2, 3)], (20, 0), 1)
    hits = world.run(2.0)
    assert len(world.balls) == 0
    assert {hit.ball.name for hit in hits} == {"known", None}
    assert known in [hit.ball for hit in hits]
    assert len({id(hit.ball) for hit in list(hits)}) == 2
