"""What a node of a cluster must have before it does a unit: the same program, the same assets."""

from __future__ import annotations

import hashlib
import os
from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import lru_cache
from pathlib import Path

import probe
from probe.assets.folders import cache_folder
from probe.engines.asset_bundle import AssetBundle
from probe.engines.result_store import ResultStore
from probe.errors import BadData


@dataclass(frozen=True)
class NodeSetup:
    """How a worker on a node prepares.

    Attributes:
        code: Of the driver's program; see code_digest().
        results: Where results go; a node must find `MARK` there.
        environment: Variables that name folders which all nodes see.
        bundles: Folders that nodes fetch, by the variable that names them.
    """

    code: str
    results: ResultStore
    environment: Mapping[str, str] = field(default_factory=dict[str, str])
    bundles: Mapping[str, AssetBundle] = field(default_factory=dict[str, AssetBundle])

    def prepare(self) -> None:
        """See that this machine can do the work, and set the variables.

        Raises:
            BadData: It has another program, or doesn't see the results or an asset.
            OutputFailed: Its disk is full.
        """
        if code_digest() != self.code:
            remedy = "Install the driver's version on every node"
            raise BadData(Path(probe.__file__).parent, "is another version of PROBE", remedy)
        if not self.results.has(MARK):
            remedy = "Say --store with an address that every node can write to, such as s3://..."
            raise BadData(self.results.url, "isn't the driver's folder on this node", remedy)
        for name, value in self.environment.items():
            if not Path(value).exists():
                raise BadData(value, f"isn't there on this node ({name})", "Say --store ADDRESS")
            os.environ[name] = value
        for name, bundle in self.bundles.items():
            os.environ[name] = str(bundle.fetch(cache_folder()))


MARK = "driver"
"""Key under which the driver writes who it is."""


@lru_cache(1)
def code_digest() -> str:
    """SHA-256 of this package's files."""
    content, root = hashlib.sha256(), Path(probe.__file__).parent
    for path in sorted(root.rglob("*")):
        if path.is_file() and "__pycache__" not in path.parts:
            content.update(path.relative_to(root).as_posix().encode())
            content.update(hashlib.sha256(path.read_bytes()).digest())
    return content.hexdigest()
