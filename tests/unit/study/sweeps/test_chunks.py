"""Which runs go out together: every one until it is done or given up, none twice at the same time."""

from hypothesis import given, settings
from hypothesis import strategies as st

from carom.study.sweeps.chunks import MOST_DEATHS, MOST_IN_CHUNK, Chunk, Chunks


def test_the_first_chunks_are_single_runs_the_next_are_a_second_of_work() -> None:
    chunks = Chunks(range(100))
    assert chunks.next(0) == Chunk((0,), 1)
    assert chunks.next(1) == Chunk((1,), 1)
    chunks.done(2, 0.5)
    assert chunks.next(0) == Chunk((2, 3, 4, 5), 1)
    chunks.done(4, 1000.0)
    assert chunks.next(0) == Chunk((6,), 1)


def test_runs_that_take_no_time_fill_no_memory() -> None:
    chunks = Chunks(range(3 * MOST_IN_CHUNK))
    chunks.done(1, 0.0)
    chunk = chunks.next(0)
    assert chunk is not None
    assert len(chunk.places) == MOST_IN_CHUNK


@settings(max_examples=30)
@given(st.integers(1, 60), st.sets(st.integers(0, 59)), st.data())
def test_all_are_done_or_given_up_whoever_dies(count: int, deadly: set[int], data: st.DataObject) -> None:
    """A model of workers: deadly runs end their chunk, others die by accident, and what is out is blamed too."""
    chunks = Chunks(range(count), seconds=8.0)
    chance = data.draw(st.randoms(use_true_random=False))
    done: list[int] = []
    lost: list[int] = []
    flying: list[Chunk] = []
    accidents = 12
    while chunks or flying:
        while len(flying) < 4 and (chunk := chunks.next(len(flying))) is not None:
            assert not (chunk.alone and flying)
            flying.append(chunk)
        chunk = flying.pop(chance.randrange(len(flying)))
        accident = accidents > 0 and not chunk.alone and chance.random() < 0.3
        accidents -= accident
        if accident or deadly & set(chunk.places):
            # The scheduler blames all that the worker had been given.
            for other in [chunk, *(flying if accident or not chunk.alone else [])]:
                lost += chunks.died(other)
            flying = flying if chunk.alone else []
        else:
            done += chunk.places
            chunks.done(len(chunk.places), float(len(chunk.places)))
    assert sorted(done + lost) == list(range(count))
    assert set(lost) == deadly & set(range(count))


def test_a_run_is_given_up_after_its_own_deaths_alone() -> None:
    chunks = Chunks([7])
    for attempt in range(1, MOST_DEATHS + 2):
        chunk = chunks.next(0)
        assert chunk is not None
        assert chunk == Chunk((7,), attempt, alone=attempt > 1)
        assert chunks.next(1) is None
        assert chunks.died(chunk) == ([7] if attempt == MOST_DEATHS + 1 else [])
    assert not chunks
    chunks = Chunks([7])
    chunks.died(chunks.next(0) or Chunk((), 0))
    assert chunks.died(chunks.next(0) or Chunk((), 0), workers=4) == [7]
