"""Environments for agents: tasks in scenes, one at a time or thousands at once, as Gymnasium has them.

`Task` says what an environment is; `TaskEnv` and `TaskVectorEnv` are made of one. Those of `tasks` are registered when
this is imported: `gymnasium.make("carom/Pinball-v0")`, `gymnasium.make_vec("carom/Pinball-v0", num_envs=4096)`, and
likewise `carom/Breakout-v0` and `carom/Pool-v0`. Needs Gymnasium, `pip install "carom[rl]"`.
"""

from carom.extras import needed

gymnasium = needed("gymnasium", "gymnasium", "rl", "environments for agents")

from carom.rl import tasks  # noqa: E402  # what is missing is asked for first
from carom.rl.descriptors import End, Impulse, Observation, Points, Reward, Spread, Travel, Turn  # noqa: E402
from carom.rl.env import TaskEnv  # noqa: E402
from carom.rl.task import Task  # noqa: E402
from carom.rl.vector_env import TaskVectorEnv  # noqa: E402

__all__ = [
    "End",
    "Impulse",
    "Observation",
    "Points",
    "Reward",
    "Spread",
    "Task",
    "TaskEnv",
    "TaskVectorEnv",
    "Travel",
    "Turn",
    "tasks",
]

for _name in tasks.__all__:
    gymnasium.register(
        f"carom/{_name.capitalize()}-v0",
        entry_point="carom.rl:TaskEnv",
        vector_entry_point="carom.rl:TaskVectorEnv",
        kwargs={"task": _name},
    )
