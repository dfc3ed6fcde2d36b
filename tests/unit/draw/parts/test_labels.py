"""Labels: over none of each other, on the stage, off the balls while there is room; those left out are counted."""

from itertools import combinations

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from carom.draw.parts.labels import FARTHER, GAP, Labels, Wish, placed

STAGE = (0.0, 0.0, 400.0, 300.0)
NO_BALLS = np.zeros((0, 4))

place = st.tuples(st.tuples(st.floats(-20.0, 420.0), st.floats(-20.0, 320.0)), st.floats(0.0, 30.0))
wish = st.builds(
    lambda width, places: Wish("name", width, 15.0, tuple(places)),
    st.floats(5.0, 160.0),
    st.lists(place, min_size=1, max_size=4),
)
wishes = st.lists(wish, max_size=24)
boxes = st.lists(
    st.tuples(st.floats(0.0, 380.0), st.floats(0.0, 280.0), st.floats(1.0, 60.0)).map(
        lambda box: (box[0], box[1], box[0] + box[2], box[1] + box[2])
    ),
    max_size=8,
)


def overlap(one: tuple[float, ...], other: tuple[float, ...]) -> bool:
    """Whether two boxes have more than an edge in common."""
    return one[0] < other[2] and other[0] < one[2] and one[1] < other[3] and other[1] < one[3]


@given(wishes, boxes, boxes)
def test_no_two_labels_overlap_and_none_is_lost(
    wanted: list[Wish], balls: list[tuple[float, ...]], taken: list[tuple[float, float, float, float]]
) -> None:
    labels = placed(wanted, STAGE, np.array(balls).reshape(-1, 4), taken)
    assert len(labels.found) + labels.left_out == len(wanted)
    shown = labels.boxes()
    assert not any(overlap(one, other) for one, other in combinations(shown, 2))
    assert not any(overlap(box, other) for box in shown for other in taken)
    assert all(left >= 0.0 and top >= 0.0 and right <= 400.0 and bottom <= 300.0 for left, top, right, bottom in shown)
    assert placed(wanted, STAGE, np.array(balls).reshape(-1, 4), taken) == labels


def at(x: float, y: float, clearance: float = 3.0) -> Wish:
    """A wish for one place."""
    return Wish("name", 40.0, 15.0, (((x, y), clearance),))


def test_the_first_place_is_above_and_a_line_leads_to_what_stands_farther_off() -> None:
    labels = placed([at(200.0, 150.0)] * 20, STAGE, NO_BALLS)
    assert labels.found[0].box == (180.0, 150.0 - 3.0 - GAP - 15.0, 220.0, 150.0 - 3.0 - GAP)
    near = [label for label in labels.found if label.leader is None]
    assert 4 <= len(near) <= 8
    far = [label for label in labels.found if label.leader is not None]
    assert far
    for label in far:
        assert label.leader is not None
        start, end = label.leader
        assert start == (200.0, 150.0)
        assert 0.7 * (3.0 + GAP + FARTHER[0]) <= np.hypot(end[0] - start[0], end[1] - start[1])
        assert label.box[0] <= end[0] <= label.box[2]
        assert label.box[1] <= end[1] <= label.box[3]


def test_labels_keep_off_balls_while_there_is_another_place() -> None:
    above = np.array([(150.0, 100.0, 250.0, 145.0)])
    (label,) = placed([at(200.0, 150.0)], STAGE, above).found
    assert label.box[1] > 150.0
    everywhere = np.array([STAGE])
    assert placed([at(200.0, 150.0)], STAGE, everywhere).found == placed([at(200.0, 150.0)], STAGE, NO_BALLS).found


def test_what_has_no_room_is_counted() -> None:
    assert placed([at(200.0, 150.0)], STAGE, NO_BALLS, [STAGE]) == Labels((), 1)
    assert placed([Wish("name", 500.0, 15.0, (((200.0, 150.0), 3.0),))], STAGE, NO_BALLS).left_out == 1
    assert placed([at(900.0, 150.0)], STAGE, NO_BALLS).left_out == 1
