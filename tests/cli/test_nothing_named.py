"""Commands that take several folders or suites, and are given none, say so and write nothing."""

from __future__ import annotations

import pytest

from probe.cli.held_out import held_out
from probe.cli.ladder import ladder
from probe.cli.merge import merge
from probe.cli.robustness import robustness
from probe.cli.select import select
from probe.cli.shortcuts import learn, shortcuts
from probe.errors import BadData

COMMANDS = {
    "held-out": lambda out: held_out((), out=out),
    "ladder": lambda out: ladder((), out=out),
    "merge": lambda out: merge((), out),
    "robustness": lambda out: robustness(out, (), out=out),
    "select": lambda out: select((), out=out),
    "learn": lambda out: learn((), out=out),
    "shortcuts": lambda out: shortcuts((), out=out),
}


@pytest.mark.parametrize("name", COMMANDS)
def test_it_is_said_and_nothing_written(name, tmp_path):
    with pytest.raises(BadData, match=r"given (no|one) .*Name"):
        COMMANDS[name](tmp_path / "out")
    assert not (tmp_path / "out").exists()
