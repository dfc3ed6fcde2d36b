"""The Collision Math Toy: the table `toy`, and a panel with everything that lets a person see the mathematics."""

from carom.play.toy.app import run

__all__ = ["run"]
