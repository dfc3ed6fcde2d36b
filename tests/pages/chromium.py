"""A real Chromium, where the machine has one."""

from __future__ import annotations

import shutil
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from playwright.sync_api import Browser

#: What Linux distributions and others call it.
PROGRAMS = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable")
#: Without a sandbox, which containers cannot give it; and without anything that asks the network.
OPTIONS = (
    "--no-sandbox",
    "--disable-gpu",
    "--disable-background-networking",
    "--disable-component-update",
    "--no-pings",
)


def found(own: str) -> str | None:
    """The path of a Chromium: the one that playwright has downloaded as its `own`, or one of the system's."""
    if Path(own).is_file():
        return own
    return next((path for path in map(shutil.which, PROGRAMS) if path), None)


@contextmanager
def chromium() -> Iterator[Browser | None]:
    """A running Chromium, or None where there is none that runs, or nothing to drive it."""
    try:
        from playwright.sync_api import Error, sync_playwright
    except ImportError:
        yield None
        return
    with sync_playwright() as playwright:
        path = found(playwright.chromium.executable_path)
        if path is None:
            yield None
            return
        try:
            browser = playwright.chromium.launch(executable_path=path, args=list(OPTIONS))
        except Error:
            yield None
            return
        yield browser
        browser.close()
