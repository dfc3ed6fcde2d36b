"""The link from hits and answers to their world: it goes with the world in a copy, and leads nowhere without it."""

import copy
import pickle

import pytest

import carom
from tests.worlds import quiet


def test_hits_that_are_copied_with_their_world_are_of_the_copy_in_whatever_order() -> None:
    world = quiet()
    hits = world.run(2.0)
    for turned in (False, True):
        for copied in (copy.deepcopy, lambda pair: pickle.loads(pickle.dumps(pair))):
            pair = copied((hits, world) if turned else (world, hits))
            twin, twin_hits = reversed(pair) if turned else pair
            assert twin is not world
            assert [hit.ball for hit in twin_hits] == [twin.object(hit.ball.id) for hit in hits]
            assert all(hit.ball.world is twin for hit in twin_hits)


def test_hits_that_are_copied_alone_are_of_the_same_world_and_those_that_are_pickled_alone_of_none() -> None:
    world = quiet()
    hits = world.run(2.0)
    assert [hit.ball for hit in copy.deepcopy(hits)] == [hit.ball for hit in hits]
    pickled = pickle.loads(pickle.dumps(hits))
    assert pickled.tobytes() == hits.tobytes()
    with pytest.raises(carom.LostObject):
        list(pickled)


def test_all_hits_of_a_world_share_one_link() -> None:
    world = quiet()
    first, second = world.run(1.0), world.run(1.0)
    together = pickle.loads(pickle.dumps((first, second, world)))
    assert {hit.shape.world for hits in together[:2] for hit in hits} == {together[2]}
