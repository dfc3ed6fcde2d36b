"""What would become of a ball: a table of one's own, on which presses are tried before they are made."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

import carom
from carom.play.pinball.rules.lamps import BANK, SAUCER
from carom.play.pinball.rules.table import BALL_RADIUS, STEP, Table

#: What it is worth to a player to strike or cross a part.
WORTHS = {
    **dict.fromkeys(("left orbit", "right orbit"), 2500.0),
    **dict.fromkeys(BANK, 2000.0),
    SAUCER: 1500.0,
    **dict.fromkeys(("left lane", "middle lane", "right lane"), 900.0),
    **dict.fromkeys(("left bumper", "right bumper", "low bumper"), 250.0),
    **dict.fromkeys(("left target", "right target"), 300.0),
    **dict.fromkeys(("left slingshot's band", "right slingshot's band"), -150.0),
    **dict.fromkeys(("left outlane", "right outlane"), -4000.0),
    **dict.fromkeys(("left inlane", "right inlane"), 400.0),
    "drain": -8000.0,
}
#: What a ball is worth that lies still on a raised flipper, and each unit of height that it has reached in the end.
CRADLED, HEIGHT = 900.0, 20.0
#: A ball is at rest below this speed, in units/s.
REST = 6.0


#: A ball's x, y and velocity.
State = tuple[float, float, float, float]


class Presses(NamedTuple):
    """What is pressed: steps from now at which the left and the right button change, by turns."""

    left: tuple[int, ...] = ()
    right: tuple[int, ...] = ()


class Foresight:
    """A table with one ball, set as the real one stands, on which time runs ahead."""

    def __init__(self) -> None:
        self.table = Table()
        self.ball = self.table.world.add(carom.Ball((9.3, 22.0), BALL_RADIUS))
        self._worths = {key: WORTHS.get(part.name, 0.0) for key, part in self.table.parts.items()}

    def track(self, real: Table, state: State, presses: Presses, steps: int, every: int) -> list[tuple[float, float]]:
        """Where a ball would be after each `every` steps, if the buttons changed so at once."""
        self._set(real, state)
        self._change(presses, 0)
        places = []
        for _ in range(0, steps, every):
            self._run(every)
            places.append(self.ball.position)
        return places

    def worth(self, real: Table, state: State, presses: Presses, steps: int) -> float:
        """How good it is for a player if the buttons change so, looked at for a number of steps."""
        self._set(real, state)
        now, worth = 0, 0.0
        for at in sorted({*presses.left, *presses.right}):
            worth += self._run(at - now)
            self._change(presses, at)
            now = at
        worth += self._run(steps - now)
        x, y = self.ball.position
        vx, vy = self.ball.velocity
        if vx * vx + vy * vy < REST * REST and self.table.cradled(x, y):
            worth += CRADLED
        return worth + HEIGHT * y

    def _change(self, presses: Presses, now: int) -> None:
        """Press or let go what changes at a step."""
        for flipper, ats in ((self.table.left, presses.left), (self.table.right, presses.right)):
            if now in ats:
                flipper.press(not flipper.pressed)

    def _set(self, real: Table, state: State) -> None:
        """Set the table as the real one stands, with the ball in a state of x, y and velocity."""
        table = self.table
        x, y, vx, vy = state
        self.ball.position = (x, y)
        self.ball.velocity = (vx, vy)
        table.left.put(real.left.angle, real.left.pressed)
        table.right.put(real.right.angle, real.right.pressed)
        table.saucer_open = real.saucer_open
        if table.down != real.down:
            table.raise_targets()
            for name in sorted(real.down):
                table.lower(name)

    def _run(self, steps: int) -> float:
        """The worth of what the ball meets in a number of steps."""
        if steps <= 0:
            return 0.0
        hits = self.table.world.run(steps * STEP, STEP).view(np.ndarray)
        met = hits["shape"][hits["kind"] != carom.HitKind.EXIT]
        return sum(self._worths.get(shape, 0.0) for shape in dict.fromkeys(met.tolist()))


def sweeps(table: Table, places: Sequence[tuple[float, float]], left: bool) -> list[int]:
    """The indices of the places at which a ball lies within the sweep of a flipper, on its outer part."""
    flipper = table.left if left else table.right
    pivot_x, pivot_y = flipper.shape.pivot
    found = []
    for index, (x, y) in enumerate(places):
        along, up = flipper.up * (x - pivot_x), y - pivot_y
        if 1.2 < along < 4.6 and -2.6 < up < 2.6 and along * along + up * up < 4.4 * 4.4:
            found.append(index)
    return found
