"""What a terminal shows meanwhile: signs that go away, bars, pages."""

from __future__ import annotations

import os
import pty
import subprocess
import sys
from pathlib import Path

import pytest

from probe.api.suites import open_library
from probe.cli.assets import list_objects
from probe.cli.assets_sheet import sheet
from probe.cli.screen import passing, sign
from probe.errors import OutputFailed, UnknownName


def at_a_terminal(code):
    """All that Python code shows at a terminal."""
    ours, theirs = pty.openpty()
    done = subprocess.Popen([sys.executable, "-c", code], stdout=theirs, stderr=theirs)
    os.close(theirs)
    shown = b""
    while True:
        try:
            more = os.read(ours, 4096)
        except OSError:  # nobody holds the other end any more
            break
        if not more:
            break
        shown += more
    os.close(ours)
    assert done.wait() == 0, shown
    return shown.decode()


def test_a_sign_is_shown_at_once_and_taken_away():
    shown = at_a_terminal("from probe.cli.screen import sign\nwith sign('Reading'): print('in')")
    assert shown.startswith("Reading\r") and shown.endswith("\x1b[2K")
    assert "in" in shown


def test_starting_a_command_is_said_before_it_is_loaded():
    code = """
import sys
sys.argv = ["probe", "scene", "-3"]
from probe.cli import main
try:
    main()
except SystemExit as ending:
    print(ending)
"""
    shown = at_a_terminal(code)
    assert shown.index("probe scene is starting") < shown.index("probe: SEED: -3 is out of range")


def test_a_bar_goes_away_at_a_terminal():
    code = "from probe.cli.screen import passing\nprint(sum(passing([1, 2], 'Adding')))"
    shown = at_a_terminal(code)
    assert "Adding" in shown and "3" in shown.rpartition("\x1b[2K")[2]


def test_nothing_is_shown_where_nobody_looks(capsys):
    with sign("Reading"):
        assert list(passing([1, 2], "Adding")) == [1, 2]
    assert capsys.readouterr() == ("", "")


def test_a_sheet_that_cant_be_written_or_named_is_refused_before_it_is_drawn(tmp_path):
    with pytest.raises(OutputFailed, match="No folder can be made there"):
        sheet(Path("/proc/sheets/sheet.png"))
    with pytest.raises(UnknownName, match="no category called 'mugs'. Did you mean mug?"):
        sheet(tmp_path / "sheet.png", category="mugs")
    assert list(tmp_path.iterdir()) == []


def test_a_category_is_listed_alone(capsys):
    list_objects(category="mug")
    rows = [line for line in capsys.readouterr().out.splitlines() if "proc_" in line]
    mugs = [spec.id for spec in open_library().specs if spec.category == "mug"]
    assert len(rows) == len(mugs) > 1
    assert all(id in "\n".join(rows) for id in mugs)
