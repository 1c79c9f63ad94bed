"""Numbers of the command line that make no sense are refused before anything is done."""

from __future__ import annotations

import pytest

import probe.cli
from probe.cli.numbers import check_numbers
from probe.errors import BadData


@pytest.mark.parametrize(
    ("given", "words"),
    [
        ({"--grasps": -1}, "--grasps: -1 is out of range. Say 0 to 1,000,000"),
        ({"--runs": 10**9}, "--runs: 1000000000 is out of range. Say 1 to 1,000"),
        ({"--workers": 0}, "--workers: 0 is out of range. Say 1 to 256"),
        ({"--sigma": float("nan")}, "--sigma: nan is out of range"),
        ({"--most-cost": float("inf")}, "--most-cost: inf is out of range"),
        ({"--counts.find": -2}, "--counts.find: -2 is out of range. Say 0"),
    ],
)
def test_numbers_out_of_range_are_refused(given, words):
    with pytest.raises(BadData) as refused:
        check_numbers(given)
    assert words in str(refused.value)


def test_what_was_not_said_and_what_is_in_range_passes():
    check_numbers({"--runs": None, "--workers": 256, "--share": 0.0, "--seed": 2**63 - 1})


COMMANDS = [
    ("scene", ["-3"]),
    ("scene", ["7", "--objects", "0"]),
    ("scene", ["7", "--gallery", "-1"]),
    ("tools bench", ["--grasps", "-1"]),
    ("tools bench", ["--sigma", "nan"]),
    ("run demo", ["--pose-jitter", "nan"]),
    ("run demo", ["--runs", "1000000000"]),
    ("run demo", ["--dials.over", "2"]),
    ("run demo", ["--shard", "2/2"]),
    ("run demo", ["--shard", "\u0661/\u0662"]),
    ("human demo", ["--port", "70000"]),
    ("collect", ["--workers", "0"]),
    ("collect", ["--counts.find", "-1"]),
    ("collect", ["--most-cost", "nan"]),
    ("assets check", ["--workers", "-1"]),
    ("assets split", ["--share", "7"]),
    ("suite build x.json", ["--counts.find", "-1"]),
    ("suite build x.json", ["--counts.find", "1", "--first", "-5"]),
    ("suite verify demo", ["--histories", "-1"]),
    ("serve", ["--seed", "-1"]),
]


@pytest.mark.parametrize(("command", "options"), COMMANDS)
def test_commands_refuse_them_in_one_line(tmp_path, monkeypatch, capsys, command, options):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr("sys.argv", ["probe", *command.split(), *options])
    with pytest.raises(SystemExit) as ended:
        probe.cli.main()
    assert isinstance(ended.value.code, str) and ended.value.code.startswith(
        ("probe: --", "probe: SEED")
    )
    assert "\n" not in ended.value.code
    assert list(tmp_path.iterdir()) == []
