"""What hits are worth, which balls they cost, and what is forgotten when an episode begins anew."""

from typing import Any

import numpy as np
import pytest

from carom.record.members import parts
from carom.rl import End, Points, Reward, Task
from carom.rl.names import Names
from carom.rl.scoring import Score
from carom.rows.hit import BOUNCE, ENTER, EXIT
from carom.shapes.label import name_of
from tests.rl_tasks import yard_task
from tests.slow_worlds import HIT_IN_COPY, SlowWorlds


class Desk:
    """A task's score, given hits by the names of what met."""

    def __init__(self, task: Task, copies: int = 2) -> None:
        world = task.scene.build()
        self.worlds: Any = SlowWorlds(task.scene, copies)
        self.score = Score(task, Names(world), copies)
        self.ids: dict[str | None, Any] = {name_of(part): part.id for part in parts(world.shapes)}
        self.ids |= {ball.name: ball.id for ball in world.balls}

    def count(self, *hits: tuple[int, str, str, int]) -> list[float]:
        """The rewards of hits: copy, ball, shape and kind."""
        rows = np.zeros(len(hits), HIT_IN_COPY)
        for row, (copy, ball, shape, kind) in zip(rows, hits, strict=True):
            row["world"], row["ball"], row["shape"], row["kind"] = copy, self.ids[ball], self.ids[shape], kind
        rewards: list[float] = self.score.count(self.worlds, rows).tolist()
        return rewards


def plain(*points: Points, **more: Any) -> Task:
    """A task of these points alone."""
    return yard_task(reward=Reward(points=points, **more), end=End(drain="drain", cleared="brick.*"))


def test_every_rule_that_means_a_hit_is_added() -> None:
    desk = Desk(plain(Points(shapes="bumper 1", points=2.0), Points(shapes=".* 1", points=0.5, balls="ball 2")))
    hits = [(0, "ball 1", "bumper 1", BOUNCE), (1, "ball 2", "bumper 1", BOUNCE), (1, "ball 2", "brick 1", BOUNCE)]
    assert desk.count(*hits) == [2.0, 3.0]
    assert desk.count(*hits[:2], *hits[:1]) == [4.0, 2.5]
    assert desk.count() == [0.0, 0.0]


def test_to_leave_a_sensor_is_worth_nothing_and_so_is_a_ball_that_was_hit() -> None:
    desk = Desk(plain(Points(shapes=".*", points=1.0)))
    assert desk.count((0, "ball 1", "drain", EXIT), (1, "ball 2", "ball 1", BOUNCE)) == [0.0, 0.0]
    assert desk.score.in_play.all()


def test_points_for_once_are_given_once_an_episode_to_each_ball() -> None:
    desk = Desk(plain(Points(shapes="bumper.*|wall", points=3.0, once=True)))
    hit = (0, "ball 1", "bumper 1", BOUNCE)
    assert desk.count(hit, hit, (0, "ball 1", "wall", BOUNCE)) == [3.0, 0.0]
    assert desk.count(hit, (0, "ball 2", "wall", BOUNCE), (1, *hit[1:])) == [3.0, 3.0]
    desk.score.clear(np.array([0]))
    assert desk.count(hit, (1, *hit[1:])) == [3.0, 0.0]


def test_a_drained_ball_is_lost_once_and_out_of_play_while_others_are() -> None:
    desk = Desk(plain(lost=-5.0, second=3.0))
    time = 3.0 * 2 / 30
    drained = (0, "ball 2", "drain", ENTER)
    assert desk.count(drained, drained) == pytest.approx([time - 5.0, time])
    assert desk.score.in_play.tolist() == [[True, False], [True, True]]
    assert desk.worlds.balls.in_play.tolist() == [[True, False], [True, True]]
    assert desk.count(drained) == pytest.approx([time, time])
    desk.score.clear(np.array([0]))
    assert desk.score.in_play.all()


def test_the_last_ball_stays_where_it_is_for_the_episode_is_over() -> None:
    desk = Desk(plain())
    desk.count((1, "ball 1", "drain", ENTER), (1, "ball 2", "drain", ENTER))
    assert desk.score.in_play.tolist() == [[True, True], [False, False]]
    assert desk.worlds.balls.in_play.all()


@pytest.mark.parametrize(
    ("place", "out"),
    [((-1.0, 11.0), False), ((-1.1, 5.0), True), ((11.1, 5.0), True), ((5.0, -1.1), True), ((5.0, 11.1), True)],
)
def test_a_ball_beyond_the_bounds_is_lost(place: tuple[float, float], out: bool) -> None:
    desk = Desk(plain(lost=-1.0))
    desk.worlds.balls.position[1, 0] = place
    assert desk.count() == [0.0, -1.0 if out else 0.0]
    unbounded = yard_task(reward=Reward(lost=-1.0), end=End(bounds=False))
    desk = Desk(unbounded)
    desk.worlds.balls.position[1, 0] = place
    assert desk.count() == [0.0, 0.0]


def test_what_is_lit_and_cleared_is_noted_and_forgotten() -> None:
    desk = Desk(plain())
    desk.count((0, "ball 1", "brick 2", BOUNCE), (1, "ball 1", "spinner", BOUNCE))
    assert desk.score.cleared.hit.tolist() == [[False, True], [False, False]]
    assert desk.score.lights.hit.sum(axis=1).tolist() == [1, 1]
    desk.score.clear(np.array([0, 1]))
    assert not desk.score.cleared.hit.any()
    assert not desk.score.lights.hit.any()
