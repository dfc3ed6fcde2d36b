"""A discrete step: in which order shapes and balls are met, and how often."""

from carom import Arc, Ball, Circle, Point, Segment, World


def test_points_come_before_segments_circles_and_arcs_and_static_before_kinematic() -> None:
    world = World(detection="discrete", substeps=1, iterations=1)
    arc = world.add(Arc((0, 2), 2.4, 4, 5.5, motion="kinematic"))
    moving_circle = world.add(Circle((0, -1), 0.7, motion="kinematic"))
    moving_wall = world.add(Segment((-9, -0.4), (9, -0.4), motion="kinematic"))
    moving_post = world.add(Point((0, -0.5), motion="kinematic"))
    static_arc = world.add(Arc((0, 2), 2.2, 4, 5.5))
    circle = world.add(Circle((0, -1), 0.8))
    wall = world.add(Segment((-9, -0.2), (9, -0.2)))
    post = world.add(Point((0, -0.3)))
    for shape in world.shapes:
        shape.elasticity = 0.0
    expected = [post, wall, circle, static_arc, moving_post, moving_wall, moving_circle, arc]
    rows = world._arrays.shapes.used
    world._arrays.prepare()
    assert [int(rows[k]["id"]) for k in world._arrays.order[: len(rows)]] == [shape.id for shape in expected]


def test_a_post_at_a_joint_is_met_before_the_walls() -> None:
    for add_first in (True, False):
        world = World(detection="discrete", substeps=1)
        post = Point((0, 0))
        if add_first:
            world.add(post)
        world.add(Segment((-9, -0.5), (0, 0)))
        world.add(Segment((0, 0), (9, -0.5)))
        if not add_first:
            world.add(post)
        world.add(Ball((0, 1.05), radius=1, velocity=(0, -1)))
        hits = world.step(0.1)
        assert [hit.shape for hit in hits] == [post]


def test_pairs_come_after_shapes() -> None:
    world = World(detection="discrete", substeps=1)
    world.add(Ball((0, 1), radius=1, velocity=(0, -1)))
    world.add(Ball((2, 1), radius=1, velocity=(-1, 0)))
    world.add(Segment((-9, 0), (9, 0)))
    kinds = [hit.shape.kind for hit in world.step(0.1)]
    assert kinds[0] == "segment"
    assert "ball" in kinds[1:]


def test_a_ball_pushed_onto_a_shape_meets_it_in_the_next_iteration_and_once_more_after_the_last() -> None:
    for iterations, met in ((1, ["ball", "segment"]), (2, ["ball", "segment", "ball", "segment"])):
        world = World(detection="discrete", substeps=1, iterations=iterations)
        world.add(Segment((-9, 0), (9, 0)))
        world.add(Ball((0, 1), radius=1))
        world.add(Ball((0, 3), radius=1, velocity=(0, -1), mass=1e12))
        assert [hit.shape.kind for hit in world.step(0.1)] == met


def test_a_row_of_touching_balls_passes_a_push_on_by_one_ball_an_iteration_at_least() -> None:
    world = World(detection="discrete", substeps=1, iterations=6)
    balls = [world.add(Ball((2 * k, 0), radius=1)) for k in range(5)]
    balls[0].velocity = (1, 0)
    world.step(0.1)
    assert [ball.velocity[0] for ball in balls] == [0, 0, 0, 0, 1]


def test_an_iteration_that_finds_nothing_ends_them() -> None:
    world = World(detection="discrete", substeps=1, iterations=1000, broad_phase="brute")
    world.add(Ball((0, 0), radius=1))
    world.add(Ball((5, 0), radius=1))
    world.step(0.1)
    assert world.statistics.box_tests == 1


def test_boxes_are_compared_before_shapes() -> None:
    world = World(detection="discrete", substeps=1, broad_phase="brute")
    world.add(Point((5, 5)))
    world.add(Ball((0, 0), radius=1))
    world.step(0.1)
    assert (world.statistics.box_tests, world.statistics.full_tests) == (1, 0)
    world.add(Point((0.9, 0.9)))
    world.step(0.1)
    assert world.statistics.full_tests == 1
    assert world.statistics.collisions == 0
