"""A person's seat without a protocol: faults, full disks, what is left."""

import time
from dataclasses import replace
from pathlib import Path

import pytest

from interfaces.human.painted_hall import SUITE, Room, hall_in
from probe.episodes.episode import FAILED, Episode
from probe.episodes.files import read_records, write_records
from probe.episodes.turns import Call
from probe.errors import BadData, NoGraphicsDriver, OutputFailed
from probe.interfaces.human.names import file_of

LOOK = Call.of("perceive_scene")
ANSWER = Call.of("answer_question", {"choice": "B", "point": [620, 480]})


def settled(seat):
    limit = time.monotonic() + 20
    while seat.state.doing:
        assert time.monotonic() < limit
        time.sleep(0.005)
    return seat.state


@pytest.fixture
def sessions(tmp_path):
    sessions = hall_in(tmp_path, Room())
    yield sessions
    sessions.close()


def test_a_mistake_of_ours_is_recorded_and_the_question_asked_again(
    sessions, tmp_path, monkeypatch
):
    seat = sessions.enter("Ada")
    settled(seat)

    def stumble(self: Episode, call: Call):
        raise ZeroDivisionError("secret_mug_77")

    with monkeypatch.context() as broken:
        broken.setattr(Episode, "step", stumble)
        seat.call(LOOK, 0)
        state = settled(seat)
    assert state.over and state.entries[-1].text == FAILED
    (record,) = read_records(tmp_path / "records.jsonl")
    assert record.end == "fault" and record.fault == "ZeroDivisionError: secret_mug_77"
    seat.go_on()
    assert settled(seat).number == 1
    seat.call(ANSWER, 0)
    settled(seat)
    assert [(r.end, r.run) for r in read_records(tmp_path / "records.jsonl")] == [
        ("fault", 0),
        ("answered", 0),
    ]


def test_without_a_table_the_person_is_told_and_may_try_again(tmp_path, monkeypatch):
    room = Room()
    sessions = hall_in(tmp_path, room)

    def fail(*said: object):
        raise NoGraphicsDriver("secret_mug_77 can't be drawn")

    with monkeypatch.context() as broken:
        broken.setattr(room, "set_table", fail)
        state = settled(sessions.enter("Ada"))
        assert state.trouble and "secret" not in state.trouble and state.number == 0
    sessions.close()
    sessions = hall_in(tmp_path, room)
    assert settled(sessions.enter("Ada")).trouble is None
    sessions.close()


def test_an_answer_that_cannot_be_written_is_written_later(sessions, tmp_path, monkeypatch):
    seat = sessions.enter("Ada")
    settled(seat)

    def full(path: Path, line: bytes):
        raise OutputFailed(path, "No space left on device")

    with monkeypatch.context() as broken:
        broken.setattr("probe.interfaces.human.session_store.add_line", full)
        seat.call(ANSWER, 0)
        state = settled(seat)
        assert state.over and state.done == 0 and "disk is full" in (state.trouble or "")
    seat.go_on()
    state = settled(seat)
    assert (state.number, state.done, state.trouble) == (2, 1, None)
    assert len(read_records(tmp_path / "records.jsonl")) == 1


def test_a_table_that_comes_out_otherwise_counts_as_our_failure(tmp_path):
    sessions = hall_in(tmp_path, Room())
    seat = sessions.enter("Ada")
    settled(seat)
    seat.call(LOOK, 0)
    settled(seat)
    sessions.close()
    path = tmp_path / "unfinished" / file_of("Ada")
    (record,) = read_records(path)
    step = replace(record.steps[0], text="something else")
    write_records(path, [replace(record, steps=(step,))])
    sessions = hall_in(tmp_path, Room())
    seat = sessions.enter("Ada")
    state = settled(seat)
    assert state.trouble and "as you left it" in state.trouble
    (fault,) = read_records(tmp_path / "records.jsonl")
    assert fault.end == "fault" and "step 1: text" in (fault.fault or "")
    seat.go_on()
    state = settled(seat)
    assert (state.number, state.entries, state.trouble) == (1, (), None)
    sessions.close()


def test_the_next_table_is_set_while_a_person_is_at_the_one_before(tmp_path):
    room = Room()
    sessions = hall_in(tmp_path, room)
    seat = sessions.enter("Ada")
    settled(seat)
    wait_until(lambda: room.set == 2)
    room.gate.clear()  # nothing more can be set
    seat.call(ANSWER, 0)
    settled(seat)
    time.sleep(1.0)
    seat.go_on()
    assert settled(seat).number == 2
    seat.stop(0)
    settled(seat)
    room.gate.set()
    sessions.close()
    assert room.set == 2 and room.open == 0


def test_time_counts_from_when_a_prepared_table_is_shown(tmp_path):
    room = Room()
    sessions = hall_in(tmp_path, room)
    seat = sessions.enter("Ada")
    settled(seat)
    wait_until(lambda: room.set == 2)
    time.sleep(2.0)
    seat.call(ANSWER, 0)
    settled(seat)
    seat.go_on()
    settled(seat)
    seat.call(Call.of("answer_question", {"choice": "A"}), 0)
    settled(seat)
    sessions.close()
    first, second = read_records(tmp_path / "records.jsonl")
    assert first.seconds.agent[0] >= 2.0 > second.seconds.agent[0]


def test_a_table_that_could_not_be_prepared_is_set_when_it_is_needed(tmp_path, monkeypatch):
    room = Room()
    sessions = hall_in(tmp_path, room)
    tries: list[str] = []

    def set_table(task, name, run):
        tries.append(task.id)
        if tries.count(task.id) == 1 and task is not SUITE.tasks[0]:
            raise NoGraphicsDriver("secret_mug_77 can't be drawn")
        return Room.set_table(room, task, name, run)

    monkeypatch.setattr(room, "set_table", set_table)
    seat = sessions.enter("Ada")
    settled(seat)
    seat.call(ANSWER, 0)
    settled(seat)
    seat.go_on()
    state = settled(seat)
    assert state.trouble and "secret" not in state.trouble
    seat.go_on()
    assert settled(seat).number == 2 and seat.state.trouble is None
    sessions.close()


def wait_until(holds):
    limit = time.monotonic() + 20
    while not holds():
        assert time.monotonic() < limit
        time.sleep(0.005)


def test_a_folder_of_agents_is_refused(tmp_path):
    hall_in(tmp_path, Room()).close()
    (tmp_path / "arm").write_text("agentic\n")
    with pytest.raises(BadData, match="Choose another folder"):
        hall_in(tmp_path, Room())
