"""What a replay's failure says about the record, and what it doesn't."""

from __future__ import annotations

from typing import Any

import pytest

from probe.audit import replaying
from probe.audit.audit_file import ReplayVerdict
from probe.audit.replaying import Claim, Replayer
from probe.errors import OutputFailed
from probe.runs.plan import Job, RunOrder
from probe.runs.work import stopped
from probe.tasks.suite_file import demo_suite

NOWHERE: Any = None


def verdict(error: Exception, monkeypatch) -> ReplayVerdict:
    """Of a replay during which this is raised."""

    def raising(*_: object) -> str:
        raise error

    suite = demo_suite()
    task = suite.tasks[0]
    monkeypatch.setattr(replaying, "check_objects", raising)
    claim = Claim("0" * 64, stopped(Job(task, 0), RunOrder("anna")), task)
    content = Replayer(suite, NOWHERE)._verdict(NOWHERE, NOWHERE, claim)
    return ReplayVerdict.model_validate_json(content)


def test_a_full_disk_is_no_verdict_on_the_record(monkeypatch):
    with pytest.raises(OutputFailed, match="No space left"):
        verdict(OutputFailed("/cache/x.npz", "No space left on device"), monkeypatch)


def test_what_a_record_does_to_the_tools_is_told_of_it(monkeypatch):
    found = verdict(ValueError("no such joint"), monkeypatch)
    assert (found.outcome, found.reason) == ("not replayable", "ValueError: no such joint")
