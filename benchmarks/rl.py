"""Environments for agents: steps a second of many copies, beside Gymnasium's processes, and Python's part in a step."""

import sys
from collections.abc import Callable
from functools import partial
from time import perf_counter, process_time
from typing import Any

from benchmarks.common import Figure

TITLE = "Environments: pinball, 8 substeps in a step of 1/60 s, flippers moving by chance"
#: Copies that Gymnasium's processes step: one process for each.
PROCESSES = 2


def begun(env: Any, steps: int) -> list[Any]:
    """Actions for so many steps of an environment, which has made one."""
    env.reset(seed=1)
    env.action_space.seed(1)
    actions = [env.action_space.sample() for _ in range(steps)]
    env.step(actions[0])
    return actions


def seconds(env: Any, actions: list[Any], clock: Callable[[], float]) -> float:
    """What the steps take by a clock."""
    began = clock()
    for action in actions:
        env.step(action)
    return clock() - began


def rate(env: Any, steps: int) -> float:
    """Steps a second of all copies together."""
    return float(steps * env.num_envs / seconds(env, begun(env, steps), perf_counter))


def shares(copies: int, steps: int) -> tuple[float, float]:
    """Seconds of the processor for a step of an environment on one thread, and those outside of `Worlds.step`."""
    from carom.rl import TaskVectorEnv
    from carom.worlds import Worlds

    spent = 0.0
    inside: Callable[..., Any] = Worlds.step

    def clocked(worlds: Worlds, dt: float) -> Any:
        nonlocal spent
        began = process_time()
        try:
            return inside(worlds, dt)
        finally:
            spent += process_time() - began

    env = TaskVectorEnv("pinball", copies, threads=1)
    actions = begun(env, steps)
    Worlds.step = clocked  # type: ignore[assignment, method-assign]
    try:
        whole = seconds(env, actions, process_time)
    finally:
        Worlds.step = inside  # type: ignore[method-assign]
    return whole / steps, (whole - spent) / steps


def run(quick: bool) -> list[Figure]:
    """Steps a second by numbers of copies; the same by processes; and what of a step is Python's."""
    try:
        import gymnasium

        import carom.rl
    except ImportError as error:
        sys.stderr.write(f"{error}\n")
        return []
    steps, most = (5, 64) if quick else (200, 4096)
    figures = []
    for copies in (1, 64, most):
        value = rate(carom.rl.TaskVectorEnv("pinball", copies), steps)
        figures.append(Figure(f"copies: {copies}", "carom", value, "steps/s"))
    single: Any = partial(gymnasium.make, "carom/Pinball-v0")
    for name, made in (("sync", gymnasium.vector.SyncVectorEnv), ("async", gymnasium.vector.AsyncVectorEnv)):
        env: Any = made([single] * PROCESSES)
        figures.append(Figure(f"single ones: {PROCESSES}", f"gymnasium, {name}", rate(env, steps), "steps/s"))
        env.close()
    whole, python = shares(most, steps)
    share = {"of it": f"{100.0 * python / whole:.1f}%"}
    figures.append(Figure(f"a step of {most} copies, one thread", "all of it", 1e3 * whole, "ms"))
    figures.append(
        Figure(f"a step of {most} copies, one thread", "outside Worlds.step", 1e3 * python, "ms", remarks=share)
    )
    return figures
