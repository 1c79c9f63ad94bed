"""Numbers of runs that several processes claim at once."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import pytest

from probe.episodes.claimed_run import claimed_run
from probe.episodes.files import append_record
from probe.episodes.folder import RECORDS, SUITE, start_folder
from probe.episodes.participation import Participation
from probe.episodes.record import EpisodeRecord
from probe.errors import BadData, OutputFailed
from probe.tasks.suite_file import demo_suite

HOLDS = """
import sys
from pathlib import Path
from probe.episodes.claimed_run import claimed_run

with claimed_run(Path(sys.argv[1]), "t-1", "fixed") as run:
    print(run, flush=True)
    sys.stdin.read()
"""


@pytest.fixture
def out(tmp_path: Path) -> Path:
    start_folder(tmp_path, demo_suite())
    return tmp_path


def test_the_next_run_of_an_agent_at_a_task_is_claimed(
    out: Path, play: Callable[[], EpisodeRecord]
) -> None:
    record = play()
    for number in (0, 1, 3):
        append_record(out / RECORDS, replace(record, run=number))
    spoken = replace(record, run=2, participation=Participation("direct"))
    append_record(out / RECORDS, spoken)
    claims = claimed_run(out, "t-1", "fixed"), claimed_run(out, "t-1", "b")
    with claims[0] as run, claims[1] as others, claimed_run(out, "t-2", "fixed") as elsewhere:
        assert (run, others, elsewhere) == (2, 0, 0)


def test_a_number_is_claimed_once_and_free_again_if_no_record_came_of_it(out: Path) -> None:
    with claimed_run(out, "t-1", "a") as first, claimed_run(out, "t-1", "a") as second:
        assert (first, second) == (0, 1)
    with claimed_run(out, "t-1", "a") as again:
        assert again == 0
    assert [path.name for path in out.iterdir()] == [SUITE]


def test_the_number_of_a_fault_is_played_again(
    out: Path, play: Callable[[], EpisodeRecord]
) -> None:
    append_record(out / RECORDS, replace(play(), run=0, end="fault", fault="gone", answer=None))
    with claimed_run(out, "t-1", "fixed") as run:
        assert run == 0


def test_a_process_that_is_killed_gives_its_number_back(out: Path) -> None:
    pipe = subprocess.PIPE
    with subprocess.Popen(
        [sys.executable, "-c", HOLDS, str(out)], stdin=pipe, stdout=pipe, text=True
    ) as other:
        assert other.stdout is not None and other.stdout.readline() == "0\n"
        with claimed_run(out, "t-1", "fixed") as run:
            assert run == 1
        other.kill()
    with claimed_run(out, "t-1", "fixed") as run:
        assert run == 0
    assert [path.name for path in out.iterdir()] == [SUITE]


def test_what_cannot_be_read_or_written_is_named(out: Path) -> None:
    (out / RECORDS).write_text('{"version":')
    with pytest.raises(BadData, match=r"records.jsonl, line 1"), claimed_run(out, "t-1", "a"):
        pass
    nowhere = out / "nowhere"
    with pytest.raises(OutputFailed, match="nowhere"), claimed_run(nowhere, "t-1", "a"):
        pass
