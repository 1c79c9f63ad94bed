"""Episodes for training, many side by side: `python benchmarks/internals/rollouts.py SUITE`.

Measures internals, not the public API. SUITE is a file of tasks for training. A player by chance
looks, removes up to two things and answers; meanwhile a table's process is killed now and then.
Prints how many episodes were lost, their rewards against what `probe rescore` says of the records,
episodes a minute and memory.
"""

from __future__ import annotations

import json
import random
import re
import threading
import time
from concurrent.futures import ThreadPoolExecutor
from contextlib import suppress
from dataclasses import dataclass, field
from itertools import count
from multiprocessing import active_children
from pathlib import Path
from tempfile import mkdtemp

import psutil
import tyro
from rich.console import Console
from rich.progress import track

import probe
from probe.bench.process_pool import EpisodeProcessLost
from probe.episodes.files import read_records
from probe.episodes.folder import RECORDS
from probe.interfaces.training.tables import TrainingTables

_HANDLE = re.compile(r"object_\d+")


@dataclass
class Watch:
    """Notes how much memory the tables' processes take, and kills one of them now and then.

    Attributes:
        every: Seconds between two kills; None for none.
        most: Bytes of all of them together at most, shared pages counted once.
        killed: Processes that were killed.
    """

    every: float | None
    most: int = 0
    killed: int = 0
    _over: threading.Event = field(default_factory=threading.Event)

    def run(self) -> None:
        """Look once a second until told to stop."""
        rng, last = random.Random(0), time.monotonic()
        while not self._over.wait(1):
            family = psutil.Process().children(recursive=True)
            self.most = max(self.most, sum(map(_memory, family)))
            tables = [it for it in active_children() if it.is_alive()]
            if self.every and tables and time.monotonic() - last > self.every:
                rng.choice(tables).kill()
                self.killed, last = self.killed + 1, time.monotonic()

    def stop(self) -> None:
        """Look no more."""
        self._over.set()


def _memory(process: psutil.Process) -> int:
    try:
        return process.memory_full_info().pss
    except psutil.Error:  # it has just ended
        return 0


Reward = tuple[tuple[str, int], float | None]
"""An episode, by its task and run, and what was paid for it."""


def play(env: probe.ProbeEnv, task: str, number: int) -> Reward:
    """Look, remove up to two things, answer: all by chance."""
    rng = random.Random(number)
    env.reset(task=task)
    with suppress(EpisodeProcessLost):  # its reward is None
        for _ in range(rng.randrange(3)):
            handles = _HANDLE.findall(env.perceive_scene())
            if handles:
                env.grasp_and_remove(rng.choice(handles))
        env.answer_question(rng.choice("ABCDE"))
    reward, record = env.get_reward(), env.record
    assert record is not None
    return (record.task, record.run), reward


def regraded(out: Path) -> dict[tuple[str, int], float | None]:
    """What grading the records again pays."""
    probe.rescore(out)
    rows = map(json.loads, (out / "rows.jsonl").read_text().splitlines())
    return {
        (row["task"], row["run"]): None if row["fault"] else float(row["correct"]) for row in rows
    }


def play_all(tables: TrainingTables, ids: list[str], episodes: int) -> list[Reward]:
    """Each thread has an environment, and plays one episode after another."""
    envs = [probe.ProbeEnv(tables) for _ in range(tables.most)]
    numbers, rewards = count(), list[Reward]()
    with ThreadPoolExecutor(tables.most) as threads:

        def in_turn(env: probe.ProbeEnv) -> None:
            while (number := next(numbers)) < episodes:
                rewards.append(play(env, ids[number % len(ids)], number))

        for _ in track(threads.map(in_turn, envs), "Tables ended", total=len(envs)):
            pass
    return rewards


def main(
    suite: tyro.conf.Positional[Path],
    episodes: int = 128,
    tables: int = 8,
    kill_every: float | None = 20.0,
) -> None:
    """Play and print.

    Args:
        suite: Tasks for training.
        episodes: How many.
        tables: At once.
        kill_every: Seconds between two kills of a process; None for none.
    """
    out, watch = Path(mkdtemp(prefix="rollouts-")), Watch(kill_every)
    looking = threading.Thread(target=watch.run, daemon=True)
    looking.start()
    started = time.monotonic()
    tasks = probe.load_suite(suite)
    with probe.training_tables(tasks, tables=tables, out=out) as there:
        rewards = play_all(there, [task.id for task in tasks], episodes)
    minutes = (time.monotonic() - started) / 60
    watch.stop()
    paid, again = dict(rewards), regraded(out)
    parts = [it.participation for it in read_records(out / RECORDS)]
    lost = sum(reward is None for reward in paid.values())
    same = sum(it in again and paid[it] == again[it] for it in paid)
    told = Console()
    told.print(f"{len(rewards)} episodes, {lost} lost, {watch.killed} processes killed")
    told.print(f"tables set again: {sum(len(part.faults) for part in parts if part)} times")
    told.print(f"rewards {sum(filter(None, paid.values())):g}; {same} of {len(paid)} as regraded")
    told.print(f"{len(rewards) / minutes:.1f} episodes a minute, {tables} at once")
    told.print(f"{watch.most / 2**30:.1f} GB in all processes at most; records: {out}")


if __name__ == "__main__":
    tyro.cli(main)
