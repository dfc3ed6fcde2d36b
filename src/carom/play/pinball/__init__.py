"""The Pinball Game: a table with bumpers, lanes, a bank of drop targets and multiball, three balls a game."""

from carom.play.pinball.robot.player import Player
from carom.play.pinball.rules.controls import Control, Phase
from carom.play.pinball.rules.events import Event, EventKind
from carom.play.pinball.rules.game import Pinball
from carom.play.pinball.rules.lamps import LampState
from carom.play.pinball.rules.ledger import Ledger
from carom.play.pinball.rules.scores import HighScores, Score
from carom.play.pinball.screen.app import PinballApp, run

__all__ = [
    "Control",
    "Event",
    "EventKind",
    "HighScores",
    "LampState",
    "Ledger",
    "Phase",
    "Pinball",
    "PinballApp",
    "Player",
    "Score",
    "run",
]
