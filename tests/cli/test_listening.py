"""A model's server on this machine is looked for before anything else is done."""

from __future__ import annotations

import socket

import pytest

from probe.cli.listening import check_listening
from probe.cli.run import AgentChoice, ModelChoice, run
from probe.episodes.folder import SUITE
from probe.errors import BadData, ModelFailed
from probe.tasks.suite import selection
from probe.tasks.suite_file import demo_suite, write_suite

ELSEWHERE = "http://nowhere.invalid/v1"


def test_a_port_at_which_nobody_listens_is_told_before_objects_are_prepared(tmp_path, monkeypatch):
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    asked = ModelChoice("mine", endpoint="http://127.0.0.1:9/v1")
    with pytest.raises(ModelFailed, match="127.0.0.1:9/v1 can't be reached .connection refused.*S"):
        run("demo", AgentChoice(), asked, out=tmp_path / "out")
    assert list(tmp_path.iterdir()) == []


def test_a_server_that_is_here_or_elsewhere_is_left_to_the_client():
    with socket.create_server(("127.0.0.1", 0)) as server:
        check_listening("mine", f"http://127.0.0.1:{server.getsockname()[1]}/v1")
    check_listening("mine", None)
    check_listening("mine", ELSEWHERE)


def test_a_models_run_refuses_a_folder_before_objects_are_prepared(tmp_path, monkeypatch):
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    suite = demo_suite()
    write_suite(tmp_path / "out" / SUITE, selection(suite, suite.tasks[:1], "demo"))
    with pytest.raises(BadData, match="is another suite: 1 tasks of demo, not 6"):
        run("demo", AgentChoice(), ModelChoice("mine", endpoint=ELSEWHERE), out=tmp_path / "out")
    assert not (tmp_path / "cache").exists()
