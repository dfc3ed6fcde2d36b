"""The toy without its window: tables, launches, the hand, and every switch by name."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from tempfile import TemporaryDirectory
from types import MappingProxyType
from typing import Any

import platformdirs

import carom
from carom.play import files
from carom.play.toy.editor import Editor
from carom.play.toy.hand import Hand
from carom.play.toy.items import OPTIONS
from carom.play.toy.lane import Lane
from carom.play.toy.settings import ACTS, BOTH, SHOWN, Settings, apply
from carom.play.toy.table import Table
from carom.typing import Detection

#: Seconds of a step; slow motion makes shorter ones, so that balls still glide.
STEP = 1 / 60

#: The detection of each table, by what the settings call it.
KINDS: Mapping[str, tuple[Detection, ...]] = MappingProxyType(
    {"discrete": ("discrete",), "continuous": ("continuous",), BOTH: ("discrete", "continuous")}
)

#: What the settings are for a show of tunnelling: a ball at this speed moves by five of its radii an iteration.
TUNNELLING: Mapping[str, Any] = MappingProxyType(
    {"detection": BOTH, "motion": 1, "speed": 150, "size": 0.5, "count": 30, "pace": 1, "restitution": "normal"}
)


class Desk:
    """What the panel's switches act on.

    Attributes:
        settings: Everything that can be set.
        tables: One table, or a discrete and a continuous one that are given the same launches.
        lane: Where balls are launched.
        hand: What throws balls.
        running: False once the toy is to be closed.
        help: Whether the help is shown.
        cleared: Whether the tables were cleared since this was last set to False.
        editor: What changes the tables.
        told: What there is to be said of a file that was kept; "" until then.
    """

    def __init__(self) -> None:
        self.settings = Settings()
        self.tables: tuple[Table, ...] = (Table(),)
        self.lane = Lane(self.tables[0])
        self.hand = Hand()
        self.running = True
        self.help = False
        self.cleared = False
        self.editor = Editor()
        self.told = ""
        self._actions: dict[str, Callable[[], None]] = {
            "launch": lambda: self._launch(1),
            "launch many": lambda: self._launch(self.settings.count),
            "clear": self._clear,
            "step": self._single,
            "tunnelling": self._show_tunnelling,
            "save": self._save,
            "help": self._show_help,
            "quit": self._quit,
        }
        self._single_steps = 0
        self._obey()

    # -- switches ----------------------------------------------------------------------------------------------------

    def value(self, name: str) -> Any:
        """What a setting is; of a switch of what is shown, whether it is."""
        if name in SHOWN:
            return SHOWN[name] <= self.settings.layers
        return getattr(self.settings, name)

    def change(self, name: str, value: Any) -> None:
        """Set a setting, which acts at once."""
        settings = self.settings
        if name in SHOWN:
            layers = SHOWN[name]
            settings.layers = settings.layers | layers if value else settings.layers - layers
            return
        setattr(settings, name, value)
        if name == "detection":
            self._lay_out(value)
        elif name in ACTS:
            for table in self.tables:
                ACTS[name](table.world, value)

    def do(self, name: str) -> None:
        """Do what a button says: `launch`, `clear`, `step` and so on, by their names in `_actions`."""
        self._actions[name]()

    def press(self, name: str) -> None:
        """Do an action, switch a switch, or take the next option of a choice."""
        if name in self._actions:
            self.do(name)
        elif name in OPTIONS:
            options = OPTIONS[name]
            self.change(name, options[(options.index(self.value(name)) + 1) % len(options)])
        else:
            self.change(name, not self.value(name))

    def is_on(self, name: str) -> bool:
        """Whether a button is shown as switched on; one that only does something never is."""
        return name not in self._actions and bool(self.value(name))

    def _obey(self) -> None:
        """Set all tables as the settings say."""
        kinds = self.kinds
        for table, kind in zip(self.tables, kinds, strict=True):
            apply(self.settings, table.world, kind)

    @property
    def kinds(self) -> tuple[Detection, ...]:
        """The detection of each table."""
        return KINDS[self.settings.detection]

    def _lay_out(self, detection: str) -> None:
        """Put a second table next to the first, the same as that, or leave the one that is asked for."""
        if detection == BOTH and len(self.tables) == 1:
            twin = Table()
            twin.become(self.tables[0])
            self.tables = (self.tables[0], twin)
        elif detection != BOTH and len(self.tables) == 2:
            self.tables = (self.tables[detection == "continuous"],)
        self._obey()

    def _launch(self, count: int) -> None:
        self.lane.waiting += count

    def _clear(self) -> None:
        self.lane.waiting = 0
        self.hand.drop()
        self.cleared = True
        first, *others = self.tables
        first.clear()
        for other in others:
            kind = other.world.detection
            other.become(first)
            other.world.detection = kind

    def _show_tunnelling(self) -> None:
        """Send the same fast balls onto a discrete table and a continuous one, with one motion iteration."""
        self.change("paused", False)
        self.change("editing", False)
        for name, value in TUNNELLING.items():
            self.change(name, value)
        self._clear()
        self._launch(self.settings.count)

    def _save(self) -> None:
        """Keep the first table, as it stands, as a scene file that no other is lost to."""
        with TemporaryDirectory() as folder:
            path = Path(folder) / "table.toml"
            carom.Scene.from_world(self.tables[0].world).save(path)
            content = path.read_bytes()
        folders = files.places(platformdirs.user_documents_path())
        self.told = "table " + files.keep(folders, "carom-table-{}.toml", content)

    def _single(self) -> None:
        """Stop time, and let one step go by."""
        self.settings.paused = True
        self._single_steps += 1

    def _show_help(self) -> None:
        self.help = not self.help

    def _quit(self) -> None:
        self.running = False

    # -- time --------------------------------------------------------------------------------------------------------

    def advance(self, frames: int) -> Sequence[carom.Hits]:
        """The hits of each table in `frames` frames, of which none goes by in a pause but for single steps.

        In slow motion a frame is a shorter step, not a rarer one. While the table is edited, nothing goes by.
        """
        if self.settings.editing:
            return []
        if self.settings.paused:
            frames, self._single_steps = self._single_steps, 0
        parts: list[carom.Hits] = []
        for _ in range(frames):
            parts += self._frame(STEP / self.settings.pace)
        return parts

    def _frame(self, dt: float) -> list[carom.Hits]:
        """The hits of each table in one step."""
        self.lane.feed(self.tables, min(self.settings.size, self.lane.widest), self.settings.speed)
        self.hand.pull(self.tables, dt)
        return [table.step(dt) for table in self.tables]
