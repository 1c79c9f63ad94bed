"""The checks as a command."""

from __future__ import annotations

import io
import json
from pathlib import Path

import pytest

from bridges import TOKEN, Running
from faults import plant
from probe_bridge.command import main


@pytest.mark.parametrize(("fault", "status"), [("", 0), ("depth in millimetres", 1)])
def test_check_prints_and_writes_what_it_found(
    bridge: Running,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    fault: str,
    status: int,
):
    if fault:
        plant(bridge.robot, fault, 0)
    token, out = tmp_path / "token", tmp_path / "found.json"
    token.write_text(TOKEN + "\n")
    monkeypatch.setattr("sys.stdin", io.StringIO())
    options = [bridge.address, "--token-file", str(token), "--out", str(out)]
    assert main(["check", *options]) == status
    printed = capsys.readouterr().out
    assert "The robot will move" in printed and "skipped stop" in printed
    rows = {row["check"]: row for row in json.loads(out.read_text())}
    seen = rows["frames of table"]
    assert seen["fault"] == fault and (not fault or "depth_unit" in seen["remedy"])
    assert ("[depth in millimetres]" in printed) == bool(fault)
    assert {"name", "value", "unit"} == set(seen["measures"][0])


def test_it_asks_for_a_token(capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch):
    monkeypatch.delenv("PROBE_BRIDGE_TOKEN", raising=False)
    assert main(["check", "ws://127.0.0.1:9"]) == 1
    assert "token" in capsys.readouterr().err
