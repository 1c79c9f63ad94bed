"""`probe run` with real physics, killed, out of disk, or in several processes: the same records."""

from __future__ import annotations

import resource
import signal
import subprocess
import sys
import time
from dataclasses import dataclass
from pathlib import Path

import psutil
import pytest

from probe.cli.merge import merge
from probe.episodes.files import line_of, read_records
from probe.episodes.folder import RECORDS, SUITE
from probe.tasks.suite import Suite
from probe.tasks.suite_file import demo_suite, write_suite

PATIENCE = 300.0
TASKS = 2
PAGE = 4096
"""Bytes; what files take of a small file system is a multiple of it."""


def command(suite: Path, out: Path, *more: str) -> list[str]:
    return [sys.executable, "-m", "probe", "run", str(suite), "--out", str(out), *more]


def probe_run(suite: Path, out: Path, *more: str, **popen) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        command(suite, out, *more), capture_output=True, text=True, timeout=PATIENCE, **popen
    )


def timeless(out: Path) -> list[bytes]:
    """Records without their timing, in an order of their own."""
    return sorted(line_of(record, timed=False) for record in read_records(out / RECORDS))


def first_worker(process: subprocess.Popen) -> psutil.Process:
    """The first process that a run has started to run episodes in."""
    end = time.monotonic() + PATIENCE
    while time.monotonic() < end:
        for child in psutil.Process(process.pid).children():
            if "spawn_main" in words_of(child) and at_work(child):
                return child
        time.sleep(0.1)
    raise AssertionError("no worker came to work")


def at_work(worker: psutil.Process) -> bool:
    """It has a renderer, so it is at an episode."""
    return any("probe.render.worker" in words_of(it) for it in worker.children())


def words_of(process: psutil.Process) -> str:
    """Its command line; none once it has ended."""
    try:
        return " ".join(process.cmdline())
    except psutil.NoSuchProcess:
        return ""


def kill_at_first_record(process: subprocess.Popen, out: Path) -> None:
    """Kill a run as soon as a record is there; fails if it ends before."""
    while not (out / RECORDS).exists():
        assert process.poll() is None
        time.sleep(0.1)
    process.kill()
    process.wait(PATIENCE)


@pytest.fixture(scope="module")
def suite(tmp_path_factory) -> Path:
    whole, path = demo_suite(), tmp_path_factory.mktemp("suite") / "small.json"
    tasks = whole.tasks[:TASKS]
    ids = {placed.object_id for task in tasks for placed in task.scene.objects}
    objects = {id: mark for id, mark in whole.objects.items() if id in ids}
    write_suite(path, Suite("small", tasks, objects))
    return path


@pytest.fixture(scope="module")
def reference(suite, tmp_path_factory) -> Path:
    out = tmp_path_factory.mktemp("reference")
    done = probe_run(suite, out)
    assert done.returncode == 0, done.stderr
    assert f"Records go to {out / RECORDS}" in done.stdout
    assert [record.end for record in read_records(out / RECORDS)] == ["answered"] * TASKS
    return out


@pytest.mark.slow
def test_shards_are_merged_to_the_whole(suite, reference, tmp_path):
    parts = [tmp_path / "0", tmp_path / "1"]
    for number, part in enumerate(parts):
        assert probe_run(suite, part, "--shard", f"{number}/2").returncode == 0
    merge((*parts,), out=tmp_path / "whole")
    assert timeless(tmp_path / "whole") == timeless(reference)
    assert (tmp_path / "whole" / SUITE).read_bytes() == (reference / SUITE).read_bytes()


@pytest.mark.slow
def test_two_workers_of_which_one_is_killed_write_the_same_as_one(suite, reference, tmp_path):
    order = command(suite, tmp_path, "--workers", "2")
    process = subprocess.Popen(order, stdout=subprocess.DEVNULL)
    first_worker(process).kill()
    assert process.wait(PATIENCE) == 0
    assert timeless(tmp_path) == timeless(reference)


@pytest.mark.slow
def test_a_killed_run_is_gone_on_with(suite, reference, tmp_path):
    process = subprocess.Popen(command(suite, tmp_path), stdout=subprocess.DEVNULL)
    kill_at_first_record(process, tmp_path)
    # What a kill in the middle of a write would have left.
    with (tmp_path / RECORDS).open("ab") as file:
        file.write((reference / RECORDS).read_bytes().splitlines()[1][:1000])
    again = probe_run(suite, tmp_path)
    assert again.returncode == 0, again.stderr
    assert "was cut off: moved to" in again.stdout.replace("\n", " ")
    assert len((tmp_path / f"{RECORDS}.cut").read_bytes()) == 1001
    assert timeless(tmp_path) == timeless(reference)


@pytest.mark.slow
def test_ctrl_c_ends_cleanly(suite, reference, tmp_path):
    process = subprocess.Popen(
        command(suite, tmp_path),
        stderr=subprocess.PIPE,
        text=True,
        # Started in the background by a shell, it wouldn't hear of it.
        preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL),
    )
    worker = first_worker(process)
    process.send_signal(signal.SIGINT)
    _, said = process.communicate(timeout=PATIENCE)
    assert process.returncode == 1
    assert "probe: interrupted" in said and "Traceback" not in said
    assert not worker.is_running()
    assert probe_run(suite, tmp_path).returncode == 0
    assert timeless(tmp_path) == timeless(reference)


@dataclass
class Disk:
    """A folder with little room.

    Attributes:
        folder: Where it is.
        limit: Most bytes of a file, instead of a small file system.
    """

    folder: Path
    limit: int | None = None

    @property
    def start(self) -> dict:
        """How a process is started that is to notice."""
        if self.limit is None:
            return {}
        limits = (self.limit, self.limit)
        return {"preexec_fn": lambda: resource.setrlimit(resource.RLIMIT_FSIZE, limits)}

    def widen(self) -> None:
        if self.limit is None:
            subprocess.run(["mount", "-o", "remount,size=64m", str(self.folder)], check=True)


@pytest.fixture
def disk(suite, reference, tmp_path):
    """Room for one record and a little more; where nothing may be mounted, in each file."""
    room = len((reference / RECORDS).read_bytes().splitlines()[0]) + 3000
    folder = tmp_path / "disk"
    folder.mkdir()
    others = [path.stat().st_size for path in reference.iterdir() if path.name != RECORDS]
    size = sum(-(-each // PAGE) * PAGE for each in (room, *others))
    option = ["mount", "-t", "tmpfs", "-o", f"size={size}", "tmpfs", str(folder)]
    if subprocess.run(option, capture_output=True).returncode == 0:
        yield Disk(folder)
        subprocess.run(["umount", str(folder)], check=True)
    else:
        (folder / SUITE).write_bytes((reference / SUITE).read_bytes())
        yield Disk(folder, room)


@pytest.mark.slow
def test_a_full_disk_is_told_and_gone_on_with(suite, reference, disk):
    full = probe_run(suite, disk.folder, **disk.start)
    assert full.returncode == 1
    assert "Free some space or choose another folder" in full.stderr.replace("\n", " ")
    assert "Traceback" not in full.stderr
    kept = read_records(disk.folder / RECORDS)
    assert len(kept) == 1
    disk.widen()
    again = probe_run(suite, disk.folder)
    assert again.returncode == 0, again.stderr
    assert "1 episodes were there already" in again.stdout
    assert timeless(disk.folder) == timeless(reference)
