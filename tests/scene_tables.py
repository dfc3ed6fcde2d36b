"""Strategies of hypothesis for scenes as tables, good ones and such as are not."""

from collections.abc import Callable
from typing import Any

from hypothesis import strategies as st

import carom
from tests.strategies import arcs, segments

numbers = st.floats(-1e6, 1e6, allow_nan=False)
positive = st.floats(1e-6, 1e6)
pairs = st.tuples(numbers, numbers)
names = st.one_of(st.none(), st.text(st.characters(codec="utf-8"), max_size=8))
masks = st.integers(0, 2**32 - 1)
colliding = {
    "name": names,
    "elasticity": st.floats(0.0, 2.0),
    "sensor": st.booleans(),
    "can_collide": st.booleans(),
    "layer": masks,
    "collides_with": masks,
}
surface = {**colliding, "kick": st.floats(0.0, 100.0), "once": st.booleans()}
rails = {
    "pivot": st.one_of(st.none(), pairs),
    "angular_velocity": numbers,
    "rotating": st.booleans(),
    "velocity": pairs,
    "orientation": st.floats(-10.0, 10.0),
    "turn_limits": st.one_of(st.none(), st.tuples(st.floats(-99.0, -10.0), st.floats(10.0, 99.0))),
}


def tables(kind: str, options: dict[str, st.SearchStrategy[Any]], **own: st.SearchStrategy[Any]) -> Any:
    """Tables of one kind with any of the options."""
    return st.fixed_dictionaries({"kind": st.just(kind), **own}, optional=options)


@st.composite
def lines(draw: st.DrawFn, kind: str, options: dict[str, st.SearchStrategy[Any]]) -> dict[str, Any]:
    """Segments and gates, whose ends lie apart."""
    ax, ay, bx, by = draw(segments())
    return draw(tables(kind, options)) | {"start": (ax, ay), "end": (bx, by)}


@st.composite
def bows(draw: st.DrawFn, options: dict[str, st.SearchStrategy[Any]]) -> dict[str, Any]:
    """Arcs, whose angles lie apart."""
    x, y, radius, start, end = draw(arcs())
    return draw(tables("arc", options)) | {"center": (x, y), "radius": radius, "start_angle": start, "end_angle": end}


def parts(options: dict[str, st.SearchStrategy[Any]]) -> st.SearchStrategy[dict[str, Any]]:
    """Shapes of every kind but compounds."""
    return st.one_of(
        tables("point", options, position=pairs),
        lines("segment", options),
        lines("gate", options),
        tables("circle", options | {"solid": st.booleans()}, center=pairs, radius=positive),
        bows(options),
    )


def turning(table: dict[str, Any]) -> dict[str, Any]:
    """The table of a shape that may move, kinematic."""
    return table | {"motion": "kinematic"}


compound_rails = {name: strategy for name, strategy in rails.items() if name != "pivot"}
compounds = tables(
    "compound", {"name": names} | compound_rails, pivot=pairs, shapes=st.lists(parts(surface), max_size=3)
)
groups = tables("group", {"name": names}, shapes=st.lists(parts(surface), min_size=1, max_size=3))
shapes = st.one_of(parts(surface), parts(surface | rails).map(turning), compounds, groups)
balls = st.fixed_dictionaries(
    {"position": pairs, "radius": positive},
    optional=colliding | {"mass": positive, "velocity": pairs, "friction": st.one_of(st.none(), st.floats(0.0, 10.0))},
)
worlds = st.fixed_dictionaries(
    {},
    optional={
        "gravity": pairs,
        "substeps": st.integers(1, 100),
        "broad_phase": st.sampled_from(("grid", "quadtree", "brute")),
        "restitution": st.sampled_from(("normal", "total")),
        "friction": st.floats(0.0, 10.0),
        "rest_speed": st.one_of(st.none(), st.floats(0.0, 1.0)),
        "max_speed": st.one_of(st.none(), positive),
        "bounds": st.one_of(st.none(), st.tuples(*[st.floats(-9.0, 0.0)] * 2, *[st.floats(0.0, 9.0)] * 2)),
        "remove_strays": st.booleans(),
    },
)
tables_of_scenes = st.fixed_dictionaries(
    {},
    optional={
        "name": names,
        "guard": st.booleans(),
        "world": worlds,
        "shapes": st.lists(shapes, max_size=4),
        "balls": st.lists(balls, max_size=3),
    },
)


def scene_or_words(make: Callable[..., carom.Scene], *given: Any, **named: Any) -> carom.Scene | str:
    """The scene, or what the `SceneError` says; any other exception is a failure."""
    try:
        return make(*given, **named)
    except carom.SceneError as error:
        return str(error)


nothing_good = st.one_of(
    st.none(),
    st.just(float("nan")),
    st.just(float("-inf")),
    st.just("text"),
    st.just([]),
    st.just({}),
    st.just(-1),
    st.lists(st.integers(), max_size=3),
)


def places(value: Any, path: tuple[Any, ...] = ()) -> list[tuple[Any, ...]]:
    """The paths of all that is in a table, from the table itself down to each number."""
    below = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, (list, tuple)) else ()
    return [path, *(place for step, child in below for place in places(child, (*path, step)))]


def changed(value: Any, path: tuple[Any, ...], new: Any) -> Any:
    """A copy of `value` with `new` at `path`."""
    if not path:
        return new
    if isinstance(value, dict):
        return {key: changed(child, path[1:], new) if key == path[0] else child for key, child in value.items()}
    return [changed(child, path[1:], new) if step == path[0] else child for step, child in enumerate(value)]
