import threading
import time
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from pathlib import Path

import pytest

from probe.episodes import folder
from probe.episodes.files import append_record
from probe.episodes.folder import (
    RECORDS,
    claim_setting,
    in_order,
    occupied,
    setting_of_folder,
    standing,
    start_folder,
)
from probe.errors import BadData, OutputFailed
from probe.tasks.suite_file import demo_suite, write_suite


def test_a_folder_belongs_to_one_suite(tmp_path):
    suite = demo_suite()
    start_folder(tmp_path, suite)
    start_folder(tmp_path, suite)
    with pytest.raises(BadData, match="another suite: 6 tasks of demo, not 1. Choose another"):
        start_folder(tmp_path, replace(suite, tasks=suite.tasks[:1]))


def test_who_is_at_work_keeps_others_out(tmp_path):
    suite, words = demo_suite(), "another run is at work there"
    with occupied(tmp_path, suite), pytest.raises(BadData, match=words), occupied(tmp_path, suite):
        pass
    with occupied(tmp_path, suite):
        pass


def test_of_two_that_begin_a_folder_at_once_one_is_let_in(tmp_path, monkeypatch):
    both, held = threading.Barrier(2), threading.Barrier(2)

    def slowly(path, suite):
        time.sleep(0.2)
        write_suite(path, suite)

    def begin(_: int) -> bool:
        both.wait(10)
        try:
            with occupied(tmp_path / "run", demo_suite()):
                held.wait(10)
                return True
        except BadData:
            held.wait(10)
            return False

    monkeypatch.setattr(folder, "write_suite", slowly)
    with ThreadPoolExecutor(2) as threads:
        assert sorted(threads.map(begin, range(2))) == [False, True]


def test_records_that_cannot_be_read_are_found_at_the_start(tmp_path):
    (tmp_path / "records.jsonl").write_text('{"version":')
    with pytest.raises(BadData, match=r"records.jsonl, line 1"):
        start_folder(tmp_path, demo_suite())


def test_the_order_is_that_of_tasks_however_records_were_written(play):
    suite, record = demo_suite(), play()
    first, second = (replace(record, task=task.id) for task in suite.tasks[:2])
    late = replace(first, run=3)
    assert in_order([second, late, first], suite) == [first, late, second]
    assert in_order([first, second, late], suite) == [first, late, second]


def test_a_fault_gives_way_to_its_repetition(play):
    suite = demo_suite()
    good = replace(play(), task=suite.tasks[0].id)
    one, other = (replace(good, end="fault", fault=words) for words in ("early", "late"))
    assert in_order([one, good, other], suite) == [one, other, good]
    assert standing(in_order([one, good, other], suite)) == [good]
    assert standing([one, other]) == [other]


def test_a_folder_that_cannot_be_made_is_named():
    with pytest.raises(OutputFailed, match="/proc/nowhere"):
        start_folder(Path("/proc/nowhere"), demo_suite())


def test_a_folder_that_claims_an_arm_keeps_it(tmp_path, play):
    start_folder(tmp_path, demo_suite())
    assert setting_of_folder(tmp_path) is None
    claim_setting(tmp_path, "human")
    append_record(tmp_path / RECORDS, play())
    claim_setting(tmp_path, "human")
    assert setting_of_folder(tmp_path) == "human"
    with pytest.raises(BadData, match="of the setting human. Choose another folder"):
        claim_setting(tmp_path, "agentic")


def test_agents_are_not_let_into_a_folder_of_people(tmp_path):
    start_folder(tmp_path, demo_suite())
    claim_setting(tmp_path, "human")
    words = "is kept for records of the setting human. Choose another folder"
    with pytest.raises(BadData, match=words):
        start_folder(tmp_path, demo_suite())


def test_a_folder_with_records_of_others_can_claim_no_arm(tmp_path, play):
    append_record(tmp_path / RECORDS, play())
    with pytest.raises(BadData, match="others have records there"):
        claim_setting(tmp_path, "human")


def test_records_of_other_tools_get_no_company(tmp_path, play):
    append_record(tmp_path / RECORDS, replace(play(), tools=1))
    with pytest.raises(BadData, match="was run with version 1 of the tools, and this release"):
        start_folder(tmp_path, demo_suite())
    assert [path.name for path in tmp_path.iterdir()] == [RECORDS]
