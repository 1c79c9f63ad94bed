"""Where a Ray cluster saturates, simulated: `python benchmarks/internals/cluster/saturation.py`.

Measures internals, not the public API. Needs `pip install simpy matplotlib`, and nothing of PROBE.
Clusters of 16 to 4,000 cores do a hundred episodes a core. What a unit costs apart from its work
was measured on two cores by `unit_costs.py` (whose JSON lies beside this file); trips to an object
store, its bandwidth, deaths and stragglers are assumed, and named below. Prints how busy cores are,
and draws a picture.
"""

from __future__ import annotations

import argparse
import json
import random
from collections.abc import Generator
from dataclasses import dataclass
from importlib import import_module
from pathlib import Path
from typing import Any

import numpy as np

simpy: Any = import_module("simpy")
plt: Any = import_module("matplotlib.pyplot")

CORES = (16, 64, 250, 500, 1000, 2000, 4000)
UNITS_A_CORE = 100
CORES_A_NODE = 16
TRIP = 0.04
"""Seconds of a request to an object store."""
TOGETHER = 64
"""Requests that are under way at a time."""
ASSETS, STORE_RATE, NODE_RATE = 4e9, 12e9, 1.2e9
"""Bytes of the assets; bytes a second that the store and a node's network carry."""
STRAGGLERS, SLOWER = 0.01, 8.0
"""Share of episodes that take so many times as long."""
DEATHS = 1 / 7200
"""Of a worker, a second: a node of 16 cores that is taken away each eight minutes or so."""
OPENING = 8.0
"""Seconds in which a worker sets its library and renderer up."""


@dataclass(frozen=True)
class Driver:
    """What the one driver does for each unit.

    Attributes:
        name: In the picture.
        each: Seconds for a result.
        wait: Seconds of `ray.wait` for each open call.
        trips: Trips to the store for what it fetches together; 0 with a folder.
        together: Results that are fetched at a time.
    """

    name: str
    each: float
    wait: float
    trips: int = 0
    together: int = TOGETHER

    def fetching(self, results: int) -> float:
        """Seconds in which results are fetched and removed."""
        return self.trips * -(-results // self.together) * TRIP


class Cluster:
    """Workers, their driver and what waits.

    Attributes:
        done: Units.
        useful: Seconds of work that led to a result.
    """

    def __init__(self, cores: int, driver: Driver, episodes: list[float], start: float) -> None:
        self.env = simpy.Environment()
        self.done, self.useful = 0, 0.0
        self._driver, self._episodes, self._cores = driver, episodes, cores
        self._start = start
        self._draw = random.Random(cores)
        self._units = cores * UNITS_A_CORE
        self._waiting = self._units
        self._news = simpy.Store(self.env)

    def run(self) -> float:
        """Share of all cores' time that was useful work."""
        for _ in range(self._cores):
            self.env.process(self._opened(self.opening()))
        self.env.run(until=self.env.process(self._drive()))
        return self.useful / (self._cores * self.env.now)

    def opening(self) -> float:
        """Seconds until the assets are there and a worker is set up."""
        nodes = -(-self._cores // CORES_A_NODE)
        fetched = max(ASSETS / NODE_RATE, nodes * ASSETS / STORE_RATE)
        return self._start + OPENING + (fetched if self._driver.trips else 0.0)

    def _opened(self, seconds: float) -> Generator[Any]:
        yield self.env.timeout(seconds)
        yield self._news.put("opened")

    def _worked(self) -> Generator[Any]:
        """One unit by a worker that may die over it."""
        seconds = self._draw.choice(self._episodes)
        seconds *= SLOWER if self._draw.random() < STRAGGLERS else 1.0
        death = self._draw.expovariate(DEATHS)
        yield self.env.timeout(min(seconds, death))
        if death < seconds:
            self._waiting += 1
            yield self.env.process(self._opened(self._start + OPENING))
            return
        self.useful += seconds
        yield self.env.timeout(TRIP if self._driver.trips else 0.0)
        yield self._news.put("done")

    def _drive(self) -> Generator[Any]:
        """Take in what workers say, give them more, fetch results."""
        while self.done < self._units:
            news = [(yield self._news.get()), *self._news.items]
            self._news.items.clear()
            yield self.env.timeout(2 * self._cores * self._driver.wait)
            for _ in news:
                yield self.env.timeout(self._driver.each)
                if self._waiting:
                    self._waiting -= 1
                    self.env.process(self._worked())
            results = news.count("done")
            yield self.env.timeout(self._driver.fetching(results))
            self.done += results


def drivers(costs: dict[str, Any]) -> list[Driver]:
    """With a folder, with a store, and with a store if each result were fetched alone."""
    waits = {int(calls): seconds for calls, seconds in costs["wait"].items()}
    wait = max(waits.values()) / max(waits)
    each = costs["folder"]["each"]
    return [
        Driver("shared folder", each, wait),
        Driver("object store", each, wait, trips=2),
        Driver("object store, results fetched singly", each, wait, trips=2, together=1),
    ]


def draw(shares: dict[str, list[float]], openings: list[float], path: Path) -> None:
    """Both panels."""
    figure, (left, right) = plt.subplots(1, 2, figsize=(10, 4), layout="constrained")
    for name, found in shares.items():
        left.plot(CORES, np.multiply(100, found), marker="o", label=name)
    left.set(xscale="log", ylim=(0, 100), xlabel="cores", ylabel="useful share of cores' time, %")
    left.legend(loc="lower left", frameon=False)
    right.plot(CORES, openings, marker="o", color="C1")
    right.set(xscale="log", xlabel="cores", ylabel="seconds until workers begin, object store")
    right.set_ylim(bottom=0)
    for axes in (left, right):
        axes.grid(alpha=0.3)
        axes.set_xticks(CORES, [f"{cores:,}" for cores in CORES])
        axes.minorticks_off()
    figure.savefig(path)


def main() -> None:
    """Simulate, print and draw."""
    here = Path(__file__).resolve()
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--costs", type=Path, default=here.with_name("unit_costs.json"))
    parser.add_argument(
        "--picture", type=Path, default=here.parents[3] / "docs" / "pictures" / "cluster.svg"
    )
    said = parser.parse_args()
    costs: dict[str, Any] = json.loads(said.costs.read_text())
    shares: dict[str, list[float]] = {}
    openings: list[float] = []
    for driver in drivers(costs):
        found: list[float] = []
        for cores in CORES:
            cluster = Cluster(cores, driver, costs["episodes"], costs["folder"]["start"])
            found.append(cluster.run())
            if driver.name == "object store":
                openings.append(cluster.opening())
        shares[driver.name] = found
        print(
            f"{driver.name:40}",
            *(f"{cores}: {x:.0%}" for cores, x in zip(CORES, found, strict=True)),
        )
    print("seconds until workers begin:", *(round(seconds) for seconds in openings))
    draw(shares, openings, said.picture)


if __name__ == "__main__":
    main()
