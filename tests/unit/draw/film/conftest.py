"""A recording for films."""

import pytest

import carom
from tests.worlds import crowded, recorded


@pytest.fixture(scope="session")
def recording() -> carom.Recording:
    """A second of a crowd, in which a ball leaves and a shape is switched off."""
    return recorded(crowded(20), 60, change=30, name="crowd")
