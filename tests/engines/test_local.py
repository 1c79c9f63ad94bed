"""Workers that die at the worst moments, in real processes."""

import multiprocessing
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import psutil
import pytest

from crew_jobs import Bench
from probe.engines.local import LocalEngine
from probe.engines.plan import LostUnit, WorkPlan
from probe.errors import WorkerDied
from probe.processes.serving import WorkerUnfit

HERE = Path(__file__).resolve().parents[1]

DRIVER = """
import sys
from pathlib import Path
from crew_jobs import Bench
from probe.engines.local import LocalEngine
from probe.engines.plan import WorkPlan
if __name__ == "__main__":
    plan = WorkPlan("bench", Bench(Path(sys.argv[1])), ["a", "long"], str)
    for job, result in LocalEngine(2).carry_out(plan):
        print(job, flush=True)
"""


def carry_out(bench: Bench, jobs: list[str], workers: int):
    return LocalEngine(workers).carry_out(WorkPlan("bench", bench, jobs, str))


def pids(notes: Path, job: str) -> list[int]:
    file = notes / f"begun-{job}"
    return [int(pid) for pid in file.read_text().split()] if file.exists() else []


def seen(check, seconds: float = 20.0) -> bool:
    end = time.monotonic() + seconds
    while not check() and time.monotonic() < end:
        time.sleep(0.05)
    return check()


@pytest.mark.parametrize("workers", [1, 2])
def test_each_job_is_done_once(tmp_path, workers):
    jobs = [f"job {number}" for number in range(5)]
    results = dict(carry_out(Bench(tmp_path), jobs, workers))
    assert results == {job: f"{job} done".encode() for job in jobs}
    assert all(len(pids(tmp_path, job)) == 1 for job in jobs)
    assert len(list(tmp_path.glob("closed-*"))) == workers
    assert not multiprocessing.active_children()


def test_a_full_disk_stops_the_work_and_is_named(tmp_path):
    with pytest.raises(WorkerUnfit, match=r"/cache/x\.npz: No space left on device"):
        dict(carry_out(Bench(tmp_path), ["roomy", "a"], 1))
    assert not pids(tmp_path, "a") and not multiprocessing.active_children()


@pytest.mark.parametrize("workers", [1, 2])
def test_a_killed_worker_costs_one_job_which_is_begun_anew(tmp_path, workers):
    results = dict(carry_out(Bench(tmp_path), ["unlucky", "a", "b", "c"], workers))
    assert results == {job: f"{job} done".encode() for job in ("unlucky", "a", "b", "c")}
    first, second = pids(tmp_path, "unlucky")
    assert first != second
    assert all(len(pids(tmp_path, job)) == 1 for job in ("a", "b", "c"))


@pytest.mark.parametrize(
    ("job", "words"), [("deadly", "killed by signal 9 (SIGKILL)"), ("leaving", "status 3")]
)
def test_a_job_that_kills_thrice_is_lost_in_words(tmp_path, job, words):
    results = dict(carry_out(Bench(tmp_path), [job, "a"], 1))
    assert results["a"] == b"a done"
    lost = results[job]
    assert isinstance(lost, LostUnit) and words in lost.reason and "3 times" in lost.reason
    assert len(pids(tmp_path, job)) == 3


def test_a_workplace_that_cannot_be_set_up_is_told(tmp_path):
    with pytest.raises(WorkerUnfit, match="no tools here"):
        list(carry_out(Bench(tmp_path, unfit=True), ["a"], 1))


def test_workers_that_die_before_they_begin_end_the_work(tmp_path):
    with pytest.raises(WorkerDied, match="setting up"):
        list(carry_out(Bench(tmp_path, stillborn=True), ["a", "b"], 2))
    assert not multiprocessing.active_children()


def test_closing_ends_workers_at_once(tmp_path):
    results = carry_out(Bench(tmp_path), ["a", "long"], 2)
    assert next(results)[0] == "a"
    assert seen(lambda: pids(tmp_path, "long") != [])
    results.close()
    assert not psutil.pid_exists(pids(tmp_path, "long")[0])


@pytest.mark.parametrize("how", [signal.SIGKILL, signal.SIGTERM])
def test_workers_end_with_their_parent(tmp_path, how):
    script = tmp_path / "driver.py"
    script.write_text(DRIVER)
    paths = os.pathsep.join([str(HERE), str(HERE.parent / "src")])
    parent = subprocess.Popen(
        [sys.executable, str(script), str(tmp_path)], env=os.environ | {"PYTHONPATH": paths}
    )
    assert seen(lambda: pids(tmp_path, "long") != [])
    parent.send_signal(how)
    parent.wait()
    assert seen(lambda: not psutil.pid_exists(pids(tmp_path, "long")[0]))
