"""Pages that play runs, opened in a real Chromium; skipped where there is none."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest

from carom import Recording
from carom.draw.page.page import replay_page
from tests.pages.chromium import chromium

if TYPE_CHECKING:
    from playwright.sync_api import Browser, BrowserContext, Page

#: The page as text is made once for each run.
text_of = cache(replay_page)


@dataclass
class Replay:
    """An open page, with all that it has said on the console and all that it has asked for."""

    page: Page
    said: list[str] = field(default_factory=list)
    asked: list[str] = field(default_factory=list)

    def __call__(self, script: str, argument: Any = None) -> Any:
        """What a script says in the page."""
        return self.page.evaluate(script, argument)

    def wait_until(self, script: str) -> None:
        """Waits until a script says yes; playwright's own way would need a page that may evaluate text."""
        for _ in range(200):
            if self(script):
                return
            self.page.wait_for_timeout(50)
        raise AssertionError(f"waited in vain for {script}")

    @property
    def time(self) -> float:
        """The time of the run that is shown."""
        return float(self("replay.player.time"))

    def seek(self, time: float) -> None:
        """Shows another time, drawn at once."""
        self("time => { replay.seek(time); replay.draw(performance.now()); }", time)

    def pixel(self, x: float, y: float) -> str:
        """The colour, `#rrggbb`, where a point of the world is shown."""
        return str(
            self(
                """([x, y]) => {
                  const { stage, view } = replay;
                  const place = [view.pixelX(x), view.pixelY(y)].map((pixel) => Math.floor(pixel * stage.ratio));
                  const colour = [...stage.context.getImageData(...place, 1, 1).data].slice(0, 3);
                  return "#" + colour.map((part) => part.toString(16).padStart(2, "0")).join("");
                }""",
                [x, y],
            )
        )

    def ink(self, name: str) -> str:
        """The colour of an ink in the theme that is used."""
        return str(self("ink => replay.stage.brush.inks[ink]", name))

    def picture(self) -> str:
        """All pixels of the canvas, as text."""
        return str(self("replay.draw(performance.now()), replay.stage.canvas.toDataURL()"))

    def show_only(self, *layers: str) -> None:
        """Shows some layers, and no others."""
        self("names => { replay.stage.shown = new Set(names); replay.stage.stale = true; }", list(layers))
        self("replay.draw(performance.now())")


@pytest.fixture(scope="session")
def browser() -> Iterator[Browser]:
    """A Chromium."""
    with chromium() as found:
        if found is None:
            pytest.skip("no Chromium: the replay page is not played")
        yield found


@pytest.fixture(scope="session")
def context(browser: Browser) -> BrowserContext:
    """What all pages are opened in: a new one for each would take longer than most tests."""
    return browser.new_context()


@pytest.fixture
def opened(context: BrowserContext, tmp_path: Path) -> Iterator[Callable[..., Replay]]:
    """Opens the page of a run; it must load without a word on the console, and ask for nothing."""
    pages: list[Page] = []

    def open_page(recording: Recording, width: int = 1280, height: int = 800, scheme: str = "light") -> Replay:
        path = tmp_path / "run.html"
        path.write_text(text_of(recording), encoding="utf-8")
        return open_file(path, width, height, scheme)

    def open_file(path: Path, width: int, height: int, scheme: str) -> Replay:
        page = context.new_page()
        pages.append(page)
        page.set_viewport_size({"width": width, "height": height})
        page.emulate_media(color_scheme=scheme)
        replay = Replay(page)
        page.on("console", lambda message: replay.said.append(message.text))
        page.on("pageerror", lambda error: replay.said.append(str(error)))
        page.on("request", lambda request: replay.asked.append(request.url))
        page.goto(path.as_uri())
        page.wait_for_selector("html[data-ready]", state="attached")
        return replay

    yield open_page
    for page in pages:
        page.close()
