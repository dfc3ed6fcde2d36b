"""An impact within an island: how it spreads through the contacts that last."""

from __future__ import annotations

from math import fabs, sqrt

from carom.constants import ELASTIC_VISITS, IMPACT_SHARE, IMPACT_VISITS, REBOUND, SOLVER_ROUNDS, SPEED_ROUNDING
from carom.geometry.vector import larger, smaller
from carom.rows.island import NO_BODY, NO_CONTACT, NOT_QUEUED, BodyRow, IslandContactRow
from carom.rows.tables import Table
from carom.world.kernels.continuous.relaxation import contact_speed, push, weigh_contacts
from carom.world.kernels.continuous.resolve import aim_contacts
from carom.world.kernels.continuous.solver import solve_contacts


def resolve_impact(
    bodies: Table[BodyRow],
    contacts: Table[IslandContactRow],
    counts: tuple[int, int],
    speed: float,
) -> float:
    """The fastest approach left after an impact has spread over (vx, vy).

    Contact by contact, first come, first served: as bodies that touch but are a little apart would. A contact gives
    back its elasticity (1 at most) as long as it rebounds faster than `speed`, and nothing else. What is left after a
    bounded number of visits goes as in `resolve_velocities`. So kinetic energy is not gained in the frame of shapes at
    rest. `reached` is 1 of the balls whose velocity has changed, else 0.
    """
    return end_approaches(bodies, contacts, counts, spread_impact(bodies, contacts, counts, speed))


def end_approaches(
    bodies: Table[BodyRow], contacts: Table[IslandContactRow], counts: tuple[int, int], least: float
) -> float:
    """The fastest approach left, at most `least` where there is a solution, after all others were ended at once."""
    body_count, count = counts
    for q in range(count):
        contacts[q]["impulse"] = 0.0
        contacts[q]["holds"] = 0
    worst = solve_contacts(bodies, contacts, counts, SOLVER_ROUNDS, least)
    take_velocities(bodies, body_count)
    return worst


def spread_impact(
    bodies: Table[BodyRow], contacts: Table[IslandContactRow], counts: tuple[int, int], speed: float
) -> float:
    """The speed of approach below which contacts are left as they are, after an impact has spread in their visits.

    Where these do not suffice, faster approaches remain. `acted` is 1 of contacts that have given an impulse, and
    `reached` of bodies whose velocity has changed, else 0.
    """
    body_count, count = counts
    aim_contacts(bodies, contacts, count)
    weigh_contacts(bodies, contacts, count, False)
    link_contacts(bodies, contacts, counts, speed)
    top = 0.0
    for i in range(body_count):
        body = bodies[i]
        body["wx"] = body["vx"]
        body["wy"] = body["vy"]
        top = larger(top, larger(fabs(float(body["vx"])), fabs(float(body["vy"]))))
    least = larger(IMPACT_SHARE * speed, SPEED_ROUNDING * top)
    spread(bodies, contacts, body_count, least)
    take_velocities(bodies, body_count)
    return least


def take_velocities(bodies: Table[BodyRow], count: int) -> None:
    """Give bodies the velocities that were solved, and note whom that has changed as `reached`."""
    for i in range(count):
        body = bodies[i]
        if body["wx"] != body["vx"] or body["wy"] != body["vy"]:
            body["reached"] = 1
        body["vx"] = body["wx"]
        body["vy"] = body["wy"]


def link_contacts(
    bodies: Table[BodyRow], contacts: Table[IslandContactRow], counts: tuple[int, int], speed: float
) -> None:
    """Make the lists of the lasting contacts of each body, in the order of contacts, and tell which rebounds are slow.

    Slower than `speed`, or so slow that what the contact bears would let it rise by a named part of a radius at most.
    """
    body_count, count = counts
    for i in range(body_count):
        body = bodies[i]
        body["contacts"] = NO_CONTACT
        body["after"] = NOT_QUEUED
        body["visits"] = 0
        body["reached"] = 0
    for q in range(count - 1, -1, -1):
        contact = contacts[q]
        contact["acted"] = 0
        if contact["effective_mass"] > 0.0:
            first = bodies[contact["first"]]
            press = float(contact["force"]) / float(contact["effective_mass"])
            contact["rest_speed"] = larger(speed, sqrt(2.0 * REBOUND * press * float(first["radius"])))
            contact["next_of_first"] = first["contacts"]
            first["contacts"] = q
            if contact["second"] != NO_BODY:
                second = bodies[contact["second"]]
                contact["next_of_second"] = second["contacts"]
                second["contacts"] = q


def spread(bodies: Table[BodyRow], contacts: Table[IslandContactRow], count: int, least: float) -> None:
    """Visit all bodies and whom they push, in turn, until none approaches by more than `least`, or too often."""
    head, last = NO_BODY, NO_BODY
    for i in range(count):
        head, last = enqueue(bodies, head, last, i)
    while head != NO_BODY:
        i = head
        head = int(bodies[i]["after"])
        bodies[i]["after"] = NOT_QUEUED
        bodies[i]["visits"] += 1
        elastic = bodies[i]["visits"] <= ELASTIC_VISITS
        acted = False
        q = int(bodies[i]["contacts"])
        while q != NO_CONTACT:
            contact = contacts[q]
            is_first = contact["first"] == i
            approach = -contact_speed(bodies, contact)
            if approach > least:
                acted = True
                contact["acted"] = 1
                push(bodies, contact, rebound(contact, approach, elastic))
                head, last = enqueue(bodies, head, last, int(contact["second"] if is_first else contact["first"]))
            q = int(contact["next_of_first"] if is_first else contact["next_of_second"])
        if acted:
            # What a later contact has done may have made an earlier one approach again.
            head, last = enqueue(bodies, head, last, i)


def rebound(contact: IslandContactRow, approach: float, elastic: bool) -> float:
    """The impulse that ends an approach and lets the contact rebound, unless it would do so slowly."""
    elasticity = smaller(float(contact["elasticity"]), 1.0)
    if not elastic or elasticity * approach <= contact["rest_speed"]:
        elasticity = 0.0
    return (1.0 + elasticity) * approach * float(contact["effective_mass"])


def enqueue(bodies: Table[BodyRow], head: int, last: int, body: int) -> tuple[int, int]:
    """The head and the last of the queue, with a ball that does not wait there yet and has visits left at its end."""
    if body == NO_BODY or bodies[body]["after"] != NOT_QUEUED or bodies[body]["visits"] >= IMPACT_VISITS:
        return head, last
    bodies[body]["after"] = NO_BODY
    if head == NO_BODY:
        return body, body
    bodies[last]["after"] = body
    return head, body
