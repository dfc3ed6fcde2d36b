"""Islands for tests of their kernels: rows from plain numbers, energies and momenta, and a slow twin of the solver."""

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from carom.rows.island import BODY, ISLAND_CONTACT, NO_BODY
from carom.rows.tables import Rows
from carom.world.kernels.continuous.relaxation import weigh_contacts

Floats = NDArray[np.float64]
#: First body, second, normal; or first body, NO_BODY, normal from the shape.
Link = tuple[int, int, float, float]
Counts = tuple[int, int]


def body_rows(places: Any, masses: Any = 1.0, radius: Any = 0.5, velocities: Any = (0.0, 0.0)) -> Rows:
    """The balls of an island."""
    places = np.asarray(places, np.float64).reshape(-1, 2)
    rows = np.zeros(len(places), BODY)
    rows["x"], rows["y"] = places.T
    rows["radius"], rows["mass"] = radius, masses
    rows["inverse_mass"] = 1 / rows["mass"]
    rows["vx"], rows["vy"] = np.broadcast_to(np.asarray(velocities, np.float64), places.shape).T
    return rows


def contact_rows(links: Sequence[Link], elasticity: float = 0.0) -> Rows:
    """Lasting contacts with the normals of these links, both for the tick's start and for its mean."""
    rows = np.zeros(len(links), ISLAND_CONTACT)
    for row, (first, second, nx, ny) in zip(rows, links, strict=True):
        row["first"], row["second"] = first, second
        for name in ("", "start_", "mean_"):
            row[f"{name}nx"], row[f"{name}ny"] = nx, ny
    rows["lasting"], rows["elasticity"] = 1, elasticity
    return rows


def counts_of(bodies: Rows, contacts: Rows) -> Counts:
    """How many rows the kernels are told of."""
    return len(bodies), len(contacts)


def touching(places: Any, radius: float = 0.5) -> list[Link]:
    """Links of all balls that touch."""
    places = np.asarray(places, np.float64)
    return [
        (i, j, *((places[i] - places[j]) / (2 * radius)))
        for j in range(len(places))
        for i in range(j + 1, len(places))
        if np.hypot(*(places[i] - places[j])) < 2 * radius * (1 + 1e-9)
    ]


def stack(count: int) -> tuple[Floats, list[Link]]:
    """Balls of radius ½ one on the other, on a floor at y = 0."""
    places = np.array([(0.0, 0.5 + i) for i in range(count)])
    return places, [(0, NO_BODY, 0.0, 1.0), *touching(places)]


def pyramid(rows: int) -> tuple[Floats, list[Link]]:
    """Balls of radius ½ in a triangle, on a floor at y = 0 and between two walls."""
    height = np.sqrt(0.75)
    places = np.array([(c + r / 2, 0.5 + r * height) for r in range(rows) for c in range(rows - r)])
    floor = [(c, NO_BODY, 0.0, 1.0) for c in range(rows)]
    return places, [*touching(places), *floor, (0, NO_BODY, 1.0, 0.0), (rows - 1, NO_BODY, -1.0, 0.0)]


def free(bodies: Rows, contacts: Rows) -> None:
    """Let a solve begin with the balls' velocities and impulses of 0."""
    bodies["wx"], bodies["wy"] = bodies["vx"], bodies["vy"]
    contacts["impulse"] = 0
    weigh_contacts(bodies, contacts, len(contacts), False)


def kinetic_energy(bodies: Rows, x: str = "vx", y: str = "vy") -> float:
    """The kinetic energy of an island."""
    return float((bodies["mass"] * (bodies[x] ** 2 + bodies[y] ** 2)).sum() / 2)


def momentum(bodies: Rows) -> Floats:
    """The momentum of an island."""
    return np.array([(bodies["mass"] * bodies[name]).sum() for name in ("vx", "vy")])


def jacobian(bodies: Rows, contacts: Rows) -> Floats:
    """The matrix that makes speeds of contacts from the bodies' velocities, x and y of each in turn."""
    matrix = np.zeros((len(contacts), 2 * len(bodies)))
    for row, contact in zip(matrix, contacts, strict=True):
        normal = contact["nx"], contact["ny"]
        row[2 * contact["first"] : 2 * contact["first"] + 2] = normal
        if contact["second"] != NO_BODY:
            row[2 * contact["second"] : 2 * contact["second"] + 2] -= normal
    return matrix


def solved_slowly(bodies: Rows, contacts: Rows) -> Floats:
    """The velocities that a solve of (vx, vy) is to give: least distance programming with dense matrices.

    C. L. Lawson, R. J. Hanson, Solving least squares problems, chapter 23.
    """
    matrix = jacobian(bodies, contacts)
    roots = np.sqrt(np.repeat(bodies["inverse_mass"], 2))
    velocities = np.stack([bodies["vx"], bodies["vy"]], axis=1).ravel()
    scaled = matrix * roots
    size = np.sqrt((scaled**2).sum(axis=1))
    heights = -(matrix @ velocities + contacts["bias"]) / size
    most = max(np.abs(heights).max(), 1e-300)
    columns = np.vstack([(scaled / size[:, None]).T, heights / most])
    residual = columns @ nonnegative_least_squares(columns) - np.eye(len(columns))[-1]
    return np.asarray(velocities - roots * residual[:-1] / residual[-1] * most).reshape(-1, 2)


def nonnegative_least_squares(columns: Floats) -> Floats:
    """The weights, none below 0, with which these columns come nearest to the last unit vector."""
    target = np.eye(len(columns))[-1]
    weights, active = np.zeros(columns.shape[1]), np.zeros(columns.shape[1], bool)
    for _ in range(20 * len(weights)):
        slope = columns.T @ (target - columns @ weights)
        slope[active] = 0
        if slope.max() <= 1e-14:
            break
        active[slope.argmax()] = True
        while True:
            trial = np.zeros(len(weights))
            trial[active] = np.linalg.lstsq(columns[:, active], target, rcond=None)[0]
            lost = active & (trial <= 0)
            if not lost.any():
                weights = trial
                break
            weights += (weights[lost] / (weights[lost] - trial[lost])).min() * (trial - weights)
            active &= weights > 1e-15
            weights[~active] = 0
    return weights
