"""Velocities and accelerations of an island, such that its contacts do not approach.

Source: J. J. Moreau, Numerical aspects of the sweeping process, Comput. Methods Appl. Mech. Engrg. 177 (1999) 329-349.
"""

from __future__ import annotations

from carom.constants import HOP_ROUNDS, HOP_SPEED, SOLVER_ROUNDS
from carom.geometry.vector import unit
from carom.rows.island import NO_BODY, BodyRow, IslandContactRow
from carom.rows.tables import Table
from carom.world.kernels.continuous.ledger import contact_work, workless_share
from carom.world.kernels.continuous.relaxation import push, weigh_contacts
from carom.world.kernels.continuous.solver import solve_contacts


def resolve_velocities(
    bodies: Table[BodyRow], contacts: Table[IslandContactRow], counts: tuple[int, int], tolerance: float
) -> float:
    """The fastest approach left after impulses of the lasting contacts have taken approaches from (vx, vy).

    Of all velocities that do not approach, those nearest in kinetic energy: what a set of inelastic impacts at once
    leaves. The impulses begin at 0, so no kinetic energy is gained in the frame of shapes at rest, converged or not.
    """
    _, count = counts
    aim_contacts(bodies, contacts, count)
    weigh_contacts(bodies, contacts, count, False)
    for q in range(count):
        contacts[q]["holds"] = 0
    return project_velocities(bodies, contacts, counts, tolerance)


def project_velocities(
    bodies: Table[BodyRow], contacts: Table[IslandContactRow], counts: tuple[int, int], tolerance: float
) -> float:
    """The largest breach left after impulses, from 0, of contacts that are aimed and weighed have changed (vx, vy)."""
    body_count, count = counts
    for q in range(count):
        contacts[q]["impulse"] = 0.0
    for i in range(body_count):
        body = bodies[i]
        body["wx"] = body["vx"]
        body["wy"] = body["vy"]
    worst = solve_contacts(bodies, contacts, counts, SOLVER_ROUNDS, tolerance)
    for i in range(body_count):
        body = bodies[i]
        body["vx"] = body["wx"]
        body["vy"] = body["wy"]
    return worst


def aim_contacts(bodies: Table[BodyRow], contacts: Table[IslandContactRow], count: int) -> None:
    """Give contacts their normals and biases for velocities where the balls are, and pairs their gaps."""
    for q in range(count):
        contact = contacts[q]
        if contact["second"] == NO_BODY:
            contact["nx"] = contact["start_nx"]
            contact["ny"] = contact["start_ny"]
            contact["bias"] = contact["start_bias"]
        else:
            aim_pair(bodies, contact)


def aim_pair(bodies: Table[BodyRow], contact: IslandContactRow) -> None:
    """Give two balls the normal and the gap of where they are; those with one centre part along y."""
    first, second = bodies[contact["first"]], bodies[contact["second"]]
    dx, dy = float(first["x"]) - float(second["x"]), float(first["y"]) - float(second["y"])
    nx, ny = 0.0, 1.0
    direction = unit(dx, dy)
    if direction is not None:
        nx, ny = direction
    contact["nx"] = nx
    contact["ny"] = ny
    contact["bias"] = 0.0
    contact["gap"] = (dx * nx + dy * ny) - (float(first["radius"]) + float(second["radius"]))


def resolve_accelerations(
    bodies: Table[BodyRow],
    contacts: Table[IslandContactRow],
    counts: tuple[int, int],
    tau: float,
    tolerance: float,
) -> float:
    """The largest breach left (length/s) after the accelerations (ax, ay) for a tick of `tau` seconds are solved.

    What pulls the balls (gx, gy) and forces of the lasting contacts, such that their mean velocity over the tick does
    not approach by more than their gaps. The forces begin with those that contacts have (`force`).
    A contact that parts but would be brought back within the tick is stopped, which changes (vx, vy). Forces that do
    work are scaled down.
    """
    body_count, count = counts
    weigh_contacts(bodies, contacts, count, False)
    worst = 0.0
    for attempt in range(HOP_ROUNDS + 1):
        if attempt > 0 and not stop_hops(bodies, contacts, counts, tolerance):
            break
        aim_means(bodies, contacts, count, tau)
        for i in range(body_count):
            body = bodies[i]
            body["wx"] = float(body["vx"]) + tau * float(body["gx"])
            body["wy"] = float(body["vy"]) + tau * float(body["gy"])
        load_contacts(bodies, contacts, count, tau, True)
        worst = solve_contacts(bodies, contacts, counts, SOLVER_ROUNDS, tolerance)
        keep_forces(contacts, count, tau)
    share = workless_share(contact_work(bodies, contacts, count), bodies, body_count, tau)
    for i in range(body_count):
        body = bodies[i]
        gx, gy = float(body["gx"]), float(body["gy"])
        body["ax"] = gx + share * ((float(body["wx"]) - float(body["vx"])) / tau - gx)
        body["ay"] = gy + share * ((float(body["wy"]) - float(body["vy"])) / tau - gy)
    for q in range(count):
        contacts[q]["force"] *= share
    aim_forces(contacts, count)
    return worst


def adjust_accelerations(
    bodies: Table[BodyRow], contacts: Table[IslandContactRow], counts: tuple[int, int], tau: float, tolerance: float
) -> float:
    """The largest breach left after (ax, ay), which hold the contacts' `force` already, are solved for `tau` seconds.

    For a part of an island within a tick, of which `tau` remains: what else acts on its balls goes on.
    """
    body_count, count = counts
    weigh_contacts(bodies, contacts, count, False)
    aim_means(bodies, contacts, count, tau)
    turn_forces(bodies, contacts, count)
    for i in range(body_count):
        body = bodies[i]
        body["wx"] = float(body["vx"]) + tau * float(body["ax"])
        body["wy"] = float(body["vy"]) + tau * float(body["ay"])
    load_contacts(bodies, contacts, count, tau, False)
    worst = solve_contacts(bodies, contacts, counts, SOLVER_ROUNDS, tolerance)
    keep_forces(contacts, count, tau)
    for i in range(body_count):
        body = bodies[i]
        vx, vy, wx, wy = float(body["vx"]), float(body["vy"]), float(body["wx"]), float(body["wy"])
        # Whom no contact has changed goes on to the bit.
        if wx != vx + tau * float(body["ax"]) or wy != vy + tau * float(body["ay"]):
            body["ax"] = (wx - vx) / tau
            body["ay"] = (wy - vy) / tau
    aim_forces(contacts, count)
    return worst


def aim_means(bodies: Table[BodyRow], contacts: Table[IslandContactRow], count: int, tau: float) -> None:
    """Give contacts the normals and biases with which the mean velocity over `tau` seconds closes no gap too far.

    As (v + w)/2 is the mean, `(v + w)·n + 2 bias + 2 gap / tau` is not to be below 0. An overlap counts as no gap:
    places are put right, not pushed apart by forces.
    """
    for q in range(count):
        contact = contacts[q]
        contact["holds"] = 0
        first = bodies[contact["first"]]
        vx, vy = float(first["vx"]), float(first["vy"])
        bias = 0.0
        if contact["second"] == NO_BODY:
            contact["nx"] = contact["mean_nx"]
            contact["ny"] = contact["mean_ny"]
            bias = 2.0 * float(contact["mean_bias"])
        else:
            second = bodies[contact["second"]]
            vx -= float(second["vx"])
            vy -= float(second["vy"])
            aim_pair(bodies, contact)
        gap = float(contact["gap"])
        if gap > 0.0:
            bias += 2.0 * gap / tau
        contact["bias"] = vx * float(contact["nx"]) + vy * float(contact["ny"]) + bias


def turn_forces(bodies: Table[BodyRow], contacts: Table[IslandContactRow], count: int) -> None:
    """Let accelerations contain the contacts' forces along the normals that they have now.

    What is left of an old direction on one side would be lost when the other one leaves, and momentum with it.
    """
    for q in range(count):
        contact = contacts[q]
        force = float(contact["force"])
        dx = force * float(contact["nx"]) - float(contact["force_x"])
        dy = force * float(contact["ny"]) - float(contact["force_y"])
        first = bodies[contact["first"]]
        first["ax"] += float(first["inverse_mass"]) * dx
        first["ay"] += float(first["inverse_mass"]) * dy
        if contact["second"] != NO_BODY:
            second = bodies[contact["second"]]
            second["ax"] -= float(second["inverse_mass"]) * dx
            second["ay"] -= float(second["inverse_mass"]) * dy


def aim_forces(contacts: Table[IslandContactRow], count: int) -> None:
    """Keep the forces as vectors: later their normals are others."""
    for q in range(count):
        contact = contacts[q]
        contact["force_x"] = float(contact["force"]) * float(contact["nx"])
        contact["force_y"] = float(contact["force"]) * float(contact["ny"])


def load_contacts(
    bodies: Table[BodyRow], contacts: Table[IslandContactRow], count: int, tau: float, apply: bool
) -> None:
    """Begin impulses with what the kept forces do in `tau` seconds, and give (wx, wy) these where told to."""
    for q in range(count):
        contact = contacts[q]
        impulse = float(contact["force"]) * tau if contact["effective_mass"] > 0.0 else 0.0
        contact["impulse"] = impulse
        if apply and impulse != 0.0:
            push(bodies, contact, impulse)


def keep_forces(contacts: Table[IslandContactRow], count: int, tau: float) -> None:
    """Keep the forces of the contacts for the next solve."""
    for q in range(count):
        contacts[q]["force"] = float(contacts[q]["impulse"]) / tau


def stop_hops(
    bodies: Table[BodyRow], contacts: Table[IslandContactRow], counts: tuple[int, int], tolerance: float
) -> bool:
    """True if contacts that press over the tick, though they part at its start, have been stopped.

    Nothing is changed if there are none.
    """
    _, count = counts
    found = False
    for q in range(count):
        contact = contacts[q]
        hops = contact["impulse"] > 0.0 and parting_speed(bodies, contact) > HOP_SPEED * tolerance
        contact["holds"] = 1 if hops else 0
        found = found or hops
    if found:
        aim_contacts(bodies, contacts, count)
        project_velocities(bodies, contacts, counts, tolerance)
    return found


def parting_speed(bodies: Table[BodyRow], contact: IslandContactRow) -> float:
    """The speed along the normal with which the sides of a contact part at the start of the tick."""
    first = bodies[contact["first"]]
    vx, vy = float(first["vx"]), float(first["vy"])
    if contact["second"] == NO_BODY:
        return vx * float(contact["start_nx"]) + vy * float(contact["start_ny"]) + float(contact["start_bias"])
    second = bodies[contact["second"]]
    vx -= float(second["vx"])
    vy -= float(second["vy"])
    return vx * float(contact["nx"]) + vy * float(contact["ny"])
