"""The shipped tasks: their names, what Gymnasium calls them, and that they can be done well and badly."""

import subprocess
import sys

import gymnasium
import numpy as np
import pytest

import carom
from carom.rl import TaskEnv, TaskVectorEnv, tasks
from carom.rl.names import Names


def test_all_are_found_by_name_and_registered() -> None:
    assert tasks.__all__ == ["breakout", "pinball", "pool"]
    for name in tasks.__all__:
        assert tasks.by_name(name).name == name
        spec = gymnasium.spec(f"carom/{name.capitalize()}-v0")
        assert spec.kwargs == {"task": name}
        assert (spec.entry_point, spec.vector_entry_point) == ("carom.rl:TaskEnv", "carom.rl:TaskVectorEnv")
    with pytest.raises(carom.TaskError, match="no shipped task is called 'chess'; there are breakout, pinball, pool"):
        tasks.by_name("chess")


def test_what_gives_points_is_on_the_table() -> None:
    names = Names(tasks.pinball().scene.build())
    worth = {name for points in tasks.pinball().reward.points for name in matching(names, points.shapes)}
    assert {"left bumper", "low bumper", "right slingshot's band", "left target", "right orbit"} <= worth
    assert {"drop target 2", "middle lane"} <= worth
    assert not {"drain", "plunger lane", "left wall", "left inlane"} & worth
    bricks = [set(matching(Names(tasks.breakout().scene.build()), p.shapes)) for p in tasks.breakout().reward.points]
    assert [len(one) for one in bricks] == [21, 21, 21]
    assert not bricks[0] & bricks[1]
    cleared = matching(Names(tasks.breakout().scene.build()), tasks.breakout().end.cleared or "")
    assert set(cleared) == set.union(*bricks)


def matching(names: Names, pattern: str) -> list[str]:
    """The names of what an expression means."""
    return [name for name, one in zip(names.columns, names.columns_like(pattern), strict=False) if one]


@pytest.mark.slow
@pytest.mark.compiled
def test_a_straight_shot_pots_the_eight_and_one_away_from_it_does_not() -> None:
    task = tasks.pool().model_copy(update={"start": ()})
    aimed = np.array(carom.scenes.pool().balls[0].velocity) / 500.0
    env = TaskEnv(task)
    env.reset(seed=1)
    *_, reward, terminated, truncated, _ = env.step(aimed)
    assert (reward, terminated, truncated) == (1.0, True, False)
    env.reset(seed=1)
    assert env.step(0.2 * aimed)[1] == 0.0


@pytest.mark.slow
@pytest.mark.compiled
def test_who_follows_the_ball_takes_bricks_and_who_rests_does_not() -> None:
    task = tasks.breakout()
    task = task.model_copy(update={"end": task.end.model_copy(update={"seconds": 20.0})})

    def played(follow: bool) -> float:
        env = TaskVectorEnv(task, 8)
        seen, _ = env.reset(seed=1)
        total, over = np.zeros(8), np.zeros(8, bool)
        for _ in range(20 * 60):
            off = np.round(8.0 * (seen[:, 0] - seen[:, 4])) if follow else np.zeros(8)
            seen, reward, terminated, truncated, _ = env.step(1 + np.sign(off).astype(int))
            total += reward * ~over
            over |= terminated | truncated
            if over.all():
                break
        return float(total.sum())

    assert played(follow=True) > 3.0 * played(follow=False)


def test_importing_carom_imports_none_of_it_and_a_missing_package_is_named() -> None:
    program = (
        "import sys, carom; assert 'carom.rl' not in sys.modules and 'gymnasium' not in sys.modules\n"
        "sys.modules['gymnasium'] = None\n"
        "try:\n    import carom.rl\nexcept carom.MissingExtra as error:\n    print(error)"
    )
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == 'environments for agents need gymnasium: pip install "carom[rl]"'
