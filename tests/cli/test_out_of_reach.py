"""A path that can't be looked at, or too low a limit of memory, ends a command in one line."""

from __future__ import annotations

import errno
import resource
import subprocess
import sys

import pytest

import probe.cli

LONG = "a" * 300


def refused(monkeypatch: pytest.MonkeyPatch, *words: object) -> str:
    monkeypatch.setattr(sys, "argv", ["probe", *map(str, words)])
    with pytest.raises(SystemExit) as ended:
        probe.cli.main()
    assert isinstance(ended.value.code, str)
    return ended.value.code


@pytest.mark.parametrize(
    "words",
    [
        ("run", "demo", "--agent", "always-A", "--out", LONG),
        ("rescore", LONG),
        ("merge", "one", "--out", LONG),
    ],
    ids=" ".join,
)
def test_a_name_that_is_too_long(tmp_path, monkeypatch, words):
    monkeypatch.chdir(tmp_path)
    told = refused(monkeypatch, *words)
    assert told.startswith("probe: ") and LONG in told and "File name too long. " in told
    assert not any(tmp_path.iterdir())


def test_a_folder_that_is_closed(monkeypatch):
    def closed(words: list[str]) -> None:
        raise PermissionError(errno.EACCES, "Permission denied", "/closed/suite.json")

    monkeypatch.setattr("probe.cli._run", closed)
    told = refused(monkeypatch, "demo")
    assert told.startswith("probe: /closed/suite.json: Permission denied. Choose another path")


@pytest.mark.parametrize("error", [OSError(errno.EIO, "I/O error", "x"), OSError("a mistake")])
def test_other_errors_keep_their_traceback(monkeypatch, error):
    def mistaken(words: list[str]) -> None:
        raise error

    monkeypatch.setattr("probe.cli._run", mistaken)
    monkeypatch.setattr(sys, "argv", ["probe", "demo"])
    with pytest.raises(OSError, match=str(error.strerror or "a mistake")):
        probe.cli.main()


@pytest.mark.parametrize("mebibytes", [100, 200, 350])
def test_fewer_addresses_than_anything_needs(mebibytes):
    limit = mebibytes << 20
    ended = subprocess.run(
        [sys.executable, "-m", "probe", "suite", "show", "demo"],
        capture_output=True,
        text=True,
        timeout=60,
        preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (limit, limit)),
    )
    assert ended.returncode == 1
    assert ended.stderr.startswith(f"probe: {mebibytes} MiB of memory are allowed, and 400 is")
