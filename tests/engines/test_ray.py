"""Units on two nodes of a real Ray cluster, with deaths at the worst moments."""

from __future__ import annotations

import json
import os
import signal
import socket
import subprocess
import sys
import threading
import time
from pathlib import Path
from typing import cast

import fsspec
import pytest

from crew_jobs import AssetReader, Bench
from engines.ray_nodes import MODULES, Nodes, nodes_and_store
from probe.engines.plan import LostUnit, WorkPlan
from probe.engines.ray_engine import RayEngine
from probe.engines.ray_errors import ClusterRefused
from probe.errors import BadData, WorkerDied
from probe.processes.serving import WorkerUnfit

# One worker: two clusters on one machine may take each other's ports.
pytestmark = pytest.mark.slow

DRIVER = """
import sys
from pathlib import Path
from typing import cast
from crew_jobs import Bench
from probe.engines.plan import WorkPlan
from probe.engines.ray_engine import RayEngine
notes, units = Path(sys.argv[1]), sys.argv[2:]
for unit, result in RayEngine(notes / "run").carry_out(WorkPlan("w", Bench(notes), units, str)):
    with (notes / "kept").open("a") as file:
        file.write(f"{unit}\\n")
"""


@pytest.fixture(scope="module")
def nodes():
    with nodes_and_store() as started:
        yield started


@pytest.fixture(autouse=True)
def _let_in(nodes: Nodes, monkeypatch):
    for name, value in nodes.environment.items():
        monkeypatch.setenv(name, value)


def carry_out(notes: Path, units: list[str], *, store: str | None = None, **bench: bool):
    plan = WorkPlan("w", Bench(notes, **bench), units, str)
    told: list[str] = []
    results = dict(RayEngine(notes / "run", store, tell=told.append).carry_out(plan))
    assert told.pop(0).startswith("Connecting to the Ray cluster at 127.0.0.1:")
    return results, told


def begun(notes: Path, unit: str) -> int:
    file = notes / f"begun-{unit}"
    return len(file.read_text().split()) if file.exists() else 0


def wait_for(check, seconds: float = 60.0) -> None:
    end = time.monotonic() + seconds
    while not check():
        assert time.monotonic() < end, "nothing happened"
        time.sleep(0.05)


def test_each_unit_is_done_once_by_both_nodes_and_nothing_is_left(tmp_path):
    units = [f"unit-{number}" for number in range(6)]
    results, told = carry_out(tmp_path, units)
    assert results == {unit: f"{unit} done".encode() for unit in units}
    assert [begun(tmp_path, unit) for unit in units] == [1] * 6
    assert not told and not list((tmp_path / "run").glob("*"))


def test_the_death_of_a_worker_costs_a_try_and_three_deaths_the_unit(tmp_path, capfd):
    results, told = carry_out(tmp_path, ["unlucky", "deadly", "a", "b"])
    assert told == [f"{socket.gethostname()}: A worker died. Another one does its work."]
    time.sleep(2)  # Ray tells of deaths from a thread
    assert capfd.readouterr() == ("", "")
    lost = results.pop("deadly")
    assert isinstance(lost, LostUnit) and "3 times" in lost.reason
    assert results == {unit: f"{unit} done".encode() for unit in ("unlucky", "a", "b")}
    assert (begun(tmp_path, "unlucky"), begun(tmp_path, "deadly")) == (2, 3)


def test_the_death_of_a_node_costs_no_unit(nodes: Nodes, tmp_path):
    units = [f"second-{number}" for number in range(12)]
    killer = threading.Thread(
        target=lambda: (
            wait_for(lambda: begun(tmp_path, "second-4")),
            nodes.kill_second(),
        )
    )
    killer.start()
    results, _ = carry_out(tmp_path, units)
    killer.join()
    nodes.add_second()
    assert results == {unit: f"{unit} done".encode() for unit in units}
    assert not list((tmp_path / "run").glob("*"))


def test_the_death_of_the_first_machine_is_told_and_what_was_finished_is_kept(
    nodes: Nodes, tmp_path
):
    units = [f"second-{number}" for number in range(80)]
    arguments = [sys.executable, "-c", DRIVER, str(tmp_path), *units]
    driver = subprocess.Popen(
        arguments,
        env={**os.environ, "PYTHONPATH": MODULES},
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )
    wait_for(lambda: begun(tmp_path, "second-4"))
    nodes.kill_first()
    killed = time.monotonic()
    said, refused = driver.communicate(timeout=90)
    took = time.monotonic() - killed
    nodes.kill_second()
    nodes.start_first()
    nodes.add_second()
    assert took < 50, "Ray itself ends the process after 60 s"
    assert driver.returncode == 1
    assert f"{nodes.address} (from RAY_ADDRESS) doesn't answer" in said
    assert f"kept in {tmp_path / 'run'} and " in refused and "the same command" in refused
    assert "rpc_client" not in refused and "raylet" not in said
    done = (tmp_path / "kept").read_text().split()
    left = [unit for unit in units if unit not in done][:4]
    results, _ = carry_out(tmp_path, left)
    assert results == {unit: f"{unit} done".encode() for unit in left}


def test_a_driver_that_is_killed_finds_what_was_done(tmp_path):
    units = ["a", "b", "second-1", "long"]
    arguments = [sys.executable, "-c", DRIVER, str(tmp_path), *units]
    driver = subprocess.Popen(arguments, env={**os.environ, "PYTHONPATH": MODULES})
    kept = tmp_path / "kept"
    wait_for(lambda: kept.exists() and begun(tmp_path, "long"))
    driver.send_signal(signal.SIGKILL)
    driver.wait()
    done = kept.read_text().split()
    left = [unit for unit in units if unit not in done and unit != "long"]
    results, _ = carry_out(tmp_path, [*left, "c"])
    assert sorted([*done, *results]) == ["a", "b", "c", "second-1"]
    assert not list((tmp_path / "run").glob("*"))


@pytest.fixture
def store(nodes: Nodes, tmp_path: Path) -> str:
    s3 = fsspec.filesystem("s3", use_listings_cache=False)
    if not s3.exists("probe"):
        s3.mkdir("probe")
    return f"s3://probe/{tmp_path.name}"


def read_assets(tmp_path: Path, store: str | None, units: int = 4, heard: Path | None = None):
    """What workers found; with `heard`, no unit ends before a node has said something."""
    told: list[str] = []

    def tell(words: str) -> None:
        told.append(words)
        if heard is not None and len(told) > 1:
            heard.touch()

    plan = WorkPlan("look", AssetReader(heard), [str(number) for number in range(units)], str)
    engine = RayEngine(tmp_path, store, tell=tell)
    found = [json.loads(cast(bytes, result)) for _, result in engine.carry_out(plan)]
    assert told.pop(0).startswith("Connecting")
    return found, told


def test_assets_and_results_go_by_way_of_an_object_store(
    nodes: Nodes, tmp_path, store, monkeypatch
):
    assets = tmp_path / "assets"
    (assets / "scans").mkdir(parents=True)
    (assets / "scans" / "a.txt").write_text("bowl")
    (assets / "b.txt").write_text("bowl")
    monkeypatch.setenv("PROBE_ASSETS", str(assets))
    results, told = read_assets(tmp_path / "run", store)
    assert not told and not (tmp_path / "run").exists()
    seen = {result["folder"] for result in results}
    assert [result["files"] for result in results] == [{"b.txt": "bowl", "scans/a.txt": "bowl"}] * 4
    assert all(folder.startswith(str(nodes.folder / "cache-")) for folder in seen)
    s3 = fsspec.filesystem("s3", use_listings_cache=False)
    assert [name for name in s3.find(store) if "/assets/" not in name] == []
    assert len(s3.find(f"{store}/assets")) == 1  # the same content is kept once


def test_a_node_whose_disk_refuses_is_said_and_the_rest_goes_on(
    nodes: Nodes, tmp_path, store, monkeypatch
):
    (tmp_path / "assets").mkdir()
    (tmp_path / "assets" / "a.txt").write_text("plate")
    monkeypatch.setenv("PROBE_ASSETS", str(tmp_path / "assets"))
    (nodes.folder / "in-the-way").write_text("no folder")
    nodes.kill_second()
    nodes.add_second(cache="in-the-way")
    results, told = read_assets(tmp_path / "run", store, units=6, heard=tmp_path / "heard")
    assert len(results) == 6
    assert all(result["files"] == {"a.txt": "plate"} for result in results)
    assert len(told) == 1 and "in-the-way" in told[0] and "The other workers go on" in told[0]
    nodes.kill_second()
    nodes.add_second()


def test_a_disk_that_fills_up_during_the_work_costs_no_unit(tmp_path):
    units = [f"roomy-{number}" for number in range(6)]
    results, told = carry_out(tmp_path, units)
    assert results == {unit: f"{unit} done".encode() for unit in units}
    assert len(told) == 1 and "No space left on device" in told[0]


def test_workers_that_die_while_set_up_on_one_node_do_not_end_the_work_of_another(tmp_path):
    units = ["slow", "a"]
    results, _ = carry_out(tmp_path, units, frail=True)
    assert results == {unit: f"{unit} done".encode() for unit in units}


def test_a_node_that_cannot_work_is_named(tmp_path):
    with pytest.raises(WorkerUnfit, match="no tools here"):
        carry_out(tmp_path, ["a"], unfit=True)
    with pytest.raises(WorkerDied, match="setting up on a node.* The same command goes on"):
        carry_out(tmp_path, ["a", "b"], stillborn=True)


def test_a_store_in_use_by_another_run_is_left_alone(tmp_path):
    other = tmp_path / "run" / "units-w"
    other.mkdir(parents=True)
    (other / "driver").write_text("elsewhere:/runs/mine")
    with pytest.raises(BadData, match="in use by the run of elsewhere:/runs/mine"):
        carry_out(tmp_path, ["a"])


def test_without_a_token_nothing_is_sent(tmp_path, monkeypatch):
    monkeypatch.delenv("RAY_AUTH_MODE")
    with pytest.raises(ClusterRefused, match="RAY_AUTH_MODE isn't token"):
        carry_out(tmp_path, ["a"])
    monkeypatch.setenv("RAY_AUTH_MODE", "token")
    monkeypatch.delenv("RAY_AUTH_TOKEN")
    monkeypatch.setenv("RAY_AUTH_TOKEN_PATH", str(tmp_path / "none"))
    with pytest.raises(ClusterRefused, match="there is no token"):
        carry_out(tmp_path, ["a"])


def test_a_wrong_token_is_refused_at_once_with_the_remedy(nodes: Nodes, tmp_path):
    wrong = {**os.environ, "PYTHONPATH": MODULES, "RAY_AUTH_TOKEN": "f" * 64}
    arguments = [sys.executable, "-c", DRIVER, str(tmp_path), "a"]
    began = time.monotonic()
    driver = subprocess.run(arguments, env=wrong, capture_output=True, text=True, check=False)
    assert time.monotonic() - began < 15, "Ray itself takes 34 s"
    assert driver.stdout.startswith(f"Connecting to the Ray cluster at {nodes.address}")
    assert "ClusterRefused" in driver.stderr and "has another token" in driver.stderr
    assert "gcs_client.cc" not in driver.stderr and not begun(tmp_path, "a")
    assert not list((tmp_path / "run").glob("*"))
