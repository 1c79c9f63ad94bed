"""The log: lines that hang together, and what is made of one that broke off."""

from __future__ import annotations

import hashlib
import json
from pathlib import Path

import pytest

from probe.checksum import with_sum
from probe.errors import BadData
from probe.runs.session.events import Begun, Ended, Event, Lost, Opened, Reasoned, Sealed
from probe.runs.session.log import LOG, SessionLog, begun_in, read_log
from probe.runs.session.order import Slot
from probe.runs.session.plan import SessionPlan
from probe.runs.session.seal import seal_of, truth_of
from probe.runs.session.standing import STOPPED, repair_of, state_of

PLAN = SessionPlan(suite="demo", tasks=("a",), agents=("random",), seed=0, operator="Jana")
BEGUN = Begun(plan=PLAN, agents=("random",), suite="0" * 64)
SLOT = Slot("a", 0, 1, "random")
SEALED = Sealed(of=SLOT.key, seal="s")
REASONED = Reasoned(of=SLOT.key, words="It fell.")


def ended(verdict: str = "right", record: str | None = "r") -> Ended:
    opened = Opened(answer="A", note="", salt="1")
    return Ended.model_validate(
        {"of": SLOT.key, "verdict": verdict, "record": record, "opened": opened}
    )


def test_a_seal_is_what_anybody_can_compute() -> None:
    truth = truth_of("B", "the mug faces left")
    said = f'{{"answer":"B","note":"the mug faces left","salt":"{truth.salt}"}}'
    assert seal_of(truth) == hashlib.sha256(said.encode()).hexdigest()
    assert len(truth.salt) == 32 and truth_of("B", "").salt != truth.salt


def test_events_are_read_as_they_were_written(tmp_path: Path) -> None:
    log = SessionLog(tmp_path)
    events: list[Event] = [BEGUN, SEALED, ended(), REASONED]
    for event in events:
        log.add(event)
    assert read_log(tmp_path) == SessionLog(tmp_path).events == events
    assert begun_in(events, tmp_path) == BEGUN
    with pytest.raises(BadData, match="doesn't start with a session"):
        begun_in([SEALED], tmp_path)


def test_a_line_that_was_cut_off_harms_nothing(tmp_path: Path) -> None:
    log = SessionLog(tmp_path)
    for event in (BEGUN, SEALED):
        log.add(event)
    path = tmp_path / LOG
    path.write_bytes(path.read_bytes()[:-7])
    assert read_log(tmp_path) == [BEGUN]
    again = SessionLog(tmp_path)
    assert again.cut and again.cut.exists()
    again.add(SEALED)
    assert read_log(tmp_path) == [BEGUN, SEALED]


@pytest.mark.parametrize("act", ["change", "leave out", "swap"])
def test_a_log_that_was_tampered_with_is_refused(tmp_path: Path, act: str) -> None:
    log = SessionLog(tmp_path)
    for event in (BEGUN, SEALED, ended(), REASONED):
        log.add(event)
    path = tmp_path / LOG
    lines = path.read_bytes().splitlines(keepends=True)
    if act == "change":
        # Its own checksum is put right, so that only the next line can tell.
        changed = json.loads(lines[2])
        changed["event"]["verdict"] = "wrong"
        del changed["sum"]
        lines[2] = with_sum(json.dumps(changed, separators=(",", ":")).encode())
    elif act == "leave out":
        del lines[2]
    else:
        lines[1:3] = lines[2:0:-1]
    path.write_bytes(b"".join(lines))
    with pytest.raises(BadData, match="doesn't follow the line before it"):
        read_log(tmp_path)


def test_what_broke_off_is_ended_and_counts_as_interrupted() -> None:
    empty = state_of(SLOT, [BEGUN])
    assert repair_of(SLOT, empty, set()) is None and empty.settled and not empty.over
    # In the midst of an episode; between its end and its record; before its reason; all well.
    midst = state_of(SLOT, [BEGUN, SEALED])
    repair = repair_of(SLOT, midst, set())
    assert isinstance(repair, Ended) and repair.fault == STOPPED
    bare = state_of(SLOT, [BEGUN, SEALED, ended()])
    assert repair_of(SLOT, bare, set()) == Lost(of=SLOT.key)
    assert repair_of(SLOT, bare, {"r"}) is None and not bare.settled
    lost = state_of(SLOT, [BEGUN, SEALED, ended(), Lost(of=SLOT.key), REASONED])
    assert lost.result is None and lost.interrupted == 1 and lost.settled and not lost.over
    well = state_of(SLOT, [BEGUN, SEALED, ended(), REASONED])
    assert well.over and well.result == ended() and well.interrupted == 0
    assert repair_of(SLOT, well, set()) is None


def test_three_interrupted_tries_are_enough() -> None:
    events: list[Event] = [BEGUN]
    for tries in (1, 2, 3):
        events += [SEALED, ended("interrupted"), REASONED]
        state = state_of(SLOT, events)
        assert (state.tries, state.interrupted, state.over) == (tries, tries, tries == 3)
    events = events[:-3] + [SEALED, ended("wrong"), REASONED]
    assert state_of(SLOT, events).result == ended("wrong")
    assert state_of(SLOT, events).interrupted == 2
