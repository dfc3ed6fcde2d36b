"""Scenes: descriptions of worlds, their files, and those that are shipped."""

from carom.scene import shipped as scenes
from carom.scene.scene import Scene

__all__ = ["Scene", "scenes"]
