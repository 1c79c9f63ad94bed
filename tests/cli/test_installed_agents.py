"""Agents that an installed package offers."""

from __future__ import annotations

import pytest

from probe.agents.external.sandbox import Sandbox
from probe.cli.file_agents import FileAgents, who_acts
from probe.errors import BadData, UnknownName

CODE = """
class Agent:
    def act(self, question, history):
        return None
"""


@pytest.fixture
def package(tmp_path, monkeypatch):
    """A package on the path, with metadata as pip writes it; importing it here would fail."""

    def install(points):
        home = tmp_path / "site" / "clever"
        home.mkdir(parents=True)
        (home / "__init__.py").write_text("raise RuntimeError('imported by PROBE')\n")
        (home / "mind.py").write_text(CODE)
        told = tmp_path / "site" / "clever-1.0.dist-info"
        told.mkdir()
        (told / "METADATA").write_text("Metadata-Version: 2.1\nName: clever\nVersion: 1.0\n")
        (told / "entry_points.txt").write_text(f"[probe.agents]\n{points}\n")
        monkeypatch.syspath_prepend(tmp_path / "site")

    return install


def test_it_goes_by_its_entry_points_name_and_is_not_imported_here(package, tmp_path):
    package("clever-one = clever.mind:Agent")
    name, made = who_acts("clever-one", None, Sandbox(), "demo", tmp_path)
    assert name == "clever-one" and isinstance(made, FileAgents)
    assert made.invitation.file.path == (tmp_path / "site" / "clever" / "mind.py").resolve()
    assert who_acts("clever-one", "mine", Sandbox(), "demo", tmp_path)[0] == "mine"


def test_one_without_a_file_is_refused_and_names_are_suggested(package, tmp_path):
    package("clever-one = clever.gone:Agent")
    with pytest.raises(BadData, match=r"clever.gone:Agent: names no Python file that is here"):
        who_acts("clever-one", None, Sandbox(), "demo", tmp_path)
    with pytest.raises(UnknownName, match="Did you mean clever-one"):
        who_acts("clever-oen", None, Sandbox(), "demo", tmp_path)
