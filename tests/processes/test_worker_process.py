"""Real processes that die, hang and end, and what is told of them."""

import multiprocessing
import signal
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import psutil
import pytest

from crew_jobs import Bench
from probe.processes.serving import WorkerReady, WorkerUnfit
from probe.processes.starting import spawn
from probe.processes.worker_process import ChildProcess, WorkerProcess, WorkerSilent, death

LONG = [sys.executable, "-c", "import time; time.sleep(60)"]


@pytest.fixture
def worker(tmp_path: Path) -> Iterator[WorkerProcess]:
    """A worker that is ready."""
    worker = spawn(Bench(tmp_path))
    assert worker.receive(60.0) == WorkerReady()
    yield worker
    worker.kill()
    assert not multiprocessing.active_children()


def test_jobs_are_answered_in_turn(worker: WorkerProcess):
    for job in ("a", "b"):
        worker.send(job)
        assert worker.receive(60.0) == f"{job} done".encode()


@pytest.mark.parametrize(
    ("job", "words"),
    [("deadly", "was killed by signal 9 (SIGKILL)"), ("leaving", "ended with status 3")],
)
def test_a_death_is_told_in_words(worker: WorkerProcess, job: str, words: str):
    worker.send(job)
    with pytest.raises(WorkerSilent) as told:
        worker.receive()
    assert str(told.value) == words
    with pytest.raises(WorkerSilent) as told:
        worker.send("a")
    assert str(told.value) == words


def test_one_that_says_nothing_is_told_after_its_time(worker: WorkerProcess):
    worker.send("long")
    with pytest.raises(WorkerSilent, match=r"^said nothing for 0\.2 seconds$"):
        worker.receive(0.2)
    assert worker.exit_code(0.0) is None


def test_another_pipe_is_heard_when_its_own_is_silent(worker: WorkerProcess):
    ours, theirs = multiprocessing.Pipe()
    theirs.send("aside")
    assert worker.receive(60.0, ours) == "aside"
    worker.send("a")
    assert worker.pipe.poll(60.0)
    theirs.send("later")
    assert worker.receive(60.0, ours) == b"a done"


def test_an_idle_one_ends_when_its_pipe_is_closed(worker: WorkerProcess, tmp_path: Path):
    worker.end(60.0)
    assert worker.exit_code() == 0
    assert (tmp_path / f"closed-{worker.pid}").exists()


def test_a_busy_one_is_killed_after_its_time(worker: WorkerProcess):
    worker.send("long")
    worker.end(0.1)
    assert worker.exit_code() == -signal.SIGKILL


def test_what_cannot_be_set_up_says_why(tmp_path: Path):
    worker = spawn(Bench(tmp_path, unfit=True))
    first = worker.receive(60.0)
    assert isinstance(first, WorkerReady)
    with pytest.raises(WorkerUnfit, match="no tools here"):
        first.require()
    worker.end()


def test_a_session_is_killed_with_its_leader():
    code = f"import subprocess as s; p = s.Popen({LONG}); print(p.pid, flush=True); p.wait()"
    with subprocess.Popen(
        [sys.executable, "-c", code], start_new_session=True, stdout=subprocess.PIPE
    ) as started:
        assert started.stdout is not None
        grandchild = psutil.Process(int(started.stdout.readline()))
        process = ChildProcess(started, leads_session=True)
        process.end(0.1)
        assert process.exit_code() == -signal.SIGKILL
        psutil.wait_procs([grandchild], timeout=20.0)
        assert not grandchild.is_running() or grandchild.status() == psutil.STATUS_ZOMBIE


def test_one_that_is_asked_to_end_does():
    process = ChildProcess(subprocess.Popen(LONG))
    process.ask_to_end()
    process.end(20.0)
    assert death(process.exit_code()) == "was killed by signal 15 (SIGTERM)"
    process.ask_to_end()
    assert process.exit_code() == -signal.SIGTERM
