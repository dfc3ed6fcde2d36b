"""Impulses of the contacts of an island, such that nothing approaches: the dual of a projection, minimised.

With J the contacts' normals, W the inverse masses, v the velocities and b the biases, the impulses λ ≥ 0 that minimise
`D = ½ λ·JWJᵀλ + λ·(Jv + b)` leave no contact with a speed below 0, and press none whose speed is above 0. Sweeps of
projected Gauss-Seidel find which contacts are loaded, conjugate gradients on these the impulses of long chains and
large mass ratios, in turn.

Every move lowers D, which is 0 at λ = 0. As the kinetic energy changes by `D - λ·b`, a solve that begins with impulses
of 0 does not raise it, wherever it is cut off, while the shapes are at rest; with given impulses that does not hold.

Sources: J. J. Moré, G. Toraldo, On the solution of large quadratic programming problems with bound constraints, SIAM
J. Optim. 1 (1991) 93-113; Z. Dostál, Optimal quadratic programming algorithms, Springer 2009, chapter 5; for the
preconditioner (symmetric Gauss-Seidel) Y. Saad, Iterative methods for sparse linear systems, 2nd ed., section 10.2.
"""

from __future__ import annotations

from math import fabs, inf

from carom.constants import LEAST_CURVATURE, SEARCH_PROPORTION, SEARCH_SHARE, SEARCH_STEPS, SOLVER_SWEEPS
from carom.geometry.vector import larger, smaller
from carom.rows.island import NO_BODY, BodyRow, IslandContactRow
from carom.rows.tables import Table
from carom.world.kernels.continuous.relaxation import contact_speed, push, sweep, worst_breach


def solve_contacts(
    bodies: Table[BodyRow], contacts: Table[IslandContactRow], counts: tuple[int, int], rounds: int, tolerance: float
) -> float:
    """The largest speed by which a contact still breaks its condition after the velocities (wx, wy) are solved.

    `counts` are those of bodies and contacts in use, in an order that is the caller's: where no solution exists (two
    shapes that close on a ball) the last has the last word. They are weighed and have their normals and biases;
    `impulse` (mass·length/s) is what (wx, wy) contain already, mostly 0. A contact breaks its condition by its speed of
    approach, or by the speed with which it parts although it presses (`holds`: by its speed). The work ends when none
    does by more than `tolerance` (length/s) or the rounding of velocities, or after so many `rounds`, each of at most
    `SEARCH_STEPS` steps.
    """
    _, count = counts
    worst, least = worst_breach(bodies, contacts, count)
    if worst > tolerance:
        set_free(bodies, contacts, counts)
    for _ in range(rounds):
        if worst <= larger(tolerance, least):
            return worst
        for _ in range(SOLVER_SWEEPS):
            sweep(bodies, contacts, count)
        search_loaded(bodies, contacts, counts, SEARCH_SHARE * tolerance)
        push_anew(bodies, contacts, counts)
        worst, least = worst_breach(bodies, contacts, count)
    if worst > larger(tolerance, least):
        sweep(bodies, contacts, count)
        worst, _ = worst_breach(bodies, contacts, count)
    return worst


def set_free(bodies: Table[BodyRow], contacts: Table[IslandContactRow], counts: tuple[int, int]) -> None:
    """Store the velocities without the impulses."""
    body_count, count = counts
    for q in range(count):
        if contacts[q]["impulse"] != 0.0:
            push(bodies, contacts[q], -float(contacts[q]["impulse"]))
    for i in range(body_count):
        body = bodies[i]
        body["free_x"] = body["wx"]
        body["free_y"] = body["wy"]
    push_anew(bodies, contacts, counts)


def push_anew(bodies: Table[BodyRow], contacts: Table[IslandContactRow], counts: tuple[int, int]) -> None:
    """Make the velocities anew from the impulses: a search may have gone far, and back, along what moves nothing."""
    body_count, count = counts
    for i in range(body_count):
        body = bodies[i]
        body["wx"] = body["free_x"]
        body["wy"] = body["free_y"]
    for q in range(count):
        if contacts[q]["impulse"] != 0.0:
            push(bodies, contacts[q], float(contacts[q]["impulse"]))


def search_loaded(
    bodies: Table[BodyRow], contacts: Table[IslandContactRow], counts: tuple[int, int], tolerance: float
) -> None:
    """Lower D by conjugate gradients on the loaded contacts, begun anew whenever some of them lose their load.

    Ends when no loaded contact has a speed above `tolerance`, or above a share of the worst approach of the others.
    """
    _, count = counts
    steps = mark_loaded(contacts, count)
    steps += steps // 2
    if steps > SEARCH_STEPS:
        steps = SEARCH_STEPS
    size, share = descend(bodies, contacts, counts, tolerance), 0.0
    for _ in range(steps):
        # Squares of velocities may overflow: sweeps, which have none, remain.
        if not 0.0 < size < inf:
            return
        bend, scale, limit = turn(bodies, contacts, counts, share)
        # A direction that moves nothing: contacts that cannot all press go out of load along it. Where none does,
        # nothing can meet their conditions.
        step = size / bend if bend > LEAST_CURVATURE * scale else inf
        if step == inf and limit == inf:
            return
        if step < limit or step == inf or not go_beyond(bodies, contacts, counts, step):
            go_along(bodies, contacts, counts, smaller(step, limit))
        if step >= limit:
            mark_loaded(contacts, count)
        former = size
        size = descend(bodies, contacts, counts, tolerance)
        share = size / former if step < limit else 0.0


def mark_loaded(contacts: Table[IslandContactRow], count: int) -> int:
    """The number of contacts that press or may pull, these being marked: a search changes their impulses alone."""
    found = 0
    for q in range(count):
        contact = contacts[q]
        can_act = contact["effective_mass"] > 0.0
        contact["loaded"] = 1 if can_act and (contact["impulse"] > 0.0 or contact["holds"] != 0) else 0
        contact["search"] = 0.0
        found += int(contact["loaded"])
    return found


def push_image(bodies: Table[BodyRow], contact: IslandContactRow, impulse: float) -> None:
    """Give the image (zx, zy) of the direction of descent an impulse of a contact."""
    first = bodies[contact["first"]]
    px, py = impulse * float(contact["nx"]), impulse * float(contact["ny"])
    inverse_mass = float(first["inverse_mass"])
    first["zx"] += inverse_mass * px
    first["zy"] += inverse_mass * py
    if contact["second"] != NO_BODY:
        second = bodies[contact["second"]]
        inverse_mass = float(second["inverse_mass"])
        second["zx"] -= inverse_mass * px
        second["zy"] -= inverse_mass * py


def image_speed(bodies: Table[BodyRow], contact: IslandContactRow) -> float:
    """The speed of a contact in the image (zx, zy) of the direction of descent."""
    first = bodies[contact["first"]]
    zx, zy = float(first["zx"]), float(first["zy"])
    if contact["second"] != NO_BODY:
        second = bodies[contact["second"]]
        zx -= float(second["zx"])
        zy -= float(second["zy"])
    return zx * float(contact["nx"]) + zy * float(contact["ny"])


def descend(
    bodies: Table[BodyRow], contacts: Table[IslandContactRow], counts: tuple[int, int], tolerance: float
) -> float:
    """The slope of D along the direction of steepest descent, which is stored with its image in the velocities.

    The direction is what a sweep to and fro over the loaded contacts would give if nothing held their impulses. The
    slope is returned with its sign changed, and as 0 when no loaded contact has a speed above `tolerance`, or above
    `SEARCH_PROPORTION` of the worst approach of a contact without load.
    """
    body_count, count = counts
    for i in range(body_count):
        bodies[i]["zx"] = 0.0
        bodies[i]["zy"] = 0.0
    worst, slope, outside = 0.0, 0.0, 0.0
    for q in range(count):
        contact = contacts[q]
        if contact["loaded"] != 0:
            residual = -contact_speed(bodies, contact)
            worst = larger(worst, fabs(residual))
            descent = (residual - image_speed(bodies, contact)) * float(contact["effective_mass"])
            push_image(bodies, contact, descent)
            contact["residual"] = residual
            contact["descent"] = descent
        elif contact["effective_mass"] > 0.0:
            outside = larger(outside, -contact_speed(bodies, contact))
    for q in range(count - 1, -1, -1):
        contact = contacts[q]
        if contact["loaded"] != 0:
            residual = float(contact["residual"])
            more = (residual - image_speed(bodies, contact)) * float(contact["effective_mass"])
            push_image(bodies, contact, more)
            contact["descent"] += more
            slope += residual * float(contact["descent"])
    return slope if worst > larger(tolerance, SEARCH_PROPORTION * outside) else 0.0


def turn(
    bodies: Table[BodyRow], contacts: Table[IslandContactRow], counts: tuple[int, int], share: float
) -> tuple[float, float, float]:
    """Turn the search into the direction of descent, with a share of what it was: 0 begins it anew.

    Returns how D bends along it, how the contacts would if each were alone, and the step's limit, at which the first of
    the loaded contacts loses its load; it is infinite if none does.
    """
    body_count, count = counts
    bend, scale, limit = 0.0, 0.0, inf
    # A sum of squares of velocities: where the direction moves nothing it is 0 to 1e-32 of the scale, not to 1e-16.
    for i in range(body_count):
        body = bodies[i]
        sx, sy = float(body["zx"]), float(body["zy"])
        if share != 0.0:  # what was may not even be a number
            sx += share * float(body["sx"])
            sy += share * float(body["sy"])
        body["sx"] = sx
        body["sy"] = sy
        bend += float(body["mass"]) * (sx * sx + sy * sy)
    for q in range(count):
        contact = contacts[q]
        if contact["loaded"] != 0:
            along = float(contact["descent"]) + share * float(contact["search"])
            contact["search"] = along
            scale += along * along * float(contact["mobility"])
            if along < 0.0 and contact["holds"] == 0:
                limit = smaller(limit, -float(contact["impulse"]) / along)
    return bend, scale, limit


def go_along(bodies: Table[BodyRow], contacts: Table[IslandContactRow], counts: tuple[int, int], step: float) -> None:
    """Change velocities and impulses by a step along the search direction that is within its limit."""
    body_count, count = counts
    for i in range(body_count):
        body = bodies[i]
        body["wx"] += step * float(body["sx"])
        body["wy"] += step * float(body["sy"])
    for q in range(count):
        contact = contacts[q]
        along = float(contact["search"])
        if contact["loaded"] != 0 and along != 0.0:
            impulse = float(contact["impulse"]) + step * along
            # The one that sets the limit loses its load wholly, where rounding might leave a trace.
            if contact["holds"] == 0 and (impulse < 0.0 or -float(contact["impulse"]) / along == step):
                impulse = 0.0
            contact["impulse"] = impulse


def go_beyond(bodies: Table[BodyRow], contacts: Table[IslandContactRow], counts: tuple[int, int], step: float) -> bool:
    """True if D has been lowered by a step beyond its limit, in which all contacts that would pull lose their load.

    Otherwise impulses are what they were. Source: J. J. Moré and G. Toraldo, as above: the projected search.
    """
    _, count = counts
    for q in range(count):
        contact = contacts[q]
        if contact["loaded"] != 0:
            former = float(contact["impulse"])
            impulse = former + step * float(contact["search"])
            if impulse < 0.0 and contact["holds"] == 0:
                impulse = 0.0
            contact["descent"] = former  # for the way back: the direction itself has been used
            contact["impulse"] = impulse
            push(bodies, contact, impulse - former)
    # D is quadratic, so it changes by the mean of the slopes before and after.
    twice = 0.0
    for q in range(count):
        contact = contacts[q]
        if contact["loaded"] != 0:
            change = float(contact["impulse"]) - float(contact["descent"])
            twice += change * (contact_speed(bodies, contact) - float(contact["residual"]))
    if -inf < twice < 0.0:
        return True
    for q in range(count):
        if contacts[q]["loaded"] != 0:
            contacts[q]["impulse"] = contacts[q]["descent"]
    push_anew(bodies, contacts, counts)
    return False
