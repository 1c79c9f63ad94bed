"""What a unit costs apart from its work, as JSON for `saturation.py`.

`PYTHONPATH=tests python benchmarks/internals/cluster/unit_costs.py --help` says what it takes.
Measures internals, not the public API. Units that do nothing go through the whole Ray engine, with
a folder and with a server that speaks S3's protocol; `ray.wait` is timed over ever more calls; and
the episodes of a finished run are read off. A few minutes.
"""

from __future__ import annotations

import json
import os
import statistics
import tempfile
import time
from collections.abc import Callable, Generator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import fsspec
import tyro

from engines.ray_nodes import nodes_and_store
from probe.engines.plan import WorkPlan
from probe.engines.ray_cluster import connected
from probe.engines.ray_engine import RayEngine
from probe.episodes.files import read_records

UNITS, RESULT = 400, bytes(20_000)
PENDING = (1, 250, 1000, 4000)
WAITS = 20


@contextmanager
def idle() -> Generator[Callable[[str], bytes]]:
    """Does nothing, and returns as much as an episode does."""
    yield lambda unit: RESULT


def engine_costs(engine: RayEngine) -> dict[str, float]:
    """Seconds until the first result, and for each later one while workers wait for the driver."""
    plan = WorkPlan("idle", idle, [str(n) for n in range(UNITS)], str)
    since, times = time.perf_counter(), list[float]()
    for _ in engine.carry_out(plan):
        times.append(time.perf_counter() - since)
    late = times[UNITS // 4 :]
    return {"start": times[0], "each": (late[-1] - late[0]) / (len(late) - 1)}


def waiting_costs() -> dict[int, float]:
    """Seconds of a `ray.wait` over so many calls, all but one of which go on."""
    found: dict[int, float] = {}
    with connected(print) as (ray, _):
        sleeper: Any = ray.remote(num_cpus=0)(Sleeper).remote()
        for count in PENDING:
            calls = [sleeper.sleep.remote(60.0) for _ in range(count)]
            times: list[float] = []
            for _ in range(WAITS):
                done = ray.put(0)
                since = time.perf_counter()
                ray.wait([*calls, done], num_returns=1)
                times.append(time.perf_counter() - since)
            found[count] = statistics.median(times)
        ray.kill(sleeper)
    return found


class Sleeper:
    """Keeps a caller waiting."""

    def sleep(self, seconds: float) -> None:
        """Return after a while."""
        time.sleep(seconds)


def main(records: Path) -> None:
    """Measure and print.

    Args:
        records: Folder of a run whose episodes' times are taken.
    """
    os.environ.pop("PROBE_ASSETS", None)
    with tempfile.TemporaryDirectory() as kept, nodes_and_store() as nodes:
        os.environ.update(nodes.environment)
        fsspec.filesystem("s3").mkdir("work")
        episodes = [
            sum(record.seconds.agent) + sum(record.seconds.tools)
            for record in read_records(records / "records.jsonl")
        ]
        costs = {
            "episodes": [round(seconds, 2) for seconds in episodes],
            "folder": engine_costs(RayEngine(Path(kept), None, 2)),
            "store": engine_costs(RayEngine(Path(kept), "s3://work/costs", 2)),
            "wait": waiting_costs(),
        }
    print(json.dumps(costs))


if __name__ == "__main__":
    tyro.cli(main)
