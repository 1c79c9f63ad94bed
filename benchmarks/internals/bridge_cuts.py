"""What a robot does when its link or a process dies: `python benchmarks/internals/bridge_cuts.py`.

Measures internals, not the public API.

An agent takes things off the table of a twin that runs in a process of its own (`probe robot
twin`), over the real bridge and over a proxy. At a drawn moment of a drawn motion the proxy harms
the link, or a process is killed. When the arm rests is read from the twin's physics, not from what
the bridge says. Then the same twin's arm is brought home over a new connection, and the next
episode begins. About 15 seconds a try.
"""

from __future__ import annotations

import multiprocessing
import re
import subprocess
import sys
import tempfile
import threading
import time
from collections.abc import Sequence
from contextlib import suppress
from dataclasses import dataclass, field, replace
from multiprocessing.process import BaseProcess
from pathlib import Path
from typing import Literal, get_args

import numpy as np
import tyro
from link_proxy import LinkProxy
from probe_bridge.client import RobotClient
from probe_bridge.errors import BridgeError
from rich.console import Console
from rich.table import Table

from probe.agents.reading import read_graph
from probe.episodes.files import append_record, read_records
from probe.episodes.grading import grade_episode
from probe.episodes.real import open_real_episode
from probe.episodes.turns import Call
from probe.errors import ProbeError, RobotLost
from probe.perception.choice import segmented
from probe.scores.marking import row_of
from probe.station.remote import PARKED, RobotStation, connected
from probe.tasks.suite import Suite
from probe.tasks.suite_file import demo_suite, write_suite
from probe.tasks.task import Task
from probe.twin.trace import Moment, read_trace

Fault = Literal[
    "cable pulled",
    "connection reset",
    "client killed",
    "twin killed",
    "2 s late in a motion",
    "2 s late before one",
    "10 % lost",
]

LEASE, BRAKING = 0.5, 0.25
"""Seconds: the bridge's lease, and what is allowed for noticing it and for braking."""

AT_REST = 0.02
"""Radians a second below which every joint of an arm at rest is."""

PATIENCE = 90.0
SMALL = 256
ROOT = Path(__file__).resolve().parents[2]
out = Console(width=140)


@dataclass
class Try:
    """What came of one harm.

    Attributes:
        moving: Whether the arm moved at that moment.
        rest: Seconds until it rested; NaN where the physics died.
        stall: Longest time meanwhile that the twin's physics stood still, as other programs had
            the machine: by about so much the twin's bridge was late, too.
        noticed: Seconds until the client's episode had ended; NaN if it was killed.
        end: Of the episode's record; "no record" where the client was killed.
        scored: Whether it counts.
        resumed: Whether the next episode on the same twin came to its motion.
    """

    moving: bool
    rest: float
    stall: float
    noticed: float
    end: str
    scored: bool
    resumed: bool = False


@dataclass
class Twin:
    """A twin in a process of its own, until it is killed."""

    folder: Path
    task: Task
    port: int = 0
    process: subprocess.Popen[str] | None = None
    started: int = 0

    @property
    def trace(self) -> Path:
        return self.folder / f"trace-{self.started}.jsonl"

    @property
    def suite(self) -> Path:
        return self.folder / "suite.json"

    @property
    def token(self) -> Path:
        return self.folder / "token"

    def start(self) -> None:
        self.end()
        self.started += 1
        words = ["--suite", str(self.suite), "--task", self.task.id, "--port", "0", "--token-file",
                 str(self.token), "--trace", str(self.trace), "--flaws", "none"]  # fmt: skip
        command = [sys.executable, "-m", "probe", "robot", "twin", *words]
        self.process = subprocess.Popen(command, stdout=subprocess.PIPE, text=True, cwd=ROOT)
        assert self.process.stdout is not None
        for line in self.process.stdout:
            found = re.search(r"ws://127\.0\.0\.1:(\d+)", line)
            if found:
                self.port = int(found[1])
                return
        raise RuntimeError("the twin did not start")

    def end(self) -> None:
        if self.process is not None:
            self.process.kill()
            self.process.wait()
            self.process = None


@dataclass
class Player:
    """Plays episodes, each over its own connection."""

    address: str
    token: str
    folder: Path
    task: Task
    number: int
    ready: threading.Event = field(default_factory=threading.Event)

    def play(self) -> None:
        """Connect, bring the arm home, take something off the table, answer; keep the record."""
        client = self._connected()
        with suppress(RobotLost):  # nobody is left to say farewell to
            try:
                station = RobotStation(client, self.task.setup, self.task.camera, looks=1)
                bring_home(client, station)
                episode = open_real_episode(
                    self.task, "cut", station, segmented, self.folder, self.number
                )
                shown = read_graph(episode.step(Call.of("perceive_scene")).result.text).objects
                handle = shown[self.number % len(shown)].object_id
                self.ready.set()
                time.sleep(0.1)
                episode.step(Call.of("grasp_and_remove", {"object_id": handle}))
                episode.step(Call.of("answer_question", {"choice": "A"}))
                append_record(self.folder / "records.jsonl", episode.record)
            finally:
                client.close()

    def _connected(self):
        """A connection, as soon as the bridge has noticed that the last client is gone."""
        until = time.monotonic() + 15.0
        while True:
            try:
                return connected(self.address, self.token)
            except RobotLost:
                if time.monotonic() > until:
                    raise
                time.sleep(0.3)


def bring_home(client: RobotClient, station: RobotStation) -> None:
    """What a person does who releases the arm; a busy machine may need a second try."""
    for _ in range(3):
        if np.abs(station.joints() - station.arm.parked).max() <= PARKED:
            return
        try:
            client.home()
        except BridgeError as error:
            out.print(f"  not home: {error}", highlight=False)


def play_in_process(address: str, token: str, folder: Path, task: Task, number: int) -> None:
    Player(address, token, folder, task, number).play()


def tried(twin: Twin, fault: Fault, number: int, rng: np.random.Generator) -> Try | None:
    """One harm at a drawn moment; None if no motion came about."""
    proxy = LinkProxy(twin.port, number)
    player = Player(proxy.address, twin.token.read_text().strip(), twin.folder, twin.task, number)
    about = (player.address, player.token, player.folder, player.task, player.number)
    spawned = multiprocessing.get_context("spawn").Process(target=play_in_process, args=about)
    runs = spawned if fault == "client killed" else threading.Thread(target=player.play)
    runs.start()
    wanted = int(rng.integers(1, 3))
    later = float(rng.uniform(0.02, 0.7))
    try:
        if fault == "2 s late before one":
            begun = player.ready.wait(PATIENCE)
        else:
            begun = moved(proxy, runs, wanted)
            time.sleep(later)
        if not begun:
            return None
        at = time.monotonic()
        harm(fault, proxy, twin, spawned)
        runs.join(PATIENCE)
        ended = time.monotonic()
        time.sleep(1.0)
        return outcome(fault, twin, player, proxy, at, ended)
    finally:
        proxy.close()
        runs.join(PATIENCE)


def moved(proxy: LinkProxy, runs: threading.Thread | BaseProcess, wanted: int) -> bool:
    """Wait for so many motions of the arm after the one home; whether they came."""
    until = time.monotonic() + PATIENCE
    while runs.is_alive() and time.monotonic() < until:
        if sum(do == "follow" for _, do in proxy.heard) >= wanted:
            return True
        time.sleep(0.005)
    return False


def harm(fault: Fault, proxy: LinkProxy, twin: Twin, spawned) -> None:
    if fault == "cable pulled":
        proxy.harm = "silent"
    elif fault == "connection reset":
        proxy.cut()
    elif fault == "client killed":
        spawned.kill()
    elif fault == "twin killed":
        twin.end()
    elif fault == "10 % lost":
        proxy.harm = "lossy"
    else:
        proxy.harm = "late"


def outcome(
    fault: Fault, twin: Twin, player: Player, proxy: LinkProxy, at: float, ended: float
) -> Try:
    moments = [moment for moment in read_trace(twin.trace) if moment.clock > at - 2.0]
    around = [moment for moment in moments if abs(moment.clock - at) < 0.1]
    heard = [when for when, do in proxy.heard if do in ("lease", "follow", "home", "grip")]
    if fault == "twin killed":
        rest = float("nan")
    elif fault == "10 % lost":
        rest = longest_unheard(moments, heard, at)
    else:
        rest = max((m.clock - at for m in moments if fast(m) and m.clock > at), default=0.0)
    path = twin.folder / "records.jsonl"
    records = [r for r in (read_records(path) if path.exists() else []) if r.run == player.number]
    scored = False
    for record in records:
        score = grade_episode(twin.task, record, np.zeros((1, 1), int))
        scored |= not row_of(twin.task, record, score, suite="demo", setting="").missing
    end = records[0].end if records else "no record"
    noticed = float("nan") if fault == "client killed" else ended - at
    return Try(any(map(fast, around)), rest, stall(moments, at, rest), noticed, end, scored)


def fast(moment: Moment) -> bool:
    return bool(np.abs(moment.speeds).max() > AT_REST)


def stall(moments: Sequence[Moment], at: float, rest: float) -> float:
    """Longest time between two steps from a moment on until the arm rested."""
    clocks = [moment.clock for moment in moments if at - 0.1 < moment.clock < at + rest + 0.01]
    return float(np.diff(clocks).max(initial=0.0))


def longest_unheard(moments: Sequence[Moment], heard: Sequence[float], since: float) -> float:
    """The longest that the arm moved after the bridge was last sent anything to move by."""
    times = np.array(heard)
    moving = [moment.clock for moment in moments if fast(moment) and moment.clock > since]
    return max((t - float(times[times <= t].max(initial=since)) for t in moving), default=0.0)


def broken(fault: Fault, tries: Sequence[Try]) -> list[Try]:
    """Tries after which the arm moved for too long, stalls of the machine apart, or that count.

    Where messages are only lost now and then, an episode may come to its end; then it counts.
    """
    ended = "answered" if fault == "10 % lost" else ""
    return [
        each
        for each in tries
        if each.rest - each.stall > LEASE + BRAKING
        or (each.end != ended and (each.scored or each.end not in ("fault", "no record")))
    ]


def row(fault: Fault, tries: Sequence[Try]) -> list[str]:
    rests = np.array([each.rest for each in tries if each.moving])
    noticed = np.array([each.noticed for each in tries])
    ends = {end: sum(each.end == end for each in tries) for end in {t.end for t in tries}}
    interrupted = ends.get("fault", 0) + ends.get("no record", 0)
    late = [each for each in tries if each.rest > LEASE + BRAKING]
    excused = sum(each.rest - each.stall <= LEASE + BRAKING for each in late)
    times = "physics killed" if np.isnan(rests).all() else (
        f"{np.median(rests):.2f} / {rests.max():.2f}")  # fmt: skip
    if fault == "2 s late before one":
        times = f"{max(each.rest for each in tries):.2f}"
    return [
        fault,
        str(len(tries)),
        str(sum(each.moving for each in tries)),
        times,
        f"{len(late)}" + (f", {excused} with a stall of the machine" if late else ""),
        "killed" if np.isnan(noticed).all() else f"{np.nanmax(noticed):.1f}",
        f"{interrupted} ({ends})",
        str(sum(each.scored for each in tries)),
        f"{sum(each.resumed for each in tries)}",
    ]


def main(
    tries: int = 20, only: tuple[Fault, ...] = get_args(Fault), seed: int = 0, task: int = 0
) -> None:
    """Harm a robot's link and its processes, and print what came of it.

    Args:
        tries: Of each harm.
        only: Which harms.
        seed: Of the moments.
        task: Number of the demo suite's task whose table the twin has.
    """
    table = Table("harm", "tries", "arm moved then", "at rest after, s: median / most",
                  f"over {LEASE + BRAKING} s", "client knew after, s", "interrupted",
                  "scored", "next episode ran")  # fmt: skip
    bad: list[Try] = []
    with tempfile.TemporaryDirectory() as folder:
        twin = Twin(Path(folder), with_small_pictures(Path(folder) / "suite.json", task))
        try:
            for number, fault in enumerate(only):
                rng = np.random.default_rng([seed, get_args(Fault).index(fault)])
                done = harmed(twin, fault, tries, 1000 * number, rng)
                table.add_row(*row(fault, done))
                bad += broken(fault, done)
        finally:
            twin.end()
            out.print(table)
    if bad:
        sys.exit(f"{len(bad)} tries broke what they should show: {bad}")


def with_small_pictures(path: Path, number: int) -> Task:
    """A task of the demo suite, which a suite's file gets, with pictures that are quick to draw."""
    suite = demo_suite()
    task = suite.tasks[number]
    scene = replace(task.scene, setup=replace(task.setup, name="small", picture_px=SMALL))
    small = replace(task, scene=scene)
    write_suite(path, Suite("small", (small,), suite.objects))
    return small


def harmed(twin: Twin, fault: Fault, tries: int, first: int, rng: np.random.Generator) -> list[Try]:
    """So many tries; one more episode shows that the session goes on after the last."""
    done: list[Try] = []
    number, barren = first, 0
    twin.start()
    while len(done) < tries and barren < 10:
        number += 1
        if twin.process is None:
            twin.start()
        each = tried(twin, fault, number, rng)
        if each is None:
            barren += 1
            out.print(f"{fault}: no motion came about; the table is laid anew", highlight=False)
            twin.start()
            continue
        if done:
            done[-1].resumed = True
        done.append(each)
        out.print(f"{fault} {len(done)}: {each}", highlight=False)
    if twin.process is None:
        twin.start()
    done[-1].resumed = unharmed(twin, number + 1)
    return done


def unharmed(twin: Twin, number: int) -> bool:
    """Whether an episode that nobody harms is played to its end."""
    token = twin.token.read_text().strip()
    with suppress(ProbeError):
        player = Player(f"ws://127.0.0.1:{twin.port}", token, twin.folder, twin.task, number)
        player.play()
    last = read_records(twin.folder / "records.jsonl")[-1]
    return last.run == number and last.end == "answered"


if __name__ == "__main__":
    tyro.cli(main)
