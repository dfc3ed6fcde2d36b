"""The tasks that come with carom: `carom.rl.tasks`, each an environment of Gymnasium too."""

from __future__ import annotations

from difflib import get_close_matches
from typing import Any

from carom.errors import TaskError
from carom.rl.descriptors import End, Impulse, Observation, Points, Reward, Spread, Travel, Turn
from carom.rl.task import Task
from carom.scene import scenes
from carom.scene.scene import Scene

#: How fast flippers turn up and down, in rad/s; as in the game.
UP, DOWN = 22.0, 16.0

#: The shipped tasks, and nothing else.
__all__ = ["breakout", "pinball", "pool"]


def by_name(name: Any) -> Task:
    """The shipped task called `name`. Raises `TaskError` if there is none."""
    if isinstance(name, str) and name in __all__:
        task: Task = globals()[name]()
        return task
    near = get_close_matches(str(name), __all__, n=1)
    hint = f"did you mean {near[0]!r}?" if near else f"there are {', '.join(__all__)}"
    raise TaskError(f"no shipped task is called {name!r}; {hint}")


def _quick(scene: Scene) -> Scene:
    """A scene in the discrete mode, in which many copies are stepped sooner."""
    return scene.model_copy(update={"world": scene.world.model_copy(update={"detection": "discrete"})})


def pinball() -> Task:
    """Pinball with one ball: keep it in play, and hit what gives points.

    Two numbers of 0 (down) or 1 (up), for the left flipper and the right one. Bumpers, slingshots and the shoulders'
    targets give a point for every bounce, orbits one for every pass, the bank's targets two, the lanes on top three. It
    ends when the ball drains, and is cut off after two minutes.
    """
    table = scenes.pinball()
    return Task(
        name="pinball",
        scene=_quick(table.model_copy(update={"balls": table.balls[:1]})),
        actuators=(
            Turn(shape="left flipper", speeds=(-DOWN, UP)),
            Turn(shape="right flipper", speeds=(DOWN, -UP)),
        ),
        observation=Observation(speed=60.0, turning="(left|right) flipper"),
        reward=Reward(
            points=(
                Points(shapes=".* bumper|.* slingshot's band|.* target|.* orbit", points=1.0),
                Points(shapes=r"drop target \d", points=2.0),
                Points(shapes="(left|middle|right) lane", points=3.0),
            )
        ),
        end=End(drain="drain", seconds=120.0),
        start=(Spread(velocity=(0.0, 4.0)),),
    )


def breakout() -> Task:
    """Breakout: keep the ball up with the paddle until all bricks are gone.

    One number: 0 lets the paddle go left, 1 rest, 2 go right. A brick of the two lowest rows gives a point, one of the
    next two four, one of the highest two seven. It ends when the ball is lost or the last brick gone, and is cut off
    after five minutes.
    """
    return Task(
        name="breakout",
        scene=_quick(scenes.breakout()),
        actuators=(Travel(shape="paddle", speeds=(-24.0, 0.0, 24.0), limits=(-9.0, 9.0)),),
        observation=Observation(travelling="paddle", lights="brick .*"),
        reward=Reward(
            points=(
                Points(shapes="brick [12].*", points=1.0),
                Points(shapes="brick [34].*", points=4.0),
                Points(shapes="brick [56].*", points=7.0),
            )
        ),
        end=End(drain="drain", cleared="brick .*", seconds=300.0),
        start=(Spread(position=(8.0, 0.0), angle=0.6),),
    )


def pool() -> Task:
    """Pool: pot the eight with one shot.

    Two numbers, x and y: the direction of the cue ball and, by their length, which counts up to 1, its speed. The eight
    in a pocket gives a point, the cue ball in one takes one. Every episode is one action, after which the balls roll
    for twelve seconds.
    """
    table = scenes.pool()
    balls = tuple(ball.model_copy(update={"velocity": (0.0, 0.0)}) for ball in table.balls)
    return Task(
        name="pool",
        scene=table.model_copy(update={"balls": balls}),
        actuators=(Impulse(ball="cue ball", speed=500.0),),
        observation=Observation(speed=500.0),
        reward=Reward(
            points=(
                Points(shapes=".* pocket", balls="eight", points=1.0, once=True),
                Points(shapes=".* pocket", balls="cue ball", points=-1.0, once=True),
            )
        ),
        end=End(bounds=False, actions=1),
        start=(Spread(balls="cue ball", position=(50.0, 25.0)), Spread(balls="eight", position=(50.0, 35.0))),
        steps=720,
    )
