"""Words of the command line that no file, agent or server can have end in one clear line."""

from __future__ import annotations

import os
import subprocess
import sys

import pytest

import probe.cli
from probe.cli.export import export

LONG = {length: "x" * length for length in (300, 5000)}


def said(monkeypatch, *words: str) -> str:
    """What the command ends with; it has to be one line of ours."""
    monkeypatch.setattr(sys, "argv", ["probe", *words])
    with pytest.raises(SystemExit) as ended:
        probe.cli.main()
    text = str(ended.value.code)
    assert text.startswith("probe: ") and "\n" not in text
    return text


@pytest.mark.parametrize("length", LONG)
@pytest.mark.parametrize(
    "words", [("suite", "show"), ("suite", "verify"), ("suite", "shortcuts"), ("run",), ("human",)]
)
def test_a_name_that_no_file_can_have_is_no_suite(monkeypatch, words, length):
    text = said(monkeypatch, *words, LONG[length])
    assert "There is no suite called 'xxx" in text and len(text) < 250


def test_no_name_is_no_suite_either(monkeypatch):
    assert "no suite called ''" in said(monkeypatch, "suite", "show", "")


def test_links_that_lead_nowhere_are_named(monkeypatch, tmp_path):
    (tmp_path / "loop").symlink_to(tmp_path / "loop")
    (tmp_path / "dangling").symlink_to(tmp_path / "gone")
    text = said(monkeypatch, "suite", "show", str(tmp_path / "loop"))
    assert "Too many levels of symbolic links" in text
    text = said(monkeypatch, "suite", "show", str(tmp_path / "dangling"))
    assert f"is a link to {tmp_path / 'gone'}, which isn't there" in text


def test_any_other_path_that_is_too_long(monkeypatch):
    assert "File name too long. Check the path" in said(monkeypatch, "report", LONG[300])


def test_agents(monkeypatch, tmp_path):
    out = ("--out", str(tmp_path / "out"))
    long = said(monkeypatch, "run", "demo", "--agent", f"{LONG[300]}.py:X", *out)
    assert "File name too long. Say --agent FILE.py:ClassName" in long
    (tmp_path / "loop.py").symlink_to(tmp_path / "loop.py")
    loop = said(monkeypatch, "run", "demo", "--agent", str(tmp_path / "loop.py"), *out)
    assert "Too many levels of symbolic links" in loop
    folder = said(monkeypatch, "run", "demo", "--agent", f"{tmp_path}/.py:X", *out)
    assert "there is no such file" in folder
    assert "no agent called ''" in said(monkeypatch, "run", "demo", "--agent", "", *out)
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize("option", ["--model", "--pointer"])
def test_models_have_names(monkeypatch, option):
    named = {"--model": "m", option: ""}
    words = [word for pair in named.items() for word in pair]
    where = ("--endpoint", "http://localhost:1/v1", "--dry-run")
    assert f"{option}: is empty" in said(monkeypatch, "run", "demo", *words, *where)


@pytest.mark.parametrize(
    ("address", "reason"),
    [
        ("http://127.0.0.1:99999/v1", "Port out of range"),
        ("http://127.0.0.1:-1/v1", "no address of a server"),
        ("http://127.0.0.1:0/v1", "nobody can listen at port 0"),
        ("http://127.0.0.1:80a/v1", "no address of a server"),
        ("http://:8000/v1", "names no server"),
        ("https:///v1", "names no server"),
        ("http://[::1/v1", "no address of a server"),
        ("http://local host/v1", "spaces"),
        ("ftp://localhost/v1", "Begin it with http://"),
        ("", "no address of a server"),
    ],
)
@pytest.mark.parametrize(
    "command", [("run", "demo", "--model", "m"), ("assets", "annotate", "notes", "--model", "m")]
)
def test_an_address_is_looked_at_before_anybody_is_asked(monkeypatch, command, address, reason):
    text = said(monkeypatch, *command, "--endpoint", address)
    assert text.startswith("probe: --endpoint: ") and reason in text


def test_scenes(monkeypatch):
    assert said(monkeypatch, "scene", "-1").startswith("probe: SEED: -1 is out of range. Say 0")
    text = said(monkeypatch, "scene", "3", "--objects", "2", "--buried", "16")
    assert "--buried: of 2 objects, 16 can't lie under others" in text


def test_an_export_goes_to_a_folder_of_its_own(monkeypatch, tmp_path):
    (tmp_path / "run").mkdir()
    (tmp_path / "run" / "records.jsonl").touch()
    (tmp_path / "file").touch()
    run = said(monkeypatch, "export", "demo", str(tmp_path / "run"))
    assert "holds something else already (records.jsonl)" in run
    assert "no folder" in said(monkeypatch, "export", "demo", str(tmp_path / "file"))
    assert [path.name for path in (tmp_path / "run").iterdir()] == ["records.jsonl"]


def test_an_export_that_was_broken_off_is_made_anew(monkeypatch, tmp_path):
    (tmp_path / "data").mkdir()
    (tmp_path / "data" / "test-00000-of-00001.parquet").touch()
    written = []
    monkeypatch.setattr("probe.cli.export.write_dataset", lambda *given: written.append(given) or 6)
    export("demo", tmp_path)
    assert len(written) == 1


def test_objects_that_are_refused_are_a_failure(monkeypatch, tmp_path):
    (tmp_path / "broken.glb").write_bytes(b"glTFxxxx")
    (tmp_path / "empty.glb").touch()
    text = said(monkeypatch, "assets", "check", str(tmp_path))
    assert "2 of 2 objects can't be used; the table says why" in text


@pytest.mark.skipif(not os.path.exists("/dev/full"), reason="needs a device that is full")
@pytest.mark.parametrize("words", [("suite", "show", "demo"), ("published",), ("--help",)])
def test_output_that_cannot_be_written_is_one_line(words):
    with open("/dev/full", "w") as full:
        ended = subprocess.run(
            [sys.executable, "-m", "probe", *words], stdout=full, stderr=subprocess.PIPE, text=True
        )
    assert ended.returncode == 1
    assert ended.stderr.count("\n") == 1
    assert ended.stderr.startswith("probe: Output can't be written: No space left on device.")
