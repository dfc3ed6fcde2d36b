"""Packages of the extras are imported when they are used; a missing one is asked for in one line."""

import sys

import pytest

import carom
from carom.extras import needed


def test_what_is_there_is_imported() -> None:
    assert needed("json", "json", "draw", "pictures") is sys.modules["json"]


def test_what_is_missing_is_asked_for(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "pygame", None)
    with pytest.raises(carom.MissingExtra) as caught:
        needed("pygame", "pygame-ce", "draw", "raster pictures")
    assert str(caught.value) == 'raster pictures need pygame-ce: pip install "carom[draw]"'
    assert isinstance(caught.value, ImportError)
