"""The replay page: how large that of a minute with 100 balls is, and how many frames a second Chromium shows of it.

Run by itself, for it needs a Chromium: `python -m benchmarks.replay`. Frames are counted by the page's clock, so other
processes on the machine count; the milliseconds are the page's own, and those until the pixels of a frame are there.
"""

import sys
import tempfile
from pathlib import Path

from playwright.sync_api import Page
from rich.console import Console

import carom
from benchmarks.common import Figure, show
from benchmarks.setup import scattered
from carom import Recording
from carom.draw.page.page import replay_page
from tests.pages.chromium import chromium

TITLE = "Replay pages: 60 s with 100 balls"
BALLS, SECONDS = 100, 60.0
#: Seconds for which frames are counted, and drawings whose pixels are waited for.
WATCHED, DRAWN = 8.0, 120

PLAYED = """async (seconds) => {
  const moments = [];
  replay.seek(5);
  replay.player.play();
  await new Promise((done) => {
    const note = (now) => {
      moments.push(now);
      if (now - moments[0] < 1000 * seconds) requestAnimationFrame(note);
      else done();
    };
    requestAnimationFrame(note);
  });
  replay.player.pause();
  const gaps = moments.slice(1).map((moment, index) => moment - moments[index]).sort((one, other) => one - other);
  return {
    rate: (1000 * gaps.length) / (moments.at(-1) - moments[0]),
    median: gaps[Math.floor(gaps.length / 2)],
    late: gaps.filter((gap) => gap > 25).length,
    frames: gaps.length,
    work: replay.pace.work,
  };
}"""
WHOLE = """(count) => {
  const { stage } = replay;
  const began = performance.now();
  for (let frame = 0; frame < count; frame++) {
    stage.draw(5 + frame / 60);
    stage.context.getImageData(0, 0, 1, 1);
  }
  return (performance.now() - began) / count;
}"""


def gas() -> carom.World:
    """100 balls in a box, which never come to rest."""
    return carom.scenes.gas(BALLS).build()


def toy() -> carom.World:
    """The toy with balls let loose all over it, 100 in all: gravity, arcs, paddles that turn."""
    world = carom.scenes.toy().build()
    shapes = [part for shape in world.shapes for part in getattr(shape, "shapes", [shape])]
    for place in 1.0 + scattered(14, 11, 2.0, 0.3, seed=1):
        ball = carom.Ball(place, radius=0.3, velocity=(3.0, 2.0), elasticity=0.9)
        free = all(shape.detect(ball) is None for shape in shapes) and all(
            ball.detect(other) is None for other in world.balls
        )
        if free and len(world.balls) < BALLS:
            world.add(ball)
    return world


def watch(page: Page, path: Path) -> dict[str, float]:
    """What playing the page at `path` is like."""
    page.goto(path.as_uri())
    page.wait_for_selector("html[data-ready]", state="attached")
    return {**page.evaluate(PLAYED, WATCHED), "whole": page.evaluate(WHOLE, DRAWN)}


def run() -> list[Figure]:
    """The page's size in megabytes, and frames a second in a window of 1280 by 800 pixels."""
    figures = []
    with chromium() as browser, tempfile.TemporaryDirectory() as folder:
        for make in (gas, toy):
            recording = Recording.of(make(), SECONDS, name=make.__name__)
            path = Path(folder, "run.html")
            path.write_text(replay_page(recording), encoding="utf-8")
            remarks = {"balls": str(len(recording.ids)), "hits": f"{len(recording.hits):,}"}
            figures.append(Figure(f"{make.__name__}: size", "page", path.stat().st_size / 1e6, "MB", remarks=remarks))
            if browser is None:
                continue
            seen = watch(browser.new_page(viewport={"width": 1280, "height": 800}), path)
            remarks = {
                "between frames": f"{seen['median']:.1f} ms",
                "late": f"{seen['late']:.0f} of {seen['frames']:.0f}",
                "script": f"{seen['work']:.1f} ms a frame",
                "with its pixels": f"{seen['whole']:.1f} ms a frame",
            }
            figures.append(Figure(f"{make.__name__}: played", "page", seen["rate"], "frames/s", remarks=remarks))
    return figures


if __name__ == "__main__":
    console = Console() if sys.stdout.isatty() else Console(width=150)
    show(TITLE, run(), console)
