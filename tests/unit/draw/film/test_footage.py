"""What there is to be seen at each frame of a recording."""

import numpy as np
import pytest

import carom
from carom import draw
from carom.draw.film.film import FILM_HITS, SPAN
from carom.draw.film.footage import Footage
from carom.draw.parts.looks import OFF
from tests.worlds import quiet


def test_what_changes_is_drawn_as_it_is(recording: carom.Recording) -> None:
    footage = Footage(recording)
    still = {drawn.id for drawn in footage.still}
    before, looks_before = footage.moment(20, SPAN), {drawn.id: drawn.look for drawn in footage.moment(20, SPAN).moving}
    after, looks_after = footage.moment(50, SPAN), {drawn.id: drawn.look for drawn in footage.moment(50, SPAN).moving}
    first = int(recording.shape_ids[0])
    assert first not in still
    assert looks_before[first] is not OFF
    assert looks_after[first] is OFF
    assert set(recording.moving.tolist()) < set(looks_after)
    assert len(before.balls.ids) == 20
    assert len(after.balls.ids) == 19
    assert footage.facts(20) == (
        ("time", "0.33\N{NO-BREAK SPACE}s"),
        ("balls", "20"),
        ("hits", footage.facts(20)[2][1]),
    )


def test_tracks_and_hits_are_those_of_the_last_seconds(recording: carom.Recording) -> None:
    moment = Footage(recording).moment(60, 0.25, 2)
    assert moment.since == pytest.approx(0.75)
    assert len(moment.hits) == 2
    assert moment.hits["time"].min() >= 0.75
    assert (np.diff(moment.hits["impulse"]) <= 0.0).all()
    ball = int(moment.balls.ids[3])
    (track,) = [track for track in moment.tracks if track.ball == ball]
    assert track.points[-1].tolist() == recording.positions[60, recording.ids == ball][0].tolist()
    assert FILM_HITS > 2


def test_without_shapes_all_places_of_the_balls_are_shown() -> None:
    world = carom.World()
    world.add(carom.Ball((0, 0), 1, velocity=(30, 0)))
    picture = draw.picture_at(carom.Recording.of(world, 0.5))
    assert picture.frame.stage.left < -1.0
    assert picture.frame.stage.right > 16.0
    nothing = draw.picture_at(carom.Recording.of(carom.World(), 0.0))
    assert nothing.frame.shows(0.0, 0.0)


def test_the_panel_counts_what_is_there_and_what_has_happened(recording: carom.Recording) -> None:
    footage = Footage(recording)
    for frame in (0, 29, 45, 60):
        told = dict(footage.facts(frame))
        assert int(told["balls"]) == int((~np.isnan(recording.positions[frame, :, 0])).sum())
        assert int(told["hits"]) == sum(
            hit["time"] <= recording.times[frame] for hit in recording.hits if hit["kind"] == carom.HitKind.BOUNCE
        )


def test_balls_that_are_gone_or_have_not_moved_yet_have_no_track() -> None:
    world = quiet()
    recorder = carom.Recorder(world)
    recorder.note(world.step(1 / 60))
    stays, goes = world.balls.id.tolist()
    world.remove(world.object(goes))
    recorder.note(world.step(1 / 60))
    footage = Footage(recorder.finish())
    tracks = [{track.ball for track in footage.moment(frame, SPAN).tracks} for frame in range(3)]
    assert tracks == [set(), {stays, goes}, {stays}]


def test_what_stays_as_it_is_stands_in_every_frame(recording: carom.Recording) -> None:
    footage = Footage(recording)
    changing = {*recording.moving.tolist(), int(recording.shape_ids[0])}
    assert {drawn.id for drawn in footage.still} == set(recording.shape_ids.tolist()) - changing


@pytest.mark.parametrize(("span", "told"), [(0.25, "0.25"), (SPAN, "1")])
def test_notes_tell_of_the_seconds_that_are_seen(recording: carom.Recording, span: float, told: str) -> None:
    picture = Footage(recording).picture(60, span, layers=[draw.Layer.TRACKS])
    assert picture.panel.notes == (f"Tracks of 16 of 20 balls, over the last {told}\N{NO-BREAK SPACE}s.",)
