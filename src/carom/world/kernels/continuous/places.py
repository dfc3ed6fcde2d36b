"""Places of an island's balls: overlaps are taken back, and small gaps to shapes that press.

Source: M. Müller et al., Position based dynamics, J. Vis. Commun. Image R. 18 (2007) 109-118.
"""

from __future__ import annotations

from carom.constants import ISLAND_PUSH, PAIR_SLACK, PLACE_PASSES, PLACE_ROUNDS, PLACE_SLACK, SETTLE_GAP
from carom.geometry.vector import larger, length, smaller
from carom.rows.island import NO_BODY, BodyRow, IslandContactRow
from carom.rows.tables import Table
from carom.world.kernels.continuous.relaxation import weigh_contacts
from carom.world.kernels.continuous.resolve import aim_pair
from carom.world.kernels.continuous.solver import solve_contacts


def resolve_places(bodies: Table[BodyRow], contacts: Table[IslandContactRow], counts: tuple[int, int]) -> float:
    """The deepest overlap left, in radii of the contact's first ball, after overlaps have been taken back.

    All at once first, by the least sum of mass times squared way, so heavy balls move less; then pair by pair and
    shape by shape, which finishes what is bent or was too far. Shapes come after pairs, in the order of contacts: the
    last of them has the last word. Pairs move no ball farther than `ISLAND_PUSH` of its radius; what is near enough to
    be met so has to be among the contacts, lasting or not. A shape moves a ball as far as it overlaps. A gap up to
    `SETTLE_GAP` radii to a shape that pressed (`force`) is closed. Afterwards gaps and normals are those of the new
    places; the mean ones, which depend on velocities, are to be given anew.
    """
    body_count, count = counts
    for i in range(body_count):
        body = bodies[i]
        body["from_x"] = body["x"]
        body["from_y"] = body["y"]
    shift_all(bodies, contacts, counts)
    deepest = 0.0
    for attempt in range(PLACE_PASSES):
        deepest = part_pairs(bodies, contacts, count)
        settling = attempt + attempt < PLACE_PASSES
        deepest = larger(deepest, part_from_shapes(bodies, contacts, count, settling))
        if deepest <= PLACE_SLACK:
            break
    for q in range(count):
        contact = contacts[q]
        if contact["second"] == NO_BODY:
            aim_at_shape(bodies, contact)
        else:
            aim_pair(bodies, contact)
    return deepest


def shift_all(bodies: Table[BodyRow], contacts: Table[IslandContactRow], counts: tuple[int, int]) -> None:
    """Move all balls at once so that no contact overlaps, surfaces being taken as straight.

    The ways are found as velocities are, with gaps in place of biases, and cut to what the pushes may be.
    """
    body_count, count = counts
    weigh_contacts(bodies, contacts, count, True)
    tolerance, overlaps = 0.0, False
    for q in range(count):
        contact = contacts[q]
        if contact["second"] == NO_BODY:
            contact["nx"] = contact["start_nx"]
            contact["ny"] = contact["start_ny"]
        else:
            aim_pair(bodies, contact)
        contact["bias"] = contact["gap"]
        contact["impulse"] = 0.0
        contact["holds"] = 0
        slack = PAIR_SLACK * float(bodies[contact["first"]]["radius"])
        tolerance = slack if q == 0 else smaller(tolerance, slack)
        overlaps = overlaps or contact["gap"] < -slack
    if not overlaps:
        return
    for i in range(body_count):
        bodies[i]["wx"] = 0.0
        bodies[i]["wy"] = 0.0
    solve_contacts(bodies, contacts, counts, PLACE_ROUNDS, tolerance)
    share = 1.0
    for i in range(body_count):
        body = bodies[i]
        way, most = length(float(body["wx"]), float(body["wy"])), ISLAND_PUSH * float(body["radius"])
        if way > most:
            share = smaller(share, most / way)
    for i in range(body_count):
        body = bodies[i]
        body["x"] += share * float(body["wx"])
        body["y"] += share * float(body["wy"])


def part_pairs(bodies: Table[BodyRow], contacts: Table[IslandContactRow], count: int) -> float:
    """The deepest overlap of two balls, in radii of the first, as each pair was met and parted."""
    deepest = 0.0
    for q in range(count):
        contact = contacts[q]
        if contact["second"] != NO_BODY:
            aim_pair(bodies, contact)
            first, second = bodies[contact["first"]], bodies[contact["second"]]
            depth = -float(contact["gap"]) / float(first["radius"])
            if depth > PAIR_SLACK:
                deepest = larger(deepest, depth)
                impulse = -float(contact["gap"]) * float(contact["effective_mass"])
                way_of_first = impulse * float(first["inverse_mass"])
                way_of_second = impulse * float(second["inverse_mass"])
                # Both by the same share, so that their centre of mass stays.
                share = smaller(allowed_share(first, way_of_first), allowed_share(second, way_of_second))
                shift(first, contact, share * way_of_first)
                shift(second, contact, -share * way_of_second)
    return deepest


def allowed_share(body: BodyRow, way: float) -> float:
    """The share of a way that a pair may move a ball, which is moved already."""
    if way <= 0.0:
        return 1.0
    moved = length(float(body["x"]) - float(body["from_x"]), float(body["y"]) - float(body["from_y"]))
    left = larger(0.0, ISLAND_PUSH * float(body["radius"]) - moved)
    return smaller(1.0, left / way)


def shift(body: BodyRow, contact: IslandContactRow, way: float) -> None:
    """Move a ball along a contact's normal."""
    body["x"] += way * float(contact["nx"])
    body["y"] += way * float(contact["ny"])


def part_from_shapes(bodies: Table[BodyRow], contacts: Table[IslandContactRow], count: int, settling: bool) -> float:
    """The deepest overlap with a shape, in radii, as each was met; the ball is put onto the surface, if not deeper.

    While `settling`, a ball with a small gap to a shape that presses it is put there too.
    """
    deepest = 0.0
    for q in range(count):
        contact = contacts[q]
        if contact["second"] == NO_BODY and contact["effective_mass"] > 0.0:
            body = bodies[contact["first"]]
            gap, nx, ny = gap_after_shift(
                contact, float(body["x"]) - float(body["from_x"]), float(body["y"]) - float(body["from_y"])
            )
            contact["nx"] = nx
            contact["ny"] = ny
            depth = -gap / float(body["radius"])
            deepest = larger(deepest, depth)
            pressed = settling and contact["lasting"] != 0 and contact["force"] > 0.0
            if depth > PLACE_SLACK or (pressed and -SETTLE_GAP <= depth < -PLACE_SLACK):
                shift(body, contact, -gap)
    return deepest


def gap_after_shift(contact: IslandContactRow, dx: float, dy: float) -> tuple[float, float, float]:
    """The gap to a shape and its unit normal `(gap, nx, ny)` when the ball is (dx, dy) from where they were given.

    Exact for a line and a circle. Of a ball in the very centre of curvature the normal stays.
    """
    gap, nx, ny = float(contact["gap"]), float(contact["start_nx"]), float(contact["start_ny"])
    bend = float(contact["bend"])
    if bend == 0.0:
        return gap + (dx * nx + dy * ny), nx, ny
    # From the centre of curvature to the ball.
    cx, cy = dx - bend * nx, dy - bend * ny
    away = length(cx, cy)
    if away == 0.0:
        return gap + bend, nx, ny
    if bend > 0.0:
        return gap + (bend - away), -cx / away, -cy / away
    return gap + (away + bend), cx / away, cy / away


def aim_at_shape(bodies: Table[BodyRow], contact: IslandContactRow) -> None:
    """Give a contact with a shape the gap, the normal and the bend of where its ball has been moved to."""
    body = bodies[contact["first"]]
    gap, nx, ny = gap_after_shift(
        contact, float(body["x"]) - float(body["from_x"]), float(body["y"]) - float(body["from_y"])
    )
    if contact["bend"] != 0.0:
        contact["bend"] += float(contact["gap"]) - gap
    contact["gap"] = gap
    contact["start_nx"] = nx
    contact["start_ny"] = ny
