"""`probe doctor`: what it finds, and what it advises."""

from __future__ import annotations

import json
import tomllib
from pathlib import Path

import pytest

from probe.cli.doctor import Unfit, doctor
from probe.cli.health.packages import EXTRAS, lacking
from probe.errors import BadData, NoGraphicsDriver


def found(capsys, **asked):
    doctor(json=True, **asked)
    said = json.loads(capsys.readouterr().out)
    return {it["name"]: it for it in said["findings"]}


def test_keys_are_found_and_never_shown(capsys, monkeypatch):
    monkeypatch.setenv("OPENAI_API_KEY", "sk-secret")
    monkeypatch.delenv("XAI_API_KEY", raising=False)
    doctor()
    said = capsys.readouterr().out
    assert "sk-secret" not in said
    assert "export XAI_API_KEY=KEY" in said and "export OPENAI_API_KEY" not in said


def test_assets_need_a_folder_of_scans(capsys, monkeypatch, tmp_path):
    monkeypatch.setenv("PROBE_ASSETS", str(tmp_path))
    missing = found(capsys)["PROBE_ASSETS"]
    assert not missing["ok"] and "has no folder scans" in missing["found"]
    (tmp_path / "scans").mkdir()
    assert found(capsys)["PROBE_ASSETS"]["ok"]


def test_a_cache_that_cannot_be_written_ends_with_a_failure(capsys, monkeypatch):
    monkeypatch.setenv("XDG_CACHE_HOME", "/proc/none")
    with pytest.raises(Unfit, match="Nothing works without: cache"):
        doctor()
    assert "export XDG_CACHE_HOME=FOLDER" in capsys.readouterr().out


def test_a_missing_driver_ends_with_a_failure_and_its_package(capsys, monkeypatch):
    def none():
        raise NoGraphicsDriver("No Vulkan loader (libvulkan.so.1) on this machine. Install it.")

    monkeypatch.setattr("probe.cli.health.core.require_driver", none)
    with pytest.raises(Unfit, match="Vulkan driver"):
        doctor()
    said = capsys.readouterr().out
    assert "No Vulkan loader (libvulkan.so.1) on this machine" in said
    assert "apt-get install mesa-vulkan-drivers" in said


def test_a_server_that_is_not_there_is_no_failure_of_the_core(capsys):
    server = found(capsys, endpoint="http://127.0.0.1:9/v1")["model server"]
    assert not server["ok"] and "doesn't answer: " in server["found"]
    with pytest.raises(BadData, match="--endpoint"):
        doctor(endpoint="localhost")


def test_every_extra_for_users_is_looked_for():
    project = tomllib.loads((Path(__file__).parents[2] / "pyproject.toml").read_text("utf-8"))
    for_us = {"dev", "docs", "mutants"}
    assert {*EXTRAS} == {*project["project"]["optional-dependencies"]} - for_us


def test_extras_name_the_packages_that_they_lack():
    assert lacking() == []
    assert all(isinstance(lacking(extra), list) for extra in EXTRAS)
    # Neither in "dev" nor in any lock file.
    assert lacking("grok") in ([], ["xai-sdk"])
