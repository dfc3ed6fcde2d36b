"""What sweeps of tests run, importable by their workers; as a program, sweeps that something may be done to.

`python -m tests.sweeping` makes a process for each line that it reads, `{"out": …, "runs": …}`, and writes a line with
its number and one with its exit status.
"""

import errno
import json
import os
import signal
import sys
import time
from pathlib import Path
from typing import Any

import pyarrow as pa

import carom
from carom import study
from carom.study.sweeps.store import Folder
from carom.study.sweeps.tables import table_bytes

#: Seconds that a run of `told` naps, so that there is time to do something to its worker.
NAP = "CAROM_TEST_NAP"
#: Where it is set, a deadly run raises, so that this process can make it.
QUIET = "CAROM_TEST_QUIET"
SECONDS = 0.1


def drop(parameters: dict[str, Any]) -> carom.Scene:
    """A ball above a floor, higher for each number."""
    ball = carom.Ball((0.0, 1.0 + 0.01 * parameters.get("number", 0)), radius=0.5, velocity=(0.0, -9.0))
    return carom.Scene(world={"substeps": 1}, shapes=[carom.Segment((-1, 0), (1, 0), name="floor")], balls=[ball])


def told(world: carom.World, hits: carom.Hits, parameters: dict[str, Any]) -> dict[str, Any]:
    """Where the ball is; raises, or ends its process, where the parameters say so."""
    if parameters.get("raises"):
        raise RuntimeError("as it was told")
    if parameters.get("deadly"):
        if os.environ.get(QUIET):
            raise RuntimeError("would kill its worker")
        os.kill(os.getpid(), signal.SIGKILL)
    time.sleep(float(os.environ.get(NAP, "0")))
    return {"height": world.balls.position[0, 1], "hits": len(hits), "path": world.balls.position}


def met(world: carom.World, hits: carom.Hits, parameters: dict[str, Any]) -> dict[str, Any]:
    """What was met, in order, and where the balls that met it are now; moves what it was given."""
    told = [f"{hit.ball.name} {hit.shape.name} {hit.ball.position}" for hit in hits]
    for ball in world.balls:
        ball.position = (0.0, 0.5)
    world.step(1 / 60)
    return {"met": told}


def nonsense(world: carom.World, hits: carom.Hits, parameters: dict[str, Any]) -> Any:
    """What no table can hold."""
    return {"world": world}


def runs(count: int, deadly: int = 0, raises: int = 0) -> list[dict[str, Any]]:
    """The parameters of some runs, of which some kill their worker and some raise, evenly among them."""

    def among(place: int, few: int) -> bool:
        return few > 0 and place % (count // few) == (count // few) // 2

    return [
        {"number": place, "deadly": among(place, deadly), "raises": among(place + 1, raises), "seed": place}
        for place in range(count)
    ]


def without_seconds(table: pa.Table) -> bytes:
    """The bytes of a sweep's table without the time that it took."""
    return table_bytes(table.drop_columns(["seconds"]))


def swept(out: Path | str, rows: list[dict[str, Any]], cluster: Any = "serial", **options: Any) -> pa.Table:
    """The table of a sweep of `drop` with `told`."""
    given = {"measure": "tests.sweeping:told", "seconds": SECONDS, "progress": False} | options
    return study.sweep("tests.sweeping:drop", rows, out=out, cluster=cluster, **given)


def break_writes(kind: str, after: int) -> None:
    """Let a write of this process fail, after some that did not: `failed`, `full` or `torn`, which ends the process."""
    writes = {"write": Folder.write, "append": Folder.append}
    count = 0

    def breaking(how: str) -> Any:
        def write(folder: Folder, name: str, data: bytes) -> None:
            nonlocal count
            count += 1
            if count <= after:
                writes[how](folder, name, data)
                return
            with (Path(folder.name) / name).open("ab" if how == "append" else "wb") as file:
                file.write(data[: len(data) // 2] if kind != "failed" else b"")
            if kind == "torn":
                os._exit(3)
            raise OSError(errno.ENOSPC if kind == "full" else errno.EIO, os.strerror(errno.ENOSPC))

        return write

    for how in writes:
        setattr(Folder, how, breaking(how))


def coordinate(asked: dict[str, Any]) -> int:
    """The exit status of a process that runs the sweep which is asked for: 1 and one line where it is refused."""
    if "fault" in asked:
        break_writes(*asked["fault"])
    try:
        swept(asked["out"], runs(asked["runs"], asked["deadly"]), asked["cluster"])
    except carom.CaromError as error:
        sys.stderr.write(f"{type(error).__name__}: {error}\n")
        return 1
    return 0


def main() -> None:
    """Fork a process for each sweep that is asked for, which saves it the time to import everything."""
    import distributed  # noqa: F401

    for line in sys.stdin:
        asked = json.loads(line)
        child = os.fork()
        if child == 0:
            status = coordinate(asked)
            sys.stderr.flush()
            os._exit(status)
        sys.stdout.write(f"{child}\n")
        sys.stdout.flush()
        sys.stdout.write(f"{os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])}\n")
        sys.stdout.flush()


if __name__ == "__main__":
    main()
