"""Places of an island: overlaps are taken back, heavy balls move less, shapes have the last word."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from carom.constants import ISLAND_PUSH, PAIR_SLACK, PLACE_SLACK, SETTLE_GAP
from carom.rows.island import NO_BODY
from carom.rows.tables import Rows
from carom.world.kernels.continuous.places import gap_after_shift, resolve_places
from tests.islands import body_rows, contact_rows, counts_of, pyramid, touching


def on_floor(bodies: Rows, contacts: Rows) -> None:
    """Give contacts with a floor at y = 0 their gaps."""
    for contact in contacts:
        if contact["second"] == NO_BODY and contact["ny"] == 1:
            body = bodies[contact["first"]]
            contact["gap"] = body["y"] - body["radius"]


def test_two_balls_part_by_their_masses_and_their_centre_of_mass_stays() -> None:
    bodies = body_rows([(0, 0), (0.97, 0)], [1.0, 3.0])
    contacts = contact_rows([(0, 1, 0.0, 0.0)])
    assert resolve_places(bodies, contacts, (2, 1)) <= 1e-9
    assert bodies["x"] == pytest.approx([-0.0225, 0.9775])
    assert contacts["gap"][0] == pytest.approx(0, abs=1e-9)
    assert (contacts["nx"][0], contacts["ny"][0]) == (-1, 0)


def test_no_ball_is_pushed_farther_by_others_than_a_part_of_its_radius() -> None:
    bodies = body_rows([(0, 0), (0.2, 0)])
    contacts = contact_rows([(0, 1, 0.0, 0.0)])
    assert resolve_places(bodies, contacts, (2, 1)) == pytest.approx(1.4)
    assert bodies["x"] == pytest.approx([-ISLAND_PUSH / 2, 0.2 + ISLAND_PUSH / 2])


def test_balls_with_one_centre_are_parted() -> None:
    bodies = body_rows([(0, 0), (0, 0)])
    contacts = contact_rows([(0, 1, 0.0, 0.0)])
    for _ in range(12):
        resolve_places(bodies, contacts, (2, 1))
    assert bodies["y"][0] - bodies["y"][1] == pytest.approx(1)


@pytest.mark.parametrize("heavy", [1.0, 50.0, 1e3])
def test_a_pressed_pyramid_is_parted_and_stays_on_its_floor(heavy: float) -> None:
    places, links = pyramid(6)
    random = np.random.default_rng(2)
    moved = places + random.uniform(-2e-3, 2e-3, places.shape)
    bodies = body_rows(moved, [1.0] * (len(places) - 1) + [heavy])
    contacts = contact_rows([*touching(places), *(link for link in links if link[1] == NO_BODY and link[3] == 1)])
    on_floor(bodies, contacts)
    assert resolve_places(bodies, contacts, counts_of(bodies, contacts)) <= 1e-7
    assert np.hypot(bodies["x"] - moved[:, 0], bodies["y"] - moved[:, 1]).max() <= 0.05
    lowest = bodies["y"][[link[0] for link in links if link[1] == NO_BODY]]
    assert lowest.min() >= 0.5 - 1e-9


def test_heavy_balls_move_less() -> None:
    places, _ = pyramid(3)
    bodies = body_rows(places * (1 - 1e-3), [1.0] * 5 + [1e3])
    contacts = contact_rows(touching(places))
    resolve_places(bodies, contacts, counts_of(bodies, contacts))
    ways = np.hypot(bodies["x"] - bodies["from_x"], bodies["y"] - bodies["from_y"])
    assert ways[5] < 0.01 * ways[:5].max()


def test_near_shapes_are_heeded_and_the_last_has_the_last_word() -> None:
    # Pushed by the other ball towards a wall that it does not lean on.
    bodies = body_rows([(0, 0), (0.96, 0)])
    contacts = contact_rows([(0, 1, 0.0, 0.0), (1, NO_BODY, -1.0, 0.0)])
    contacts["lasting"][1], contacts["gap"][1] = 0, 0.01
    assert resolve_places(bodies, contacts, (2, 2)) <= 1e-9
    assert bodies["x"] == pytest.approx([-0.03, 0.97])
    # Between a mover and a wall at rest without room, the wall wins.
    for last in (1.0, -1.0):
        bodies = body_rows([(0, 0)])
        contacts = contact_rows([(0, NO_BODY, -last, 0.0), (0, NO_BODY, last, 0.0)])
        contacts["gap"] = -0.02, -0.03
        assert resolve_places(bodies, contacts, (1, 2)) > 0.01
        assert bodies["x"][0] == pytest.approx(0.03 * last)


@given(st.floats(-3, 3), st.floats(0.6, 50), st.floats(-0.05, 0.05), st.floats(-0.05, 0.05), st.booleans())
def test_gaps_to_circles_are_exact_after_a_shift(
    angle: float, radius: float, dx: float, dy: float, inside: bool
) -> None:
    away = radius - 0.51 if inside else radius + 0.49
    x, y = away * np.cos(angle), away * np.sin(angle)
    sign = -1.0 if inside else 1.0
    contact = contact_rows([(0, NO_BODY, sign * np.cos(angle), sign * np.sin(angle))])[0]
    contact["gap"], contact["bend"] = (0.01, away) if inside else (-0.01, -away)
    gap, nx, ny = gap_after_shift(contact, dx, dy)
    far = np.hypot(x + dx, y + dy)
    assert gap == pytest.approx(radius - 0.5 - far if inside else far - radius - 0.5, abs=1e-12)
    assert (nx, ny) == pytest.approx((sign * (x + dx) / far, sign * (y + dy) / far), abs=1e-9)


def test_a_ball_is_put_onto_a_bent_surface_from_both_sides() -> None:
    for gap in (-1e-3, 0.4 * SETTLE_GAP):
        bodies = body_rows([(0.5 + gap, 0), (0.5 + gap, 0.999)])
        contacts = contact_rows([(0, NO_BODY, 1.0, 0.0), (1, 0, 0.0, 1.0)])
        contacts["gap"][0], contacts["bend"][0], contacts["force"][0] = gap, -(2.5 + gap), 1.0
        assert resolve_places(bodies, contacts, (2, 2)) <= 1e-9
        assert np.hypot(bodies["x"][0] + 2.0, bodies["y"][0]) == pytest.approx(2.5, abs=1e-9)
        assert contacts["gap"][0] == pytest.approx(0, abs=1e-9)
        assert contacts["bend"][0] == pytest.approx(-2.5, abs=1e-9)
        normal = contacts["start_nx"][0], contacts["start_ny"][0]
        assert normal == pytest.approx(((bodies["x"][0] + 2) / 2.5, bodies["y"][0] / 2.5))


def test_a_gap_to_what_does_not_press_stays() -> None:
    bodies = body_rows([(0, 0.50001)])
    contacts = contact_rows([(0, NO_BODY, 0.0, 1.0)])
    contacts["gap"] = 1e-5
    assert resolve_places(bodies, contacts, (1, 1)) == 0
    assert bodies["y"][0] == 0.50001


@pytest.mark.parametrize(("share", "stays"), [(0.9, True), (1.1, False)])
def test_two_balls_are_left_to_overlap_by_what_nobody_sees(share: float, stays: bool) -> None:
    apart = 1.0 - share * PAIR_SLACK * 0.5
    bodies = body_rows([(0, 0), (apart, 0)])
    contacts = contact_rows([(0, 1, 0.0, 0.0)])
    resolve_places(bodies, contacts, (2, 1))
    assert (bodies["x"].tolist() == [0, apart]) == stays


def test_a_ball_is_put_out_of_a_shape_however_little_it_is_in_it() -> None:
    bodies = body_rows([(0, 0.5 - 0.1 * PAIR_SLACK)])
    contacts = contact_rows([(0, NO_BODY, 0.0, 1.0)])
    on_floor(bodies, contacts)
    assert resolve_places(bodies, contacts, (1, 1)) <= PLACE_SLACK
    assert bodies["y"][0] == pytest.approx(0.5, abs=PLACE_SLACK)
