"""`probe run` with options that don't go together: refused before anything is done."""

from __future__ import annotations

from typing import Any

import pytest

from probe.cli.run import run
from probe.episodes.conditions import Conditions
from probe.errors import BadData
from probe.perception.dials import Dials


@pytest.mark.parametrize(
    ("said", "words"),
    [
        ({"dry_run": True}, "--dry-run: does nothing without --model"),
        ({"endpoint": "http://localhost/v1"}, "--endpoint: does nothing without"),
        ({"setting": "agentic"}, "--setting: does nothing without"),
        ({"epochs": 3}, "--epochs: does nothing without"),
        ({"pointer": "oracle"}, "--pointer: does nothing without"),
        ({"model": "m", "agent": "scripted"}, "--agent: does nothing with --model"),
        ({"model": "m", "runs": 1}, "--runs: does nothing with --model"),
        (
            {"model": "m", "epochs": -1, "dry_run": True},
            "--epochs: -1 is out of range",
        ),
        ({"runs": 0}, "--runs: 0 is out of range. Say 1 to 1,000"),
        ({"workers": 0}, "--workers: 0 is out of range. Say 1 to 256"),
        (
            {"model": "m", "pointer": "self", "setting": "direct"},
            "does nothing with --setting direct",
        ),
        (
            {"model": "m", "pointer": "self", "conditions": Conditions(ideal="perception")},
            "--pointer: does nothing with --dials or --ideal",
        ),
        (
            {"model": "m", "pointer": "n", "conditions": Conditions(dials=Dials(missed=0.1))},
            "--pointer: does nothing with --dials or --ideal",
        ),
    ],
)
def test_what_would_do_nothing_is_refused(tmp_path, said: dict[str, Any], words):
    with pytest.raises(BadData, match=words):
        run("demo", out=tmp_path / "out", **said)
    assert not (tmp_path / "out").exists()


def test_what_goes_together_is_taken(tmp_path, capsys):
    run("demo", model="gpt-5.4", pointer="self", epochs=2, dry_run=True, out=tmp_path / "out")
    assert "6 tasks, 2 runs each: 12 episodes." in capsys.readouterr().out
