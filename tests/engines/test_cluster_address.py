"""Whether a cluster answers is known before Ray is asked, which waits for minutes."""

from __future__ import annotations

import os
import socket
import subprocess
import sys
import time
from importlib.util import find_spec
from pathlib import Path

import pytest

from probe.engines.cluster_address import cluster_address
from probe.engines.cluster_watch import ClusterWatch
from probe.engines.ray_cluster import connected
from probe.engines.ray_errors import ClusterLost, ClusterRefused

# Other people's clusters on this machine are none of this test's.
DRIVER = """
import ray._private.services
ray._private.services.find_gcs_addresses = set
from probe.engines.ray_cluster import connected
with connected(print):
    pass
"""
# Not by an import: Ray reads its variables when it is imported.
needs_ray = pytest.mark.skipif(find_spec("ray") is None, reason="needs the extra [ray]")


@pytest.fixture(autouse=True)
def _token(monkeypatch):
    monkeypatch.setenv("RAY_AUTH_MODE", "token")
    monkeypatch.setenv("RAY_AUTH_TOKEN", "f" * 64)


@pytest.fixture
def deserted() -> str:
    """An address at which nobody listens."""
    with socket.create_server(("127.0.0.1", 0)) as free:
        return f"127.0.0.1:{free.getsockname()[1]}"


def refusal(temporary: Path) -> str:
    """What is said where RAY_ADDRESS isn't set, by a Ray with its notes in a folder."""
    known = {name: value for name, value in os.environ.items() if name != "RAY_ADDRESS"}
    ended = subprocess.run(
        [sys.executable, "-c", DRIVER],
        env={**known, "RAY_TMPDIR": str(temporary)},
        capture_output=True,
        text=True,
        check=False,
        timeout=30,
    )
    return ended.stderr


@pytest.mark.slow  # Ray comes with them
@needs_ray
def test_an_address_at_which_nobody_listens_is_refused_at_once(deserted, monkeypatch):
    monkeypatch.setenv("RAY_ADDRESS", deserted)
    told, began = list[str](), time.monotonic()
    reason = rf"{deserted} \(from RAY_ADDRESS\): no cluster answers there.*ray start --head"
    with pytest.raises(ClusterRefused, match=reason), connected(told.append):
        pass
    assert time.monotonic() - began < 5
    assert told == [f"Connecting to the Ray cluster at {deserted} (from RAY_ADDRESS)."]


@pytest.mark.parametrize("named", ["nowhere", "ray://head:10001", "head:", ":6379", "head:99999"])
def test_what_is_no_address_is_named(named, monkeypatch):
    monkeypatch.setenv("RAY_ADDRESS", named)
    with pytest.raises(ClusterRefused, match=rf"{named} \(from RAY_ADDRESS\): isn't HOST:PORT"):
        cluster_address()


@pytest.mark.slow  # Ray comes with them
@needs_ray
def test_a_stale_note_of_a_cluster_that_is_gone_is_named(deserted, tmp_path):
    note = tmp_path / "ray" / "ray_current_cluster"
    note.parent.mkdir()
    note.write_text(deserted)
    assert f"{deserted} (from {note}): no cluster answers there" in refusal(tmp_path)
    note.unlink()
    assert "no Ray runs here, and RAY_ADDRESS isn't set" in refusal(tmp_path)


def test_a_first_machine_is_lost_when_it_is_silent_for_long(monkeypatch):
    told = list[str]()
    with socket.create_server(("127.0.0.1", 0)) as first:
        monkeypatch.setenv("RAY_ADDRESS", f"127.0.0.1:{first.getsockname()[1]}")
        watch = ClusterWatch(cluster_address(), "outputs/x", told.append, every=0, patience=0.2)
        watch.look()
    watch.look()
    assert len(told) == 1 and "doesn't answer" in told[0]
    watch.look()
    time.sleep(0.3)
    with pytest.raises(ClusterLost, match=r"RAY_ADDRESS.*kept in outputs/x.*the same command"):
        watch.look()
    assert len(told) == 1


def test_a_first_machine_that_comes_back_is_waited_for_again(monkeypatch):
    told = list[str]()
    with socket.create_server(("127.0.0.1", 0)) as first:
        port = first.getsockname()[1]
    monkeypatch.setenv("RAY_ADDRESS", f"127.0.0.1:{port}")
    watch = ClusterWatch(cluster_address(), "outputs/x", told.append, every=0, patience=0.2)
    watch.look()
    with socket.create_server(("127.0.0.1", port)):
        time.sleep(0.3)
        watch.look()
    watch.look()
    assert len(told) == 2
