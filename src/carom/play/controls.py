"""Keys and game controllers as the actions of a game."""

from __future__ import annotations

from enum import IntEnum
from typing import TYPE_CHECKING, Generic, TypeVar

import pygame

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping

A = TypeVar("A")

#: How far a stick must be pushed, of 1, to count as pressed; and below which part of that it counts as let go.
PUSHED, LET_GO = 0.5, 0.35


class Button(IntEnum):
    """The buttons of a controller by their places; those of a hat and of the left stick are the same four."""

    SOUTH = 0
    EAST = 1
    WEST = 2
    NORTH = 3
    LEFT_SHOULDER = 4
    RIGHT_SHOULDER = 5
    BACK = 6
    START = 7
    LEFT = 100
    RIGHT = 101
    UP = 102
    DOWN = 103


class Controls(Generic[A]):
    """Follows keys and controllers by their events; `read` makes actions of them.

    Args:
        keys: The action of each key, by pygame's numbers.
        buttons: The action of each button of a controller.
        tell: Told in one line of a controller that comes or goes.
    """

    def __init__(self, keys: Mapping[int, A], buttons: Mapping[Button, A], tell: Callable[[str], None]) -> None:
        self._keys = keys
        self._buttons = buttons
        self._tell = tell
        self._sticks: dict[int, pygame.joystick.JoystickType] = {}
        self._down: set[tuple[int, Button]] = set()
        pygame.joystick.init()

    def read(self, event: pygame.event.Event) -> list[tuple[A, bool]]:
        """The actions that an event begins (True) or ends (False)."""
        if event.type in (pygame.KEYDOWN, pygame.KEYUP):
            action = self._keys.get(event.key)
            return [] if action is None else [(action, event.type == pygame.KEYDOWN)]
        if event.type in (pygame.JOYBUTTONDOWN, pygame.JOYBUTTONUP):
            if event.button not in {button.value for button in Button}:
                return []
            return self._change(event.instance_id, {Button(event.button): event.type == pygame.JOYBUTTONDOWN})
        if event.type == pygame.JOYHATMOTION:
            x, y = event.value
            return self._cross(event.instance_id, float(x), float(y))
        if event.type == pygame.JOYAXISMOTION and event.axis in (0, 1):
            # A stick's second axis points down.
            return self._push(event.instance_id, event.axis, event.value if event.axis == 0 else -event.value)
        if event.type in (pygame.JOYDEVICEADDED, pygame.JOYDEVICEREMOVED):
            return self._plug(event)
        return []

    def _cross(self, stick: int, x: float, y: float) -> list[tuple[A, bool]]:
        """The actions of a hat."""
        return self._change(
            stick, {Button.LEFT: x < 0.0, Button.RIGHT: x > 0.0, Button.UP: y > 0.0, Button.DOWN: y < 0.0}
        )

    def _push(self, stick: int, axis: int, value: float) -> list[tuple[A, bool]]:
        """The actions of a stick."""
        low, high = (Button.LEFT, Button.RIGHT) if axis == 0 else (Button.DOWN, Button.UP)
        return self._change(
            stick,
            {
                low: value < -(LET_GO if (stick, low) in self._down else PUSHED),
                high: value > (LET_GO if (stick, high) in self._down else PUSHED),
            },
        )

    def _change(self, stick: int, wanted: Mapping[Button, bool]) -> list[tuple[A, bool]]:
        """The actions of the buttons that are not as they were."""
        actions: list[tuple[A, bool]] = []
        for button, down in wanted.items():
            if down != ((stick, button) in self._down):
                (self._down.add if down else self._down.discard)((stick, button))
                if button in self._buttons:
                    actions.append((self._buttons[button], down))
        return actions

    def _plug(self, event: pygame.event.Event) -> list[tuple[A, bool]]:
        """The actions that end because a controller went; opens one that came."""
        if event.type == pygame.JOYDEVICEADDED:
            try:
                stick = pygame.joystick.Joystick(event.device_index)
            except pygame.error as error:
                self._tell(f"a controller cannot be used: {error}")
                return []
            self._sticks[stick.get_instance_id()] = stick
            self._tell(f"controller: {stick.get_name()}")
            return []
        gone = self._sticks.pop(event.instance_id, None)
        if gone is not None:
            self._tell("the controller is gone; the keys still work")
        held = [button for stick, button in self._down if stick == event.instance_id]
        return self._change(event.instance_id, dict.fromkeys(held, False))
