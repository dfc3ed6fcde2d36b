"""The ledger of a sweep: which parts are done. What it does not say did not happen.

`sweep.json` says which sweep it is, each `part-….parquet` holds the rows of a chunk, and `ledger.jsonl` has one line
for each part, written after the part: its name, the hash of its bytes, the attempt and the worker. A line that is torn,
or whose part is damaged, does not count, and its runs are done again.
"""

from __future__ import annotations

import json
from collections.abc import Iterable, Sequence
from hashlib import blake2b
from typing import Any

from carom.errors import InvalidArgument, SweepError
from carom.study.sweeps.job import Row
from carom.study.sweeps.store import Store
from carom.study.sweeps.tables import part_bytes, rows_of
from carom.study.sweeps.values import name_of, text_of

SWEEP, LEDGER, PART, TABLE, FAILURES = "sweep.json", "ledger.jsonl", "part-", "table.parquet", "failures.parquet"


class Ledger:
    """What is done of one sweep, in a place that is claimed.

    Attributes:
        done: The ids of the runs that are counted.
        failed: How many of them failed.
    """

    def __init__(self, store: Store, sweep: dict[str, Any], ids: Iterable[str]) -> None:
        self._store = store
        self._sweep = sweep
        self._ids = frozenset(ids)
        self._parts: list[str] = []
        self.done: set[str] = set()
        self.failed = 0

    def open(self) -> None:
        """Read what is there, and take away what does not count.

        Raises:
            InvalidArgument: The place holds another sweep.
            OSError: It cannot be read or written.
        """
        self._check_sweep()
        data = self._store.read(LEDGER) or b""
        lines = [line for line in data.decode("utf-8", "replace").splitlines() if self._counts(line)]
        good = "".join(f"{line}\n" for line in lines).encode()
        if good != data:
            self._store.write(LEDGER, good)
        for name in self._store.names():
            stray = name.startswith(PART) and name not in self._parts
            if stray or (name.startswith(".") and name.endswith(".part")):
                self._store.remove(name)

    def _check_sweep(self) -> None:
        """Write down which sweep this is, or see that it is the one that is written there."""
        text = self._store.read(SWEEP)
        if text is None:
            if self._store.read(LEDGER):
                raise InvalidArgument(f"out {self._store.name}: holds a ledger, but no {SWEEP} that says of what")
            self._store.write(SWEEP, (json.dumps(self._sweep, indent=1) + "\n").encode())
            return
        try:
            there = dict(json.loads(text))
        except (ValueError, TypeError):
            raise InvalidArgument(f"out {self._store.name}: holds a {SWEEP} that is no sweep's") from None
        for name, value in self._sweep.items():
            if there.get(name) != value:
                told = f": {there.get(name)}, not {value}" if len(str(value)) < 32 else ""
                raise InvalidArgument(f"out {self._store.name}: holds another sweep, which differs in its {name}{told}")

    def _counts(self, line: str) -> bool:
        """Whether a line is whole, and so is its part; if so its runs are counted."""
        try:
            entry = json.loads(line)
            name, expected = entry["part"], entry["hash"]
        except (ValueError, TypeError, KeyError):
            return False
        data = self._store.read(name) if isinstance(name, str) and name.startswith(PART) else None
        if data is None or hash_of(data) != expected:
            return False
        rows = [row for row in rows_of(data) if row.run in self._ids and row.run not in self.done]
        if not rows or name in self._parts:
            return False
        self._count(name, rows)
        return True

    def _count(self, name: str, rows: Sequence[Row]) -> None:
        """Count the rows of a part."""
        self._parts.append(name)
        self.done.update(row.run for row in rows)
        self.failed += sum(row.error is not None for row in rows)

    def add(self, rows: Sequence[Row], attempt: int, worker: str) -> None:
        """Write a part and then its line; runs that are counted already are left out.

        Raises:
            SweepError: It cannot be written; what was written before counts.
        """
        fresh = [row for row in rows if row.run not in self.done]
        if not fresh:
            return
        name = f"{PART}{name_of([row.run for row in fresh])}.parquet"
        data = part_bytes(fresh)
        entry = {"part": name, "hash": hash_of(data), "runs": len(fresh), "attempt": attempt, "worker": worker}
        try:
            self._store.write(name, data)
            self._store.append(LEDGER, f"{text_of(entry)}\n".encode())
        except OSError as error:
            raise self.refusal(error) from None
        self._count(name, fresh)

    def rows(self) -> dict[str, Row]:
        """The rows that count, by run, as they are written; raises `SweepError` where one cannot be read again."""
        rows: dict[str, Row] = {}
        for name in self._parts:
            for row in rows_of(self._store.read(name) or b""):
                rows.setdefault(row.run, row)
        if not self._ids <= rows.keys():
            raise SweepError(f"{self._store.name}: parts were taken away meanwhile; the same sweep does them again")
        return rows

    def finish(self, table: bytes, failures: bytes) -> None:
        """Write the tables at the end of a sweep; raises `SweepError`."""
        try:
            self._store.write(TABLE, table)
            self._store.write(FAILURES, failures)
        except OSError as error:
            raise self.refusal(error) from None

    def refusal(self, error: OSError) -> SweepError:
        """The error to raise where something cannot be written."""
        kept = f"{len(self.done):,} of {len(self._ids):,} runs are kept, and the same sweep goes on with the rest"
        return SweepError(f"{self._store.name}: cannot be written: {error.strerror or error}; {kept}")


def hash_of(data: bytes) -> str:
    """The hash of a part's bytes, as 32 hexadecimal digits."""
    return blake2b(data, digest_size=16).hexdigest()
