"""Evaluations of a scripted policy behind a local server that fails in every way, at any size.

Measures internals, not the public API.

    python benchmarks/internals/seats.py                      # the demo, minutes
    python benchmarks/internals/seats.py v1.json --direct 150 --agentic 30 --epochs 3 --alike 30

Says how long it took, which faults came to pass, and whether nothing was lost; exits with an error
if something was.
"""

from __future__ import annotations

import random
import re
import sys
import time
from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from multiprocessing import active_children
from pathlib import Path
from tempfile import mkdtemp
from threading import Lock
from typing import Any

import tyro

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests"))

from bench.sitting_in import metrics_of, run_in  # noqa: E402
from model_server import Reply, serving  # noqa: E402
from policy_server import Policy, agent_in_run_0, task_of  # noqa: E402
from probe.api.resources import cache_folder, everything, opener  # noqa: E402
from probe.bench.plan import ModelRunPlan  # noqa: E402
from probe.episodes.circumstances import Circumstances  # noqa: E402
from probe.episodes.files import line_of, read_records  # noqa: E402
from probe.episodes.folder import RECORDS, in_order, standing  # noqa: E402
from probe.episodes.noise import NOISES  # noqa: E402
from probe.episodes.play import play  # noqa: E402
from probe.episodes.record import EpisodeRecord  # noqa: E402
from probe.render.renderer import Renderer  # noqa: E402
from probe.runs.episode_worker import EpisodeWorkerSetup  # noqa: E402
from probe.tasks.suite import Suite, selection, spaced  # noqa: E402
from probe.tasks.suite_file import find_suite  # noqa: E402
from probe.tasks.task import Task  # noqa: E402
from probe.transcripts.prompts import Setting  # noqa: E402

PATIENCE = 60
"""Seconds for one attempt at a reply."""

Script = Callable[[int, dict[str, Any]], Reply]


@dataclass(frozen=True)
class Sizes:
    """How much is run.

    Attributes:
        suite: "demo", or a file.
        direct: Tasks answered from one picture.
        agentic: Tasks played with tools.
        epochs: Runs of each of these.
        alike: Tasks played twice through the wire and in this process, and compared.
        workers: Tables at a time.
        out: Folder; by default a new one.
    """

    suite: tyro.conf.Positional[str] = "demo"
    direct: int = 6
    agentic: int = 2
    epochs: int = 1
    alike: int = 1
    workers: int = 2
    out: Path | None = None


class Trouble:
    """Lets a script answer, except where a draw by the request's number says otherwise.

    The first task's pictures are refused whenever they are sent, so that it stays missing.
    """

    def __init__(self, suite: Suite, script: Script) -> None:
        self.counts: Counter[str] = Counter()
        self._suite, self._script = suite, script
        self._lock = Lock()
        self._killed = 0

    def __call__(self, number: int, body: dict[str, Any]) -> Reply:
        if task_of(body, self._suite) is self._suite.tasks[0]:
            return self._note("picture refused", Reply(status=400))
        draw = random.Random(number).random()
        if draw < 0.02:
            return self._note("time-out", Reply("too late", wait=1.5 * PATIENCE))
        if draw < 0.05:
            return self._note("429", Reply(status=429))
        if draw < 0.08:
            return self._note("500", Reply(status=500))
        if draw < 0.10:
            return self._note("empty reply", Reply(""))
        return self._tools(draw, number, body) if body.get("tools") else self._script(number, body)

    def _tools(self, draw: float, number: int, body: dict[str, Any]) -> Reply:
        if draw < 0.12:
            return self._note("malformed call", Reply(calls=(("push", '{"object_id": '),)))
        if draw < 0.14:
            return self._note("unknown tool", Reply(calls=(("juggle", "{}"),)))
        reply = self._script(number, body)
        if draw < 0.17 and reply.calls:
            more = (("perceive_scene", "{}"), *reply.calls)
            return self._note("two calls in a turn", replace(reply, calls=more))
        if draw < 0.19:
            self._kill_a_table()
        return reply

    def _kill_a_table(self) -> None:
        pool = active_children()
        if pool:
            self._note("table killed", Reply())
            pool[0].kill()

    def _note(self, what: str, reply: Reply) -> Reply:
        with self._lock:
            self.counts[what] += 1
        return reply


def letter_of_hash(suite: Suite) -> Script:
    """Answers in words; the letter has nothing to do with the question."""

    def script(number: int, body: dict[str, Any]) -> Reply:
        task = task_of(body, suite)
        letter = random.Random(task.id).choice(task.options).letter
        return Reply(f"I think so.\nANSWER: {letter}")

    return script


def plan_of(setting: Setting, suite: Suite, out: Path, epochs: int, workers: int) -> ModelRunPlan:
    library = opener()
    cache = cache_folder() / "light"
    return ModelRunPlan(
        setting, suite, suite.tasks, out, library, cache, epochs, workers=workers, called="scripted"
    )


def troubled(plan: ModelRunPlan, script: Script) -> None:
    """Run a plan against a server that fails, then against one that doesn't, and check both."""
    trouble = Trouble(plan.suite, script)
    start = time.monotonic()
    with serving(trouble, keep=False) as server:
        log = run_in(plan, server.url, EpisodeWorkerSetup, max_retries=4, attempt_timeout=PATIENCE)
    whole = len(plan.tasks) * plan.epochs
    records = records_of(plan)
    faults = [fault for it in records if it.participation for fault in it.participation.faults]
    missing = sum(it.end == "fault" for it in records)
    seconds = time.monotonic() - start
    print(f"{plan.setting}: {whole} episodes, {server.requests} requests, {seconds:.0f} s")
    print(f"  went wrong: {dict(trouble.counts)}; noted in records: {dict(noted(faults))}")
    print(f"  with trouble: {len(records)} records, {missing} missing, {metrics_of(log)}")
    check(log.status == "success", "it finishes")
    assert log.results is not None
    check(len(records) == whole == log.results.total_samples, "nothing leaves the denominator")
    check(is_noted(trouble.counts, noted(faults)), "every fault is in a record")
    check(missing >= plan.epochs, "what gets no reply is missing")
    check(metrics_of(log)["macro"] != metrics_of(log)["macro"], "no number while it is missing")
    asked: set[str] = set()

    def told(number: int, body: dict[str, Any]) -> Reply:
        asked.add(task_of(body, plan.suite).id)
        return script(number, body)

    with serving(told, keep=False) as server:
        log = run_in(plan, server.url, EpisodeWorkerSetup)
    again = {it.task for it in records if it.end == "fault"}
    print(f"  then without: {server.requests} requests, {metrics_of(log)}")
    check(asked <= again, "only what was missing is asked again")
    check(all(it.end != "fault" for it in records_of(plan)), "all episodes have an end")
    check(metrics_of(log)["missing"] == 0 <= metrics_of(log)["macro"], "there is a number")


def noted(faults: Sequence[str]) -> Counter[str]:
    """How often each kind of fault is noted in records."""
    found: Counter[str] = Counter()
    for fault in faults:
        server = re.search(r"the server failed (?:once|(\d+) times)", fault)
        if server:
            found["server"] += int(server[1] or 1)
        elif fault.endswith(": empty"):
            found["empty"] += 1
        elif "push was called" in fault:
            found["malformed"] += 1
        elif "process" in fault:
            found["table"] += 1
        else:
            found["other"] += 1
    return found


def is_noted(caused: Mapping[str, int], noted: Mapping[str, int]) -> bool:
    """Whether records tell of every fault that the server caused.

    An unknown tool and two calls in a turn are steps, not faults. Who was at a killed table isn't
    known: nobody may have been.
    """
    server = ("time-out", "429", "500", "picture refused")
    return (
        noted["server"] == sum(caused[question_type] for question_type in server)
        and noted["empty"] == caused["empty reply"]
        and noted["malformed"] == caused["malformed call"]
        and noted["table"] <= caused["table killed"]
    )


def alike(suite: Suite, out: Path) -> None:
    """Compare a policy's records through the wire with those of the same policy in here.

    The hand errs, otherwise in each of two runs: the wire has to carry noise and run as well.
    """
    plan = replace(plan_of("agentic", suite, out, 2, 1), noise=NOISES["paper"])
    things, runs = everything(), [(task, run) for task in suite.tasks for run in range(2)]
    with Renderer(plan.cache) as renderer:
        here = {(task.id, run): played(task, run, things, renderer) for task, run in runs}
        with serving(Policy("scripted", suite, things, renderer), keep=False) as server:
            log = run_in(plan, server.url, EpisodeWorkerSetup)
    there = {(it.task, it.run): it for it in records_of(plan)}
    same = sum(
        line_of(replace(there[key], participation=None), timed=False)
        == line_of(record, timed=False)
        for key, record in here.items()
    )
    apart = sum(here[it.id, 0].scenes != here[it.id, 1].scenes for it in suite.tasks)
    print(f"alike: in {apart} of {len(suite.tasks)} tasks the hand's luck made two runs differ")
    turns = sum(len(it.steps) for it in here.values())
    print(f"alike: {same} of {len(here)} records are the same bytes, {turns} turns; {log.status}")
    check(same == len(here), "the wire changes nothing")


def played(task: Task, run: int, things: Any, renderer: Renderer) -> EpisodeRecord:
    agent = agent_in_run_0("scripted", task, run, things, renderer)
    return play(task, agent, "scripted", things, renderer, Circumstances(run, NOISES["paper"]))


def records_of(plan: ModelRunPlan) -> list[EpisodeRecord]:
    return standing(in_order(read_records(plan.out / RECORDS), plan.suite))


def check(true: bool, what: str) -> None:
    if not true:
        sys.exit(f"NOT SO: {what}")
    print(f"  {what}: yes")


def main(sizes: Sizes) -> None:
    out = sizes.out or Path(mkdtemp(prefix="probe-seats-"))
    suite = find_suite(sizes.suite)
    parts: Mapping[str, int] = {
        name: getattr(sizes, name) for name in ("direct", "agentic", "alike")
    }
    some = {
        name: selection(suite, spaced(suite.tasks, count), f"{suite.name}-{name}")
        for name, count in parts.items()
        if count
    }
    if "direct" in some:
        plan = plan_of("direct", some["direct"], out / "direct", 1, sizes.workers)
        troubled(plan, letter_of_hash(plan.suite))
    if "agentic" in some:
        plan = plan_of("agentic", some["agentic"], out / "agentic", sizes.epochs, sizes.workers)
        with Renderer(plan.cache) as renderer:
            troubled(plan, Policy("scripted", plan.suite, everything(), renderer))
    if "alike" in some:
        alike(some["alike"], out / "alike")
    print(f"Records are in {out}.")


if __name__ == "__main__":
    main(tyro.cli(Sizes))
