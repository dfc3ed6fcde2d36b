"""The Pinball Game: a table with bumpers, lanes, a bank of drop targets and multiball, three balls a game."""

from carom.play.pinball.app import PinballApp, run
from carom.play.pinball.controls import Control, Phase
from carom.play.pinball.events import Event, EventKind
from carom.play.pinball.game import Pinball
from carom.play.pinball.lamps import LampState
from carom.play.pinball.ledger import Ledger
from carom.play.pinball.player import Player
from carom.play.pinball.scores import HighScores, Score

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
