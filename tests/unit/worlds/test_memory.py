"""The memory of all copies: its parts are views that do not overlap, and larger memory holds the same."""

import numpy as np

from carom.worlds.memory import Memory

PARTS = ("state", "balls", "saved", "flights", "moving", "switches", "in_play")


def test_parts_do_not_overlap() -> None:
    memory = Memory(3, 2, True, 2, 3, 4)
    for number, name in enumerate(PARTS):
        part = getattr(memory, name)
        part.reshape(3, -1).view(np.uint8)[...] = number + 1
        assert np.shares_memory(part, memory.words)
    for number, name in enumerate(PARTS):
        assert (getattr(memory, name).reshape(3, -1).view(np.uint8) == number + 1).all(), name


def test_more_room_holds_the_same() -> None:
    memory = Memory(2, 3, True, 1, 2, 4)
    memory.words[...] = np.random.default_rng(1).integers(-(2**60), 2**60, memory.words.shape)
    larger = memory.resized(5, 9)
    for name in PARTS:
        before, after = getattr(memory, name), getattr(larger, name)
        after = after[:, :2] if name == "switches" else after
        assert before.tobytes() == after.tobytes(), name
    for part, words in (("queue_at", 3), ("relations_at", 4 * 4)):
        begin, to = int(memory.layout[0][part]), int(larger.layout[0][part])
        assert (memory.words[:, begin : begin + words] == larger.words[:, to : to + words]).all()


def test_without_flights_there_is_no_room_for_them() -> None:
    flying, discrete = (Memory(1, 4, flies, 0, 0, 0) for flies in (True, False))
    assert discrete.flights.shape == (1, 0)
    assert flying.flights.shape == (1, 4)
    assert discrete.words.shape[1] < flying.words.shape[1]
