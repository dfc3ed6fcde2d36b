"""Contacts of an island one by one: their speeds, their impulses, and sweeps of projected Gauss-Seidel over them.

Source: M. Jean, The non-smooth contact dynamics method, Comput. Methods Appl. Mech. Engrg. 177 (1999) 235-257.
"""

from __future__ import annotations

from math import fabs

from carom.constants import SOLVER_ROUNDING
from carom.geometry.vector import larger, smaller
from carom.rows.island import NO_BODY, BodyRow, IslandContactRow
from carom.rows.tables import Table


def weigh_contacts(bodies: Table[BodyRow], contacts: Table[IslandContactRow], count: int, near: bool) -> None:
    """Store the mass that an impulse of each contact moves, and its mobility; 0 for those that take no part in a solve.

    That are those whose sides cannot be moved, and unless `near`, those that do not last.
    """
    for q in range(count):
        contact = contacts[q]
        mobility = 0.0
        if near or contact["lasting"] != 0:
            mobility = float(bodies[contact["first"]]["inverse_mass"])
            if contact["second"] != NO_BODY:
                mobility += float(bodies[contact["second"]]["inverse_mass"])
        contact["mobility"] = mobility
        contact["effective_mass"] = 1.0 / mobility if mobility > 0.0 else 0.0


def contact_speed(bodies: Table[BodyRow], contact: IslandContactRow) -> float:
    """The speed along the normal with which the sides of a contact part, or, below 0, approach."""
    first = bodies[contact["first"]]
    wx, wy = float(first["wx"]), float(first["wy"])
    if contact["second"] != NO_BODY:
        second = bodies[contact["second"]]
        wx -= float(second["wx"])
        wy -= float(second["wy"])
    return wx * float(contact["nx"]) + wy * float(contact["ny"]) + float(contact["bias"])


def push(bodies: Table[BodyRow], contact: IslandContactRow, impulse: float) -> None:
    """Give the velocities that are being solved an impulse of a contact."""
    first = bodies[contact["first"]]
    px, py = impulse * float(contact["nx"]), impulse * float(contact["ny"])
    inverse_mass = float(first["inverse_mass"])
    first["wx"] += inverse_mass * px
    first["wy"] += inverse_mass * py
    if contact["second"] != NO_BODY:
        second = bodies[contact["second"]]
        inverse_mass = float(second["inverse_mass"])
        second["wx"] -= inverse_mass * px
        second["wy"] -= inverse_mass * py


def relaxed_impulse(contact: IslandContactRow, speed: float) -> float:
    """The impulse with which a contact of this speed meets its own condition, the others being left as they are."""
    impulse = float(contact["impulse"]) - speed * float(contact["effective_mass"])
    return impulse if impulse > 0.0 or contact["holds"] != 0 else 0.0


def relax(bodies: Table[BodyRow], contact: IslandContactRow) -> None:
    """Let a contact meet its own condition."""
    impulse = relaxed_impulse(contact, contact_speed(bodies, contact))
    change = impulse - float(contact["impulse"])
    if change != 0.0:
        contact["impulse"] = impulse
        push(bodies, contact, change)


def sweep(bodies: Table[BodyRow], contacts: Table[IslandContactRow], count: int) -> None:
    """Let all contacts meet their conditions one by one, from the last to the first and back."""
    for q in range(count - 1, -1, -1):
        relax(bodies, contacts[q])
    for q in range(count):
        relax(bodies, contacts[q])


def worst_breach(bodies: Table[BodyRow], contacts: Table[IslandContactRow], count: int) -> tuple[float, float]:
    """The largest speed by which a contact breaks its condition, and what rounding of the impulses makes of it.

    The first is what meeting the condition would change: the speed of approach, or that of parting while it presses, up
    to what its impulse holds back.
    """
    worst, rounding = 0.0, 0.0
    for q in range(count):
        contact = contacts[q]
        if contact["mobility"] > 0.0:
            speed = contact_speed(bodies, contact)
            held = fabs(float(contact["impulse"])) * float(contact["mobility"])
            broken = fabs(speed)
            if speed > 0.0 and contact["holds"] == 0:
                broken = smaller(broken, held)
            worst = larger(worst, broken)
            rounding = larger(rounding, SOLVER_ROUNDING * held)
    return worst, rounding
