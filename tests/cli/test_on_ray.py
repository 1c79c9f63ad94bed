"""Commands on two nodes of a Ray cluster that share no folder with the driver but a store."""

from __future__ import annotations

import json
import os
import subprocess
import sys

import fsspec
import pytest

from engines.ray_nodes import Nodes, nodes_and_store
from probe.tasks.suite import part
from probe.tasks.suite_file import demo_suite, write_suite
from untimed import lines

# One worker: two clusters on one machine may take each other's ports.
pytestmark = pytest.mark.slow


@pytest.fixture(scope="module")
def nodes(cache):
    with nodes_and_store(cache) as started:
        yield started


def probe(nodes: Nodes, *arguments: object, **more: str) -> str:
    done = subprocess.run(
        [sys.executable, "-m", "probe", *map(str, arguments)],
        env={**os.environ, **nodes.environment, **more},
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


def test_records_and_verdicts_are_the_same_as_here(nodes: Nodes, tmp_path, monkeypatch):
    monkeypatch.delenv("PROBE_ASSETS", raising=False)
    for name, value in nodes.environment.items():
        monkeypatch.setenv(name, value)
    s3 = fsspec.filesystem("s3", use_listings_cache=False)
    s3.mkdir("work")
    there = ("--on", "ray", "--store", "s3://work/one")
    whole, small = demo_suite(), tmp_path / "small.json"
    write_suite(small, part(whole, whole.tasks[0]))
    for name, where in (("here", ("--workers", 2)), ("there", there)):
        probe(nodes, "run", small, "--out", tmp_path / name / "run", *where)
        out = tmp_path / name / "verdicts"
        probe(nodes, "suite", "verify", small, "--no-solve", "--out", out, *where)
    here, away = tmp_path / "here", tmp_path / "there"
    assert lines(here / "run") == lines(away / "run") and len(lines(here / "run")) == 1
    for verdict in (here / "verdicts").iterdir():
        assert json.loads(verdict.read_text()) == json.loads(
            (away / "verdicts" / verdict.name).read_text()
        )
    assert [name for name in s3.find("s3://work/one") if "/assets/" not in name] == []
