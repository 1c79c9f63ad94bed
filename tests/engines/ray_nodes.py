"""A Ray cluster of two nodes on this machine, for tests."""

from __future__ import annotations

import os
import secrets
import shutil
import signal
import subprocess
import sys
import tempfile
from collections.abc import Generator
from contextlib import contextmanager
from dataclasses import dataclass, field
from importlib import import_module
from importlib.util import find_spec
from pathlib import Path

import psutil
import pytest

import probe
from free_ports import free_ports

TESTS = Path(__file__).resolve().parents[1]
MODULES = f"{Path(probe.__file__).parents[1]}{os.pathsep}{TESTS}"
"""PYTHONPATH with the program that runs here, and the tests' jobs."""
COMPUTED = (
    *("bodies", "forms", "specs", "fingerprints", "covers", "footprints", "palettes"),
    *("tables", "light"),
)
RAY = Path(sys.executable).with_name("ray")


@dataclass
class Nodes:
    """Two nodes with a core each; both can be killed and started again.

    Attributes:
        address: Of the head.
        token: Lets one in.
        folder: Of Ray's own files.
        objects: Address of an object store that speaks S3's protocol; empty for none.
        cache: What has been computed already, which each node's cache links to.
    """

    address: str
    token: str
    folder: Path
    objects: str
    cache: Path | None = None
    first: list[psutil.Process] = field(default_factory=list)
    second: list[psutil.Process] = field(default_factory=list)

    @property
    def environment(self) -> dict[str, str]:
        """What a driver and a node need to be let in."""
        return {
            "RAY_ADDRESS": self.address,
            "RAY_AUTH_MODE": "token",
            "RAY_AUTH_TOKEN": self.token,
            "RAY_USAGE_STATS_ENABLED": "0",
            "AWS_ENDPOINT_URL": self.objects,
            "AWS_ACCESS_KEY_ID": "anybody",
            "AWS_SECRET_ACCESS_KEY": "anything",
        }

    def start(self, *role: str, **more: str) -> list[psutil.Process]:
        """Start a node; its processes."""
        before = set(psutil.pids())
        subprocess.run(
            [RAY, "start", *role, "--num-cpus", "1", "--disable-usage-stats"],
            env={**os.environ, **self.environment, "PYTHONPATH": MODULES, **more},
            check=True,
            capture_output=True,
        )
        port = self.address.rpartition(":")[2]
        new = [it for it in psutil.process_iter() if it.pid not in before]
        return [process for process in new if _tells(process, port)]

    def start_first(self) -> None:
        """Start the head."""
        head = ("--head", "--include-dashboard=false", "--temp-dir", str(self.folder))
        cache = self._cache("cache-1")
        port = self.address.rpartition(":")[2]
        self.first = self.start(*head, "--port", port, XDG_CACHE_HOME=cache)

    def add_second(self, cache: str = "cache-2") -> None:
        """Start the second node; a new cache is in a folder of its own."""
        self.second = self.start("--address", self.address, XDG_CACHE_HOME=self._cache(cache))

    def _cache(self, name: str) -> str:
        """A node's own folder; in it are links to what was computed, and nothing of a bundle."""
        for kind in COMPUTED:
            there = self.folder / name / "probe" / kind
            if self.cache and (self.cache / kind).is_dir() and not there.exists():
                shutil.copytree(self.cache.resolve() / kind, there, copy_function=os.symlink)
        return str(self.folder / name)

    def kill_first(self) -> None:
        """End all of the head's processes at once, its workers too."""
        for process in self.first:
            _kill(process)
        self.first = []

    def kill_second(self) -> None:
        """End all of the second node's processes at once, its workers too."""
        for process in self.second:
            _kill(process)
        self.second = []


@contextmanager
def two_nodes(objects: str = "", cache: Path | None = None) -> Generator[Nodes]:
    """Start them; end all of Ray that was started here.

    Args:
        objects: Address of an object store that speaks S3's protocol.
        cache: What has been computed already, which each node's cache links to; None for an
            empty cache for each.
    """
    port = free_ports()
    folder = Path(tempfile.mkdtemp(prefix="ray-"))
    nodes = Nodes(f"127.0.0.1:{port}", secrets.token_hex(32), folder, objects, cache)
    try:
        nodes.start_first()
        nodes.add_second()
        yield nodes
    finally:
        nodes.kill_second()
        nodes.kill_first()
        shutil.rmtree(folder, ignore_errors=True)


@contextmanager
def nodes_and_store(cache: Path | None = None) -> Generator[Nodes]:
    """Two nodes, and a local server of an object store for them; skips where Ray isn't there.

    Args:
        cache: What has been computed already, which each node's cache links to; None for an
            empty cache for each.
    """
    # Not by an import: Ray reads its variables when it is imported.
    if find_spec("ray") is None:
        pytest.skip("needs the extra [ray]; make test-slow installs it")
    server = import_module("moto.server").ThreadedMotoServer(port=0, verbose=False)
    server.start()
    host, port = server.get_host_and_port()
    # A file system that was opened for an earlier server is handed out again else.
    import_module("s3fs").S3FileSystem.clear_instance_cache()
    try:
        with two_nodes(f"http://{host}:{port}", cache) as started:
            yield started
    finally:
        server.stop()


def _tells(process: psutil.Process, port: str) -> bool:
    """Whether a process was told this port, as all of one cluster are."""
    try:
        return port in " ".join(process.cmdline())
    except psutil.Error:
        return False


def _kill(process: psutil.Process) -> None:
    try:
        family = [process, *process.children(recursive=True)]
    except psutil.NoSuchProcess:
        return
    for one in family:
        try:
            one.send_signal(signal.SIGKILL)
        except psutil.NoSuchProcess:
            continue
