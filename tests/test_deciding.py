"""Whether a change of what decides the built-in objects is noticed."""

import shutil

import pytest

import deciding
from deciding import ASSETS, SOURCES, state


def test_a_changed_byte_an_added_file_and_a_moved_folder_are_noticed(tmp_path, monkeypatch):
    monkeypatch.setattr(deciding, "ROOT", tmp_path)
    (tmp_path / "requirements.lock").write_text("numpy==2.4.6\nrich==1.0\n")
    folder = tmp_path / "paint"
    shutil.copytree(ASSETS / "procedural/paint", folder)
    before = state([folder])
    assert state([folder]) == before
    (folder / "data.py").write_text((folder / "data.py").read_text() + "\n")
    changed = state([folder])
    (folder / "new.yaml").write_text("")
    added = state([folder])
    (tmp_path / "requirements.lock").write_text("numpy==2.4.7\nrich==1.0\n")
    assert len({before, changed, added, state([folder])}) == 4
    with pytest.raises(AssertionError, match="has gone"):
        state([tmp_path / "nowhere"])


def test_what_decides_is_there():
    assert len(state(SOURCES)) == 64
