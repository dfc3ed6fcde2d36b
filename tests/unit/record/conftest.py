"""A recording to test."""

import pytest

import carom
from tests.worlds import crowded, recorded


@pytest.fixture(scope="module")
def recording() -> carom.Recording:
    """A recording of everything that a world can hold, a ball that leaves and a shape that is switched off among it."""
    return recorded(crowded(remove_strays=True), 20, change=9, name="crowd \ud800 </script>", about="all kinds")
