"""What the film shows of a ball next: its world goes on, in a copy of its tables, until the ball has met something."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from carom import checks
from carom.compiler import door
from carom.geometry.vector import length
from carom.rows.flight import QUEUE
from carom.rows.query import AIM
from carom.rows.state import DISCRETE, DONE, HAS_STRAYS, NEEDS_PAIRS, NEEDS_ROOM
from carom.rows.tables import Row, Rows
from carom.world.kernels.continuous.film import step_continuous
from carom.world.kernels.queries.aiming import write_direction
from carom.world.sizes import step_size
from carom.world.tables import Arrays, clear_kernel_place
from carom.world.views import see_lent

if TYPE_CHECKING:
    from carom.world.world import World

#: Seconds, more than any film that can be waited for.
FAR = 1e300


def next_impacts(world: World, indices: Rows) -> Rows:
    """What balls meet next, by their rows: rows of `AIM`, whose `shape` is 0 for those that meet nothing.

    That includes a ball which has met nothing when so much has happened that the step's kernel comes back for Ctrl-C.
    """
    arrays = world._arrays
    if arrays.states[0]["detection"] == DISCRETE:
        raise checks.refuse("direction", "must be given in the discrete mode", None)
    see_lent(world)
    aims = np.zeros(len(indices), AIM)
    for k, index in enumerate(indices.tolist()):
        ball = arrays.balls.rows[index]
        aims[k]["ball"] = ball["id"]
        aims[k]["start"] = ball["x"], ball["y"]
        film = copy_of(arrays)
        if goes_on(film, index):
            tell(film, index, aims[k])
    return aims


def note_times(aims: Rows, ways: Rows, now: float) -> None:
    """Write when balls that come straight, with the velocities `ways`, meet what they meet.

    Raises `InvalidArgument` where one comes so slowly or leaves so fast that no number says when, or how fast.
    """
    with np.errstate(over="ignore"):
        times = now + aims["distance"] / np.hypot(ways[:, 0], ways[:, 1])
    aims["time"] = np.where(aims["shape"] != 0, times, 0.0)
    lost = ~np.isfinite(aims["time"] + aims["speed"] + aims["other_speed"] + aims["direction"].sum(axis=1))
    if lost.any():
        way = tuple(ways[np.argmax(lost)].tolist())
        raise checks.refuse("direction", "must be of a length that leaves times and speeds finite", way)


def tell(film: Arrays, index: int, aim: Row) -> None:
    """Write what the last hit of a film says of a ball."""
    hit = film.hits[int(film.states[0]["hits"]) - 1]
    balls = film.balls.used
    is_ball = hit["ball"] == aim["ball"]
    other = hit["shape"] if is_ball else hit["ball"]
    aim["shape"], aim["time"], aim["point"] = other, hit["time"], hit["point"]
    aim["normal"] = hit["normal"] if is_ball else -hit["normal"]
    ball = balls[index]
    aim["ghost"] = ball["x"], ball["y"]
    aim["distance"] = length(float(ball["x"] - aim["start"][0]), float(ball["y"] - aim["start"][1]))
    aim["speed"] = write_direction(aim["direction"], float(ball["vx"]), float(ball["vy"]), 0.0)
    for partner in balls[balls["id"] == other]:
        velocity = float(partner["vx"]), float(partner["vy"])
        aim["other_speed"] = write_direction(aim["other_direction"], *velocity, 0.0)


def copy_of(arrays: Arrays) -> Arrays:
    """The tables of a world, to go on with by themselves."""
    film = Arrays()
    film.states = np.array(arrays.states)
    film.fill(arrays.balls.used, arrays.shapes.used)
    film.relations, film.flights = arrays.relations.copy(), arrays.flights.copy()
    film.queue = np.zeros(len(arrays.balls.rows) + 1, QUEUE)
    film.prepare()
    return film


def goes_on(film: Arrays, index: int) -> bool:
    """True when the film has gone on up to the next impact of a ball."""
    state = film.states[0]
    clear_kernel_place(state)
    state["hits"] = state["max_impacts"] = 0
    state["dt"], state["steps_left"], state["watched"] = FAR, 1, index + 1
    kernel = door.enter(step_continuous, step_size)
    status = kernel(film.block())
    while status in (NEEDS_ROOM, NEEDS_PAIRS):
        film.extend(status)
        status = kernel(film.block())
    return bool(status in (DONE, HAS_STRAYS) and state["steps_left"] == 0 and state["now"] < FAR)
