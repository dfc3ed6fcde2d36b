"""Pairs of balls whose boxes overlap: by testing all (brute force), by a grid (`grid.py`), and by a quadtree.

All three find the same pairs at the same state; the order depends on the state alone.
"""

from __future__ import annotations

from math import fabs

from carom.rows.ball import BallRow
from carom.rows.index import NO_CHILD, CellRow
from carom.rows.shape import ShapeRow
from carom.rows.state import StateRow
from carom.rows.tables import Pairs, Table
from carom.world.kernels.broad_phase.quadtree import build_tree, locate_node, plant_root


def may_touch(dx: float, dy: float, reach: float) -> bool:
    """True if the boxes of two balls overlap: centres `dx`, `dy` apart, radii `reach` in sum."""
    return fabs(dx) <= reach and fabs(dy) <= reach


def put_pair(state: StateRow, pairs: Pairs, count: int, first: int, second: int) -> int:
    """The number of pairs after one more, or -1 if `pairs` has no room; `state["wanted_pairs"]` says how much."""
    if count >= len(pairs):
        state["wanted_pairs"] = 2 * count + 1
        return -1
    pairs[count, 0] = first
    pairs[count, 1] = second
    return count + 1


def pairs_by_brute_force(state: StateRow, balls: Table[BallRow], pairs: Pairs) -> int:
    """The number of pairs found by comparing every ball with every other, in the order of the rows; -1: no room."""
    count = 0
    total = state["balls"]
    for i in range(total):
        x = balls[i]["x"]
        y = balls[i]["y"]
        radius = balls[i]["radius"]
        for j in range(i + 1, total):
            other = balls[j]
            if may_touch(other["x"] - x, other["y"] - y, radius + other["radius"]):
                count = put_pair(state, pairs, count, i, j)
                if count < 0:
                    return -1
    state["box_tests"] += total * (total - 1) // 2
    return count


def measure_balls(state: StateRow, balls: Table[BallRow]) -> tuple[float, float, float, float, float, float]:
    """The box around the balls' centres, and the smallest and the largest radius: (left, bottom, right, top, r, R)."""
    left = float(balls[0]["x"])
    bottom = float(balls[0]["y"])
    right = left
    top = bottom
    smallest = float(balls[0]["radius"])
    largest = smallest
    for i in range(state["balls"]):
        ball = balls[i]
        x, y, radius = float(ball["x"]), float(ball["y"]), float(ball["radius"])
        left = min(left, x)
        right = max(right, x)
        bottom = min(bottom, y)
        top = max(top, y)
        smallest = min(smallest, radius)
        largest = max(largest, radius)
    return left, bottom, right, top, smallest, largest


def pairs_by_quadtree(
    state: StateRow,
    balls: Table[BallRow],
    cells: Table[CellRow],
    members: Table[int],
    root: int,
    end: int,
    pairs: Pairs,
) -> int:
    """The number of pairs found in the leaves of a quadtree of the balls' boxes, whose nodes are `cells[root:end]`.

    Balls that share several leaves are a pair in the one that holds the lower left corner of what their boxes share.
    """
    count = 0
    for node in range(root, end):
        cell = cells[node]
        if cell["child"] == NO_CHILD:
            state["box_tests"] += (cell["end"] - cell["begin"]) * (cell["end"] - cell["begin"] - 1) // 2
            for k in range(cell["begin"], cell["end"]):
                first = balls[members[k]]
                for m in range(k + 1, cell["end"]):
                    second = balls[members[m]]
                    reach = first["radius"] + second["radius"]
                    if may_touch(second["x"] - first["x"], second["y"] - first["y"], reach):
                        # This corner lies in one leaf only, so the pair counts once.
                        x = max(first["x"] - first["radius"], second["x"] - second["radius"])
                        y = max(first["y"] - first["radius"], second["y"] - second["radius"])
                        if locate_node(cells, root, x, y) == node:
                            count = put_pair(state, pairs, count, members[k], members[m])
                            if count < 0:
                                return -1
    return count


def plant_ball_tree(
    state: StateRow,
    balls: Table[BallRow],
    shapes: Table[ShapeRow],
    cells: Table[CellRow],
    members: Table[int],
    root: int,
    free: int,
) -> int:
    """The row of `cells` after the last node of a quadtree of the balls, from `cells[root]` and `members[free]` on.

    -1 where room ran out; `state["wanted_*"]` says how much.
    """
    total = int(state["balls"])
    if root + 1 > len(cells) or free + total > len(members):
        state["wanted_cells"] = root + 1
        state["wanted_members"] = free + total
        return -1
    left, bottom, right, top, _, _ = measure_balls(state, balls)
    plant_root(cells[root], 0.5 * left + 0.5 * right, 0.5 * bottom + 0.5 * top, free, free + total)
    for i in range(total):
        members[free + i] = i
    return build_tree(state, balls, shapes, True, 0.0, cells, members, root, right - left, top - bottom)
