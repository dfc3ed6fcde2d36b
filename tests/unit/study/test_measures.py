"""The measures that sweeps can name: each says of a run what its world and hits say."""

import numpy as np
import pytest

import carom
from carom.study import measures
from carom.study.sweeps.grid import Run
from carom.study.sweeps.job import checked


@pytest.fixture(scope="module")
def run() -> tuple[carom.World, carom.Hits]:
    """A ball that bounces between floor and ceiling through a sensor, and another that meets it."""
    world = carom.World(gravity=(0, -2), substeps=8)
    world.add(carom.Segment((-9, 0), (9, 0), name="floor"), carom.Segment((-9, 3), (9, 3), name="ceiling"))
    world.add(carom.Circle((0, 2), 0.1, sensor=True, name="light"), carom.Point((50, 50)))
    world.add(carom.Ball((0, 1), radius=0.25, velocity=(0, 4)), carom.Ball((1, 1), radius=0.25, velocity=(-1, 0)))
    return world, world.run(4)


def test_hits_by_shape_counts_bounces_and_entries_by_name(run: tuple[carom.World, carom.Hits]) -> None:
    world, hits = run
    found = measures.hits_by_shape(world, hits, {})
    told = [hit for hit in hits if hit.kind != carom.HitKind.EXIT]
    assert found["floor"] == sum(hit.shape is world.shapes[0] for hit in told) > 0
    assert found["ceiling"] == sum(hit.shape is world.shapes[1] for hit in told) > 0
    assert found["light"] == sum(hit.shape is world.shapes[2] for hit in told) > 0
    assert found["point at (50, 50)"] == 0
    assert found["ball against ball"] == sum(isinstance(hit.shape, carom.Ball) for hit in told) > 0
    assert sum(found.values()) == len(told)


def test_hits_by_kind_counts_all_hits(run: tuple[carom.World, carom.Hits]) -> None:
    world, hits = run
    found = measures.hits_by_kind(world, hits, {})
    assert found == {f"{kind.name.lower()}s": sum(hit.kind == kind for hit in hits) for kind in carom.HitKind}
    assert min(found.values()) > 0


def test_impact_speeds_are_those_of_bounces(run: tuple[carom.World, carom.Hits]) -> None:
    world, hits = run
    found = measures.impact_speeds(world, hits, {})
    speeds = [hit.speed for hit in hits if hit.kind == carom.HitKind.BOUNCE]
    assert found["bounces"] == len(speeds)
    assert found["mean speed"] == pytest.approx(sum(speeds) / len(speeds), rel=1e-14)
    assert found["greatest speed"] == max(speeds)
    assert measures.impact_speeds(world, hits[:0], {})["mean speed"] == 0.0


def test_energy_is_that_of_the_balls(run: tuple[carom.World, carom.Hits]) -> None:
    world, hits = run
    kinetic = sum(0.5 * ball.mass * (ball.velocity[0] ** 2 + ball.velocity[1] ** 2) for ball in world.balls)
    height = sum(2.0 * ball.mass * ball.position[1] for ball in world.balls)
    found = measures.energy(world, hits, {})
    assert found == pytest.approx({"kinetic energy": kinetic, "energy": kinetic + height}, rel=1e-14)


def test_last_state_is_where_balls_are(run: tuple[carom.World, carom.Hits]) -> None:
    world, hits = run
    found = measures.last_state(world, hits, {})
    assert found["balls"] == 2
    assert found["time"] == world.time
    assert list(zip(found["x"], found["y"], strict=True)) == [ball.position for ball in world.balls]
    assert list(zip(found["vx"], found["vy"], strict=True)) == [ball.velocity for ball in world.balls]
    world.balls.position[0] += 1.0
    assert not np.array_equal(found["x"], world.balls.position[:, 0])


def test_statistics_are_the_world_s(run: tuple[carom.World, carom.Hits]) -> None:
    assert measures.statistics(*run, {}) == run[0].statistics.as_dict()


@pytest.mark.parametrize("name", measures.__all__)
def test_each_is_found_by_its_name_and_gives_what_a_table_can_hold(
    name: str, run: tuple[carom.World, carom.Hits]
) -> None:
    assert measures.by_name(name.replace("_", "-")) == measures.by_name(name) == f"carom.study.measures:{name}"
    assert checked(getattr(measures, name)(*run, {}), Run({}, None)).startswith("{")


def test_a_name_of_none_is_refused() -> None:
    with pytest.raises(carom.InvalidArgument, match="did you mean hits-by-shape"):
        measures.by_name("hits-by-shapes")
    assert measures.by_name("my.module:measure") == "my.module:measure"
