"""Copy k of any batch is, to the bit, a lone world that was treated likewise: whatever is done, in any order."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from hypothesis import HealthCheck, settings
from hypothesis import strategies as st
from hypothesis.stateful import RuleBasedStateMachine, initialize, invariant, rule, run_state_machine_as_test

import carom
from carom.worlds import threads
from tests.worlds import game_table, named

DT = 1 / 50


class Copies(RuleBasedStateMachine):
    """`Worlds` beside lone worlds."""

    detection = "discrete"

    @initialize(copies=st.integers(1, 4), number=st.integers(1, 3), old=st.integers(0, 30))
    def begin(self, copies: int, number: int, old: int) -> None:
        world = game_table(self.detection)
        for _ in range(old):
            world.step(DT)
        self.worlds = carom.Worlds(world, copies, threads=number)
        self.start = world.snapshot()
        self.lone = [self.made(self.start) for _ in range(copies)]
        self.kept: list[tuple[bytes, list[bytes], Any]] = []
        self.counted = np.zeros((copies, len(world.shapes), 2), np.int64)

    def made(self, snapshot: bytes) -> carom.World:
        world = game_table(self.detection)
        world.restore(snapshot)
        return world

    def mask(self, seed: int) -> Any:
        return np.random.default_rng(seed).random(len(self.lone)) < 0.5

    def compare(self, hits: Any, lone: list[Any]) -> None:
        assert list(hits["world"]) == [k for k, own in enumerate(lone) for _ in own]
        for name in carom.Hits.DTYPE.names or ():
            expected = np.concatenate([np.asarray(own[name]) for own in lone])
            assert np.asarray(hits[name]).tobytes() == expected.tobytes(), name
        for copy, own in enumerate(lone):
            for hit in own:
                shape = hit.shape if getattr(hit.shape, "compound", None) is None else hit.shape.compound
                if isinstance(shape, carom.Ball) or hit.kind == carom.HitKind.EXIT:
                    continue
                column = list(self.lone[copy].shapes).index(shape)
                self.counted[copy, column, int(hit.kind)] += 1

    @rule(count=st.integers(1, 8))
    def step(self, count: int) -> None:
        for _ in range(count):
            self.compare(self.worlds.step(DT), [world.step(DT) for world in self.lone])

    @rule(seconds=st.sampled_from([0.0, 0.1, 0.4]))
    def run(self, seconds: float) -> None:
        self.compare(self.worlds.run(seconds, DT), [world.run(seconds, DT) for world in self.lone])

    @rule(seed=st.integers(0, 99), name=st.sampled_from(["flipper", "platform"]))
    def turn(self, seed: int, name: str) -> None:
        speeds = np.random.default_rng(seed).normal(0, 5, len(self.lone))
        self.worlds.shapes[name].angular_velocity = speeds
        for world, speed in zip(self.lone, speeds, strict=True):
            named(world, name).angular_velocity = float(speed)

    @rule(seed=st.integers(0, 99))
    def travel(self, seed: int) -> None:
        speeds = np.random.default_rng(seed).normal(0, 1, (len(self.lone), 2))
        self.worlds.shapes["platform"].velocity = speeds
        for world, (x, y) in zip(self.lone, speeds.tolist(), strict=True):
            named(world, "platform").velocity = (x, y)

    @rule(seed=st.integers(0, 99))
    def send(self, seed: int) -> None:
        copy, rng = seed % len(self.lone), np.random.default_rng(seed)
        named(self.lone[copy], "platform").move_to(rng.uniform((-0.5, -2.4), (2, -2)).tolist(), dt=0.3)
        self.worlds.load(copy, self.lone[copy])

    @rule(seed=st.integers(0, 99))
    def put(self, seed: int) -> None:
        rng = np.random.default_rng(seed)
        places, angle = rng.uniform((-0.5, -2.4), (2, -2), (len(self.lone), 2)), float(rng.uniform(-0.2, 0.6))
        self.worlds.shapes["platform"].position = places
        self.worlds.shapes["flipper"].orientation = angle
        for world, (x, y) in zip(self.lone, places.tolist(), strict=True):
            named(world, "platform").position = (x, y)
            named(world, "flipper").orientation = angle

    @rule(seed=st.integers(0, 99), name=st.sampled_from(["bumper", "target", "sensor", "platform", "flipper"]))
    def switch(self, seed: int, name: str) -> None:
        flags = self.mask(seed)
        self.worlds.shapes[name].can_collide = flags
        for world, flag in zip(self.lone, flags.tolist(), strict=True):
            shape = named(world, name)
            for part in shape.shapes if isinstance(shape, carom.Compound) else [shape]:
                part.can_collide = flag

    @rule(seed=st.integers(0, 99))
    def push(self, seed: int) -> None:
        mask = self.mask(seed)
        velocity = np.random.default_rng(seed).normal(0, 3, 2)
        self.worlds.balls.velocity[mask, 1] = velocity
        for world in np.array(self.lone, object)[mask]:
            world.balls.velocity[world.balls.id == self.worlds.balls.id[1]] = velocity

    @rule(seed=st.integers(0, 99))
    def resize(self, seed: int) -> None:
        sizes = np.random.default_rng(seed).uniform(0.05, 0.3, len(self.lone))
        self.worlds.balls.radius[:, 2] = sizes
        for world, size in zip(self.lone, sizes, strict=True):
            column = world.balls.radius
            column[world.balls.id == self.worlds.balls.id[2]] = size

    @rule(seed=st.integers(0, 99), ball=st.integers(0, 2))
    def take_out(self, seed: int, ball: int) -> None:
        mask = self.mask(seed)
        for copy in np.flatnonzero(mask & self.worlds.balls.in_play[:, ball]):
            world = self.lone[copy]
            world.remove(world.object(int(self.worlds.balls.id[ball])))
        self.worlds.balls.in_play[mask, ball] = False

    @rule(seed=st.integers(0, 99))
    def reset(self, seed: int) -> None:
        mask = self.mask(seed)
        self.worlds.reset(mask)
        self.counted[mask] = 0
        for copy in np.flatnonzero(mask):
            self.lone[copy] = self.made(self.start)

    @rule(seed=st.integers(0, 99))
    def load(self, seed: int) -> None:
        source, target = np.random.default_rng(seed).integers(0, len(self.lone), 2).tolist()
        world = self.worlds[source]
        assert world.digest() == self.lone[source].digest()
        steps = seed % 3
        for one in (world, self.lone[source]):
            for _ in range(steps):
                one.step(DT)
        self.worlds.load(target, world)
        self.worlds.load(source, world)
        self.lone[target] = self.made(world.snapshot())

    @rule(seed=st.integers(0, 99))
    def store(self, seed: int) -> None:
        source, target = np.random.default_rng(seed).integers(0, len(self.lone), 2).tolist()
        self.worlds.store(source, self.lone[target])
        assert self.lone[target].digest() == self.lone[source].digest()
        self.worlds.load(target, self.lone[target])

    @rule()
    def keep(self) -> None:
        self.kept.append((self.worlds.snapshot(), [world.snapshot() for world in self.lone], self.counted.copy()))

    @rule()
    def bring_back(self) -> None:
        if self.kept:
            whole, parts, counted = self.kept[-1]
            self.worlds.restore(whole)
            self.lone = [self.made(part) for part in parts]
            self.counted = counted.copy()

    @invariant()
    def same(self) -> None:
        if hasattr(self, "lone"):
            assert self.worlds.digests() == [world.digest() for world in self.lone]
            assert self.worlds.counts["bounces"].tolist() == self.counted[..., 0].tolist()
            assert self.worlds.counts["entries"].tolist() == self.counted[..., 1].tolist()


class ContinuousCopies(Copies):
    detection = "continuous"


@pytest.mark.parametrize("machine", [Copies, ContinuousCopies])
def test_a_copy_is_what_a_lone_world_is(machine: type[Copies], monkeypatch: pytest.MonkeyPatch) -> None:
    check(machine, 2, 6, monkeypatch)


@pytest.mark.slow
@pytest.mark.compiled
@pytest.mark.parametrize("machine", [Copies, ContinuousCopies])
def test_many_copies_are_what_lone_worlds_are(machine: type[Copies], monkeypatch: pytest.MonkeyPatch) -> None:
    check(machine, 60, 14, monkeypatch)


def check(machine: type[Copies], examples: int, steps: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """Run a machine, with a thread for every copy that may have one."""
    monkeypatch.setattr(threads, "SHARE", 1)
    quiet = [HealthCheck.too_slow, HealthCheck.filter_too_much]
    run_state_machine_as_test(  # type: ignore[no-untyped-call]
        machine,
        settings=settings(max_examples=examples, stateful_step_count=steps, deadline=None, suppress_health_check=quiet),
    )
