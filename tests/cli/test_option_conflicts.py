"""`probe run` with options that don't go together: refused before anything is done."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import pytest

from probe.cli.perception import PerceptionChoice
from probe.cli.run import AgentChoice, ModelChoice, run
from probe.episodes.conditions import Conditions
from probe.errors import BadData
from probe.perception.dials import Dials


def carry_out(said: Mapping[str, Any], out: Path) -> None:
    """`probe run demo` with these options."""
    parts = [
        {name: said[name] for name in said if hasattr(of, name)}
        for of in (AgentChoice, ModelChoice)
    ]
    rest = {name: value for name, value in said.items() if not any(name in it for it in parts)}
    run("demo", AgentChoice(**parts[0]), ModelChoice(**parts[1]), out=out, **rest)


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
            {"model": "m", "dry_run": True, "json": True},
            "--json: does nothing with --dry-run",
        ),
        ({"graphs": "short"}, "--graphs: does nothing without --model"),
        ({"model": "m", "graphs": "short"}, "--graphs: does nothing with --setting agentic"),
        (
            {"model": "m", "pointer": "self", "setting": "text-only"},
            "--pointer: does nothing with --setting text-only",
        ),
        (
            {"model": "m", "pointer": "self", "conditions": Conditions(ideal="perception")},
            "--pointer: does nothing with --dials or --ideal",
        ),
        (
            {"model": "m", "pointer": "n", "conditions": Conditions(dials=Dials(missed=0.1))},
            "--pointer: does nothing with --dials or --ideal",
        ),
        (
            {"seeing": PerceptionChoice("segmenter"), "conditions": Conditions(ideal="perception")},
            "--perception segmenter: does nothing with --dials or --ideal",
        ),
        (
            {"seeing": PerceptionChoice("segmenter"), "model": "m", "pointer": "self"},
            "--perception segmenter: does nothing with --pointer",
        ),
        (
            {"seeing": PerceptionChoice("segmenter"), "model": "m", "setting": "direct"},
            "does nothing with --setting direct",
        ),
        (
            {"model": "m", "setting": "direct", "conditions": Conditions(dials=Dials(over=0.1))},
            "--dials: does nothing with --setting direct",
        ),
        (
            {"model": "m", "setting": "blind", "conditions": Conditions(ideal="grasp")},
            "--ideal grasp: does nothing with --setting blind",
        ),
        (
            {
                "model": "m",
                "setting": "oracle-view",
                "dry_run": True,
                "conditions": Conditions(ideal="perception"),
            },
            "--ideal perception: does nothing with --setting oracle-view",
        ),
        (
            {"agent": "always-A", "conditions": Conditions(dials=Dials(missed=0.1))},
            "--dials: does nothing with --agent always-A",
        ),
        (
            {"model": "m", "dry_run": True, "watch": True},
            "--watch: does nothing with --dry-run",
        ),
        ({"seeing": PerceptionChoice("enrolled")}, "Say it with --enrolment FILE"),
        (
            {"seeing": PerceptionChoice(enrolment=Path("objects.yaml"))},
            "--enrolment: does nothing with --perception oracle",
        ),
        (
            {"seeing": PerceptionChoice("enrolled", Path("nowhere.yaml"))},
            "nowhere.yaml: No such file",
        ),
    ],
)
def test_what_would_do_nothing_is_refused(tmp_path, said: dict[str, Any], words):
    with pytest.raises(BadData, match=words):
        carry_out(said, tmp_path / "out")
    assert not (tmp_path / "out").exists()


def test_what_goes_together_is_taken(tmp_path, capsys):
    said = {"model": "gpt-5.4", "pointer": "self", "epochs": 2, "dry_run": True}
    carry_out(said, tmp_path / "out")
    assert "6 tasks, 2 runs each: 12 episodes." in capsys.readouterr().out


def test_tools_may_err_in_any_setting_that_has_them(tmp_path, capsys):
    conditions = Conditions(dials=Dials(over=0.1), ideal="grasp")
    said = {"model": "gpt-5.4", "setting": "text-only", "epochs": 2, "dry_run": True}
    carry_out({**said, "conditions": conditions}, tmp_path / "out")
    assert "6 tasks, 2 runs each: 12 episodes." in capsys.readouterr().out
