"""What a mistyped command says: one line that names what was meant, and where help is."""

from __future__ import annotations

import sys

import pytest

from probe import __version__
from probe.cli import COMMANDS, main
from probe.cli.overview import GROUPS, overview


@pytest.fixture
def typed(monkeypatch, capsys):
    """Exit status, output and errors of a command."""

    def run(*words):
        monkeypatch.setattr(sys, "argv", ["probe", *words])
        try:
            main()
            status = 0
        except SystemExit as ending:
            status = ending.code
        out, err = capsys.readouterr()
        # Python prints a text that a program ends with, and ends with status 1.
        return (1, out, f"{err}{status}\n") if isinstance(status, str) else (status, out, err)

    return run


@pytest.mark.parametrize(
    ("words", "told"),
    [
        (("rnu", "demo"), "There is no command called 'rnu'. Did you mean run? There are"),
        (("--versoin",), "There is no option --versoin here."),
        (("run",), 'SUITE is missing: "v2", "v1", "demo" or a file'),
        (("run", "v1", "--agnt", "random"), "There is no option --agnt. Did you mean --agent? See"),
        (("run", "v1", "--xyzzy"), "There is no option --xyzzy. See `probe run --help`."),
        (("run", "v1", "--agent"), "Missing value for argument '--agent'."),
        (("run", "v1", "--workers", "two"), "--workers: 'two' is no whole number."),
        (("run", "v1", "--noise", "pper"), "there is no 'pper'. Did you mean paper? Known: own"),
        (("run", "v1", "v1.1"), "'v1.1' is one word too many."),
        (("scene", "x"), "SEED: 'x' is no whole number. See `probe scene --help`."),
        (("tools",), "A command is missing; known: bench."),
        (("assets", "lst"), "no command called 'lst'. Did you mean list? Known: add"),
        (("assets", "list", "--pol", "own"), "Did you mean --pool? See `probe assets list --help`"),
    ],
)
def test_a_mistake_is_one_line_with_what_was_meant(typed, words, told):
    status, out, err = typed(*words)
    assert (status, out) == (2, "")
    assert err.startswith("probe: ") and err.count("\n") == 1
    assert told in err


@pytest.mark.parametrize(
    ("words", "told"),
    [
        (("run", "vv1"), "no suite called 'vv1'. Did you mean v1"),
        (("run", "v1", "--task", "beneath-0"), "no task called 'beneath-0'. Did you mean beneath-"),
        (("assets", "show", "red_block"), "Did you mean proc_red_block or"),
        (("assets", "list", "--category", "mugs"), "no category called 'mugs'. Did you mean mug?"),
        (("scene", "-3"), "SEED: -3 is out of range"),
        (("tools", "bench", "--grasps", "-1"), "--grasps: -1 is out of range"),
        (("run", "demo", "--limit", "0"), "--limit: 0 is out of range. Say 1 to"),
    ],
)
def test_a_wrong_value_is_one_line_too(typed, tmp_path, monkeypatch, words, told):
    monkeypatch.chdir(tmp_path)
    status, _, err = typed(*words)
    assert status == 1 and err.count("\n") == 1 and told in err
    assert list(tmp_path.iterdir()) == []


def test_the_version_is_told(typed):
    assert typed("--version") == (0, f"probe {__version__}\n", "")


def test_help_lists_every_command_once_and_training_apart(typed):
    _, out, _ = typed("--help")
    names = [line.split("  ")[1] for line in out.splitlines() if line.startswith("  ")]
    assert sorted(filter(None, names)) == sorted(COMMANDS)
    assert out.index("Training") < out.index("  train ") and out == typed()[1]


def test_a_command_of_no_group_is_listed_as_well():
    words = {name: "x" for names in GROUPS.values() for name in names} | {"juggle": "Juggle it."}
    lines = list(overview(words))
    assert lines[lines.index("More:") + 1].split() == ["juggle", "Juggle", "it."]
