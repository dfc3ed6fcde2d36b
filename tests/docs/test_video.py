"""The docs' video: thirty seconds in six runs, made by the library alone, small enough to be kept."""

from pathlib import Path

import pytest

from tests.conventions.source_trees import ROOT

pytest.importorskip("pygame", reason='no pygame: pip install "carom[draw]"')
pytest.importorskip("imageio_ffmpeg", reason='no imageio-ffmpeg: pip install "carom[draw]"')

from carom import draw
from docs.figures import video
from tests.unit.draw.film.test_movie import seconds_in

KEPT = ROOT / "docs" / "static" / "carom.mp4"
LARGEST = 5_000_000


@pytest.mark.slow
def test_the_video_that_is_kept_is_half_a_minute_and_small() -> None:
    assert sum(seconds for _, seconds in video.RUNS) == 30.0
    assert seconds_in(KEPT) == pytest.approx(30.0, abs=0.2)
    assert KEPT.stat().st_size < LARGEST


@pytest.mark.slow
@pytest.mark.compiled
def test_each_run_of_the_video_can_be_made(tmp_path: Path) -> None:
    films = video.films(0.05)
    draw.write_film(films, tmp_path / "short.mp4")
    assert seconds_in(tmp_path / "short.mp4") == pytest.approx(1.5, abs=0.2)
    for film in films:
        moved = film.recording.positions[-1] - film.recording.positions[0]
        assert abs(moved).max() > 0.05, film.recording.name
