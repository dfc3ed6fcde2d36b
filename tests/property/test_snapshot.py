"""Damaged snapshots are refused and leave the world as it was; crafted ones too, or they are worlds that can go on."""

import io
from collections.abc import Callable
from random import Random

import numpy as np
import pytest

import carom
from carom.world.snapshot import HASH_SIZE, MAGIC
from tests.snapshots import Parts, eventful, put_together, refused, sealed, taken_apart
from tests.worlds import quiet

DAMAGES = 1000


# -- damages by chance: the hash is wrong ------------------------------------------------------------------------------


def cut(data: bytearray, random: Random) -> bytes:
    """Less than there was."""
    return bytes(data[: random.randrange(len(data))])


def cut_from_the_middle(data: bytearray, random: Random) -> bytes:
    """A piece less."""
    start = random.randrange(len(data) - 1)
    del data[start : start + random.choice((1, 8, 100))]
    return bytes(data)


def flipped(data: bytearray, random: Random) -> bytes:
    """One bit or a few others."""
    for _ in range(random.choice((1, 1, 2, 20))):
        data[random.randrange(len(data))] ^= 1 << random.randrange(8)
    return bytes(data)


def extended(data: bytearray, random: Random) -> bytes:
    """More than there was."""
    place = random.choice((0, len(data), random.randrange(len(data))))
    data[place:place] = random.randbytes(random.choice((1, 8, 100)))
    return bytes(data)


def overwritten(data: bytearray, random: Random) -> bytes:
    """A piece of nothing, or of anything."""
    start = random.randrange(len(data) - 200)
    size = random.choice((8, 200))
    data[start : start + size] = random.choice((bytes(size), random.randbytes(size)))
    return bytes(data)


def exchanged(data: bytearray, random: Random) -> bytes:
    """Two pieces in each other's place."""
    first, second = sorted(random.sample(range(0, len(data) - 64, 64), 2))
    data[first : first + 64], data[second : second + 64] = data[second : second + 64], data[first : first + 64]
    return bytes(data)


def spliced(data: bytearray, random: Random) -> bytes:
    """The beginning of one snapshot and the end of another."""
    other = quiet().snapshot()
    place = random.randrange(len(MAGIC), len(other))
    return bytes(data[:place]) + other[place:]


def foreign(data: bytearray, random: Random) -> bytes:
    """Something else altogether."""
    start = random.choice((b"", MAGIC, b"\x93NUMPY\x01\x00", b"PK\x03\x04", b"\x80\x05"))
    return start + random.randbytes(random.randrange(200))


@pytest.fixture(scope="module")
def world() -> carom.World:
    """A world in the middle of things."""
    return eventful()


CHANCE = (cut, cut_from_the_middle, flipped, extended, overwritten, exchanged, spliced, foreign)


@pytest.mark.compiled
@pytest.mark.parametrize("damage", CHANCE, ids=lambda damage: damage.__name__)
def test_damages_by_chance_are_refused(world: carom.World, damage: Callable[[bytearray, Random], bytes]) -> None:
    random = Random(damage.__name__)
    good = world.snapshot()
    made = 0
    while made < DAMAGES // len(CHANCE):
        bad = damage(bytearray(good), random)
        if bad != good:
            made += 1
            assert refused(world, bad)


# -- crafted: the hash is right ----------------------------------------------------------------------------------------


def test_a_snapshot_that_was_taken_apart_and_put_together_is_the_same(world: carom.World) -> None:
    good = world.snapshot()
    assert put_together(taken_apart(good)) == good


def test_more_or_less_than_a_world_is_refused(world: carom.World) -> None:
    payload = world.snapshot()[len(MAGIC) + HASH_SIZE :]
    for wrong in (payload + b"\0", payload + payload, payload[:-1], b"", payload[: len(payload) // 2]):
        assert refused(world, sealed(wrong))


def test_no_snapshot_runs_code(world: carom.World) -> None:
    file = io.BytesIO()
    np.save(file, np.array([{"a": 1}], dtype=object), allow_pickle=True)
    assert refused(world, sealed(file.getvalue() * 6))


@pytest.mark.slow
@pytest.mark.parametrize("part", range(6))
def test_what_is_crafted_by_chance_is_refused_or_is_a_world_that_goes_on(world: carom.World, part: int) -> None:
    good = world.snapshot()
    random = Random(part)
    twin = carom.World(detection="discrete")
    accepted = 0
    for _ in range(60):
        parts = list(taken_apart(good))
        raw = bytearray(parts[part].tobytes())
        for _ in range(random.choice((1, 1, 3))):
            raw[random.randrange(len(raw))] ^= 1 << random.randrange(8)
        parts[part] = np.frombuffer(bytes(raw), parts[part].dtype).reshape(parts[part].shape)
        if refused(twin, put_together(Parts(*parts))):
            continue
        accepted += 1
        twin.restore(twin.snapshot())
        if twin.substeps < 100:
            try:
                twin.run(0.1)
            except carom.CaromError:
                twin.restore(good)
    assert accepted < 60


@pytest.mark.parametrize("part", Parts._fields)
def test_a_table_that_says_it_is_longer_than_the_snapshot_is_refused(world: carom.World, part: str) -> None:
    parts = taken_apart(world.snapshot())
    whole = getattr(parts, part)
    for shape in ((10**12,), (10**12, 0), (0, 10**12), (2**62, 2)):
        file = io.BytesIO()
        for name, array in parts._asdict().items():
            if name == part:
                header = {"descr": np.lib.format.dtype_to_descr(whole.dtype), "fortran_order": False, "shape": shape}
                np.lib.format.write_array_header_1_0(file, header)
            else:
                np.save(file, array)
        assert refused(world, sealed(file.getvalue())), shape
