"""How far a folder's audit has come, on folders made by hand; nothing is replayed."""

from __future__ import annotations

import hashlib
import stat
from dataclasses import replace
from pathlib import Path

import pytest

from forgeries import TASK, honest, write_folder
from probe.audit.audit_file import (
    AUDIT,
    RELEASE,
    AuditDocument,
    AuditProgress,
    ReplayVerdict,
    audit_of,
    earlier,
    hash_of,
    is_foreign,
    keep,
)
from probe.audit.audit_key import key_of, ready_key
from probe.audit.auditing import begin, missing_of
from probe.audit.replaying import unable
from probe.checksum import with_sum, without_sum
from probe.episodes.files import append_record
from probe.episodes.folder import RECORDS, SUITE
from probe.episodes.participation import ModelReply, Participation
from probe.episodes.record import Seconds
from probe.errors import BadData
from probe.files import write_bytes
from probe.tasks.suite import part
from probe.tasks.suite_file import read_suite, write_suite
from run_folders import DEMO

EQUAL, DIFFERS = (
    ReplayVerdict(outcome="equal"),
    ReplayVerdict(outcome="differs", reason="step 3: text"),
)
UNABLE = ReplayVerdict(outcome="not replayable", reason="there is no scan here")
RECORD = honest()
SPEECH = f"ANSWER: {TASK.answer} (100, 200)"


def lines(out: Path) -> list[str]:
    content = (out / RECORDS).read_bytes().split(b"\n")[:-1]
    return [hashlib.sha256(line).hexdigest() for line in content]


@pytest.fixture
def key(tmp_path: Path) -> Path:
    return tmp_path / "own" / "audit.key"


@pytest.fixture
def out(tmp_path: Path, key: Path) -> Path:
    """A folder of two records, of which one has been replayed."""
    out = write_folder(tmp_path, RECORD, replace(RECORD, run=1))
    keep(out, {lines(out)[0]: EQUAL}, results=2, key_file=key)
    return out


def test_nobody_has_audited_a_fresh_folder(tmp_path):
    assert audit_of(write_folder(tmp_path, RECORD), tmp_path / "key").words == "not audited"


def test_an_audit_is_told_by_its_counts(out, key):
    assert audit_of(out, key) == AuditProgress(results=2, equal=1, differ=0, unable=0)
    assert audit_of(out, key).words == "audited: 1 of 2 replayed, all equal"
    keep(out, dict(zip(lines(out), (EQUAL, DIFFERS), strict=True)), results=2, key_file=key)
    words = "audited: 2 of 2 replayed, 1 DIFFER from what is recorded"
    assert audit_of(out, key).words == words
    keep(out, dict(zip(lines(out), (EQUAL, UNABLE), strict=True)), results=2, key_file=key)
    words = "audited: 1 of 2 replayed, all equal; 1 of 2 can't be replayed"
    assert audit_of(out, key).words == words
    keep(out, {lines(out)[1]: UNABLE}, results=2, key_file=key)
    assert audit_of(out, key).words == "not audited; 1 of 2 can't be replayed"


def test_records_that_have_changed_since_are_not_audited(out, key):
    append_record(out / RECORDS, replace(RECORD, agent="bea"))
    assert audit_of(out, key).words.startswith("not audited: records, suite or")
    # What is still there needn't be replayed again.
    assert earlier(out, key) == {lines(out)[0]: EQUAL}


def test_a_suite_that_has_changed_since_begins_an_audit_anew(out, key):
    write_suite(out / SUITE, part(DEMO, next(it for it in DEMO.tasks if it.id == RECORD.task)))
    assert audit_of(out, key).words.startswith("not audited: records, suite or")
    assert earlier(out, key) == {}


def test_another_release_begins_an_audit_anew(out, key, monkeypatch):
    monkeypatch.setattr("probe.audit.audit_file.RELEASE", "9.9.9")
    assert audit_of(out, key).words.startswith("not audited: ") and earlier(out, key) == {}


def test_what_could_not_be_replayed_is_tried_again(out, key):
    keep(out, dict(zip(lines(out), (DIFFERS, UNABLE), strict=True)), results=2, key_file=key)
    assert earlier(out, key) == {lines(out)[0]: DIFFERS}


def test_an_audit_with_a_flipped_bit_is_refused(out, key):
    path = out / AUDIT
    path.write_bytes(path.read_bytes().replace(b'"results": 2', b'"results": 3'))
    with pytest.raises(BadData, match=r"audit\.json: its checksum says .*Delete it and audit"):
        audit_of(out, key)


def test_what_needs_a_model_again_cannot_be_replayed_and_is_counted(tmp_path):
    pointed = Participation("agentic, pointer self", replies=(ModelReply(4),))
    spoken = Participation("direct", replies=(ModelReply(0, SPEECH),))
    in_words = replace(RECORD, steps=(), seconds=Seconds(), participation=spoken)
    fault = replace(
        in_words, run=1, participation=None, answer=None, end="fault", fault="RenderFailed: gone"
    )
    records = (RECORD, replace(RECORD, participation=pointed), in_words, fault)
    audit = begin(
        out := write_folder(tmp_path, *records), read_suite(out / SUITE), tmp_path / "key"
    )
    # A failure of ours claims nothing.
    assert [claim.record for claim in audit.claims] == list(records[:3])
    assert [claim.record for claim in audit.lacking(None)] == [RECORD]
    assert [audit.verdicts[line].reason for line in lines(out)[1:3]] == [
        "perception asked a model (pointer self)",
        "a model answered in words (setting direct)",
    ]


@pytest.mark.parametrize("setting", ["text-only", "text-only, short graphs"])
def test_calls_of_a_model_that_saw_no_picture_can_be_replayed(setting):
    seat = Participation(setting, replies=(ModelReply(4),))
    assert unable(replace(RECORD, participation=seat)) is None


def test_a_sample_is_drawn_by_its_seed(tmp_path):
    records = [honest(task) for task in DEMO.tasks]
    out = write_folder(tmp_path, *records)
    audit = begin(out, read_suite(out / SUITE), tmp_path / "key")
    drawn = {seed: tuple(it.record.task for it in audit.lacking(3, seed)) for seed in range(40)}
    order = [task.id for task in DEMO.tasks]
    for tasks in drawn.values():
        assert len(set(tasks)) == 3 and list(tasks) == sorted(tasks, key=order.index)
    # Of 20 threes 40 draws leave out few, and no record is safe.
    assert len(set(drawn.values())) > 10 and {it for some in drawn.values() for it in some} == {
        *order
    }
    assert audit.lacking(3, 7) == audit.lacking(3, 7)
    assert len(audit.lacking(99)) == len(audit.lacking(None)) == 6
    assert audit.lacking(0) == []


def test_episodes_without_a_result_are_counted(tmp_path):
    one, other = DEMO.tasks[:2]
    fault = replace(honest(other), steps=(), answer=None, end="fault", fault="gone")
    fault = replace(fault, seconds=Seconds(), run=1)
    bea = replace(honest(one), agent="bea", run=2)
    # Two runs of six tasks are ordered of anna; bea has run 2 of one task.
    found = missing_of([honest(one), fault, bea], DEMO, {("anna", ""): 2})
    assert found == (12 + 6 - 2, 12 + 6)
    assert missing_of([], DEMO, {}) == (6, 6)
    out = write_folder(tmp_path, honest(one))
    assert begin(out, read_suite(out / SUITE), tmp_path / "key").missing == (11, 12)


def test_a_record_that_comes_meanwhile_is_left_for_the_next_audit(tmp_path, monkeypatch):
    out = write_folder(tmp_path, RECORD)

    def checked(*_):
        append_record(out / RECORDS, replace(RECORD, run=1))

    monkeypatch.setattr("probe.runs.checks.folder.check_suite_of", checked)
    audit = begin(out, read_suite(out / SUITE), tmp_path / "key")
    assert [(claim.line, claim.record) for claim in audit.claims] == [(lines(out)[0], RECORD)]


def forged(out: Path, *, seal: str | None) -> None:
    """An audit that says that all is equal, as somebody without the key can write it."""
    document = AuditDocument(
        release=RELEASE,
        suite=hash_of(out / SUITE),
        records=hash_of(out / RECORDS),
        results=2,
        verdicts=dict.fromkeys(lines(out), EQUAL),
        seal=seal,
    )
    left_out = {"seal"} if seal is None else None
    text = document.model_dump_json(indent=1, exclude=left_out)
    write_bytes(out / AUDIT, with_sum(text.encode()))


ELSEWHERE = "not audited here (audit.json was made elsewhere)"


@pytest.mark.parametrize("seal", [None, "", "0" * 64, "ä"])
@pytest.mark.parametrize("begun", [False, True])
def test_a_made_up_audit_counts_for_nothing(tmp_path, key, seal, begun):
    out = write_folder(tmp_path / "run", RECORD, replace(RECORD, run=1))
    if begun:
        ready_key(key)
    forged(out, seal=seal)
    assert audit_of(out, key).words == ELSEWHERE
    assert earlier(out, key) == {} and is_foreign(out, key)
    audit = begin(out, read_suite(out / SUITE), key)
    assert audit.foreign and len(audit.lacking(None)) == 2


def test_a_seal_is_of_these_very_verdicts(out, key):
    text = (out / AUDIT).read_bytes()
    assert not is_foreign(out, key)
    changed = without_sum(text).replace(b'"results": 2', b'"results": 1')
    (out / AUDIT).write_bytes(with_sum(changed))
    assert audit_of(out, key).words == ELSEWHERE and earlier(out, key) == {}


def test_a_lost_key_costs_the_replays(out, key):
    key.unlink()
    assert audit_of(out, key).words == ELSEWHERE and earlier(out, key) == {}
    keep(out, {lines(out)[0]: EQUAL}, results=2, key_file=key)
    assert audit_of(out, key).words == "audited: 1 of 2 replayed, all equal"


def test_the_key_is_its_owners_alone_and_no_other_text(out, key):
    assert stat.S_IMODE(key.stat().st_mode) == 0o600
    assert stat.S_IMODE(key.parent.stat().st_mode) == 0o700
    assert len(ready_key(key)) == 32 and ready_key(key) == key_of(key)
    key.write_text("\n")
    with pytest.raises(BadData, match=r"audit\.key: holds no key of audits"):
        audit_of(out, key)
