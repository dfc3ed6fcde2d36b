"""The energy of an island: what it has, what its contacts have put in, and how an excess is taken out."""

from __future__ import annotations

from math import sqrt

from carom.rows.island import NO_BODY, BodyRow, IslandContactRow
from carom.rows.tables import Table


def body_energy(body: BodyRow, gravity: tuple[float, float], frame: tuple[float, float]) -> tuple[float, float]:
    """The kinetic energy of a ball in a frame that moves with the velocity `frame`, and its potential energy.

    The potential is 0 at the world's origin, so its rounding is 1e-16 of mass times gravity times the distance from it.
    """
    gx, gy = gravity
    ux, uy = frame
    mass = float(body["mass"])
    vx, vy = float(body["vx"]) - ux, float(body["vy"]) - uy
    return 0.5 * mass * (vx * vx + vy * vy), -mass * (gx * float(body["x"]) + gy * float(body["y"]))


def island_energy(
    bodies: Table[BodyRow], count: int, gravity: tuple[float, float], frame: tuple[float, float]
) -> tuple[float, float]:
    """The kinetic and the potential energy of an island, in a frame that moves with the velocity `frame`."""
    kinetic, potential = 0.0, 0.0
    for i in range(count):
        of_motion, of_place = body_energy(bodies[i], gravity, frame)
        kinetic += of_motion
        potential += of_place
    return kinetic, potential


def take_energy(bodies: Table[BodyRow], count: int, excess: float, frame: tuple[float, float]) -> float:
    """What is left of an excess of energy, a debt, when kinetic energy has paid what it can.

    The velocities relative to `frame` (vx, vy) are scaled by one factor, so directions are kept. An excess of 0 or less
    changes nothing and leaves no debt.
    """
    kinetic, _ = island_energy(bodies, count, (0.0, 0.0), frame)
    if excess <= 0.0:
        return 0.0
    ux, uy = frame
    factor = sqrt(1.0 - excess / kinetic) if excess < kinetic else 0.0
    for i in range(count):
        body = bodies[i]
        body["vx"] = ux + factor * (float(body["vx"]) - ux)
        body["vy"] = uy + factor * (float(body["vy"]) - uy)
    return excess - kinetic if excess > kinetic else 0.0


def contact_work(bodies: Table[BodyRow], contacts: Table[IslandContactRow], count: int) -> float:
    """The work that contacts do over a tick in which balls go from (vx, vy) to (wx, wy), without that of movers.

    The way of a ball is the tick times its mean velocity, which is taken relative to the surface: what a moving shape
    gives or takes is no fault of the solve. Pairs as a whole do no work in any frame but by parting or approaching.
    """
    work = 0.0
    for q in range(count):
        contact = contacts[q]
        impulse = float(contact["impulse"])
        if impulse != 0.0:
            first = bodies[contact["first"]]
            x = float(first["vx"]) + float(first["wx"])
            y = float(first["vy"]) + float(first["wy"])
            bias = float(contact["mean_bias"])
            if contact["second"] != NO_BODY:
                second = bodies[contact["second"]]
                x -= float(second["vx"]) + float(second["wx"])
                y -= float(second["vy"]) + float(second["wy"])
                bias = 0.0
            work += impulse * (0.5 * (x * float(contact["nx"]) + y * float(contact["ny"])) + bias)
    return work


def workless_share(work: float, bodies: Table[BodyRow], count: int, tau: float) -> float:
    """The share (0 to 1) of the contacts' forces that does no work over a tick of `tau` seconds, if all do `work`.

    Without forces a ball's velocity changes by `tau` (gx, gy). With a share s of them the work is
    `s (work + (s - 1) L)`, L being ½ Σ m |change by forces|²: 0 at `1 - work / L`. Work of 0 or less is left as it is.
    """
    change = 0.0
    for i in range(count):
        body = bodies[i]
        x = float(body["wx"]) - float(body["vx"]) - tau * float(body["gx"])
        y = float(body["wy"]) - float(body["vy"]) - tau * float(body["gy"])
        change += 0.5 * float(body["mass"]) * (x * x + y * y)
    if work <= 0.0:
        return 1.0
    return 1.0 - work / change if work < change else 0.0
