"""The choice of an engine on the command line."""

from __future__ import annotations

import subprocess
import sys

import pytest

from probe.cli.engines import EngineChoice
from probe.cli.run import ModelChoice, run
from probe.engines.local import LocalEngine
from probe.engines.ray_engine import RayEngine
from probe.errors import BadData


def test_work_is_done_here_unless_a_cluster_is_asked_for(tmp_path):
    assert EngineChoice().engine(tmp_path, None) == LocalEngine(1)
    asked = EngineChoice(on="ray", store="s3://bucket/run").engine(tmp_path, 4)
    assert isinstance(asked, RayEngine) and (asked.store, asked.workers) == ("s3://bucket/run", 4)


def test_a_store_without_a_cluster_is_refused(tmp_path):
    with pytest.raises(BadData, match="does nothing without --on ray"):
        EngineChoice(store="s3://bucket/run").engine(tmp_path, None)


def test_a_model_is_asked_from_one_machine(tmp_path):
    asked = ModelChoice(model="m", endpoint="http://127.0.0.1:9/v1")
    with pytest.raises(BadData, match="--shard"):
        run("demo", asked=asked, out=tmp_path, where=EngineChoice(on="ray"))


def test_nobody_imports_ray_or_stores_who_does_not_use_them():
    code = (
        "import sys, probe, probe.cli\n"
        "probe.cli.main.__module__\n"
        "from probe.cli.run import run\n"
        "print(sorted({'ray', 'fsspec', 's3fs'} & sys.modules.keys()))"
    )
    told = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert told.stdout.strip() == "[]"
