"""A session without a protocol: order, and what is left in the folder."""

import threading
import time
from functools import partial
from pathlib import Path

import pytest

from interfaces.painted import open_episode
from probe.episodes.episode import FAILED, Episode
from probe.episodes.files import read_records
from probe.episodes.turns import Call, Turn
from probe.errors import NoGraphicsDriver, OutputFailed
from probe.interfaces.session import NO_TABLE, Session

LOOK = Call.of("perceive_scene")
FIND = Call.of("find_object", {"description": "white ball"})
GRASP = Call.of("grasp_and_remove", {"object_id": "object_1"})
ANSWER = Call.of("answer_question", {"choice": "B"})


def kept(out: Path):
    path = out / "records.jsonl"
    return read_records(path) if path.exists() else []


def test_an_answer_is_on_disk_when_it_is_confirmed(tmp_path):
    session = Session(open_episode, tmp_path)
    told = [session.call(call) for call in (LOOK, FIND, GRASP, ANSWER)]
    assert told[-1].result().ended
    (record,) = kept(tmp_path)
    assert record.end == "answered" and record.answer and record.answer.choice == "B"
    assert [step.call for step in record.steps] == [LOOK, FIND, GRASP, ANSWER]
    over = session.call(LOOK).result()
    assert over.status == "refused" and "has ended" in over.text
    session.close()
    assert kept(tmp_path) == [record]


def test_who_leaves_early_leaves_an_honest_record(tmp_path):
    session = Session(open_episode, tmp_path)
    session.call(LOOK).result()
    session.close()
    (record,) = kept(tmp_path)
    assert record.end == "stopped" and record.answer is None and len(record.steps) == 1


def test_who_never_calls_leaves_none(tmp_path):
    session = Session(open_episode, tmp_path)
    assert session.first_picture().result().shape == (1024, 1024, 3)
    session.close()
    assert kept(tmp_path) == []


def test_a_call_under_way_is_not_waited_for(tmp_path):
    session = Session(open_episode, tmp_path)
    session.call(FIND).result()
    grasp, waiting = session.call(GRASP), session.call(LOOK)
    while not grasp.running():
        time.sleep(0.01)
    session.leave()
    (record,) = kept(tmp_path)
    assert [step.call for step in record.steps] == [FIND] and not grasp.done()
    session.close()
    assert grasp.done() and waiting.cancelled()
    assert kept(tmp_path) == [record]


def test_a_record_is_of_the_run_that_was_played_whoever_writes_first(tmp_path):
    sessions = [Session(partial(open_episode, run), tmp_path) for run in (5, 0, 7, 2)]
    for session in sessions:
        session.call(LOOK).result()
    threads = [threading.Thread(target=session.close) for session in sessions]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert sorted(record.run for record in kept(tmp_path)) == [0, 2, 5, 7]
    assert [path.name for path in tmp_path.iterdir()] == ["records.jsonl"]


def test_without_a_table_calls_say_so(tmp_path):
    def fail() -> Episode:
        raise NoGraphicsDriver("secret_mug_77 can't be drawn")

    session = Session(fail, tmp_path)
    assert session.call(LOOK).result().text == NO_TABLE
    with pytest.raises(LookupError):
        session.first_picture().result()
    with pytest.raises(NoGraphicsDriver):
        session.close()
    assert kept(tmp_path) == []


def test_a_mistake_of_ours_is_recorded_and_not_told(tmp_path, monkeypatch):
    def stumble(self: Episode, call: Call) -> Turn:
        raise ZeroDivisionError("secret_mug_77")

    monkeypatch.setattr(Episode, "step", stumble)
    session = Session(open_episode, tmp_path)
    assert session.call(LOOK).result().text == FAILED
    (record,) = kept(tmp_path)
    assert record.end == "fault" and record.fault == "ZeroDivisionError: secret_mug_77"
    session.close()


def test_a_record_that_cannot_be_written_is_reported(tmp_path, monkeypatch):
    def full(path: Path, line: bytes) -> None:
        raise OutputFailed(path, "No space left on device")

    monkeypatch.setattr("probe.interfaces.session.add_line", full)
    session = Session(open_episode, tmp_path)
    assert session.call(ANSWER).result().ended
    with pytest.raises(OutputFailed, match="No space left"):
        session.close()
