"""Which packages that the core and each extra ask for are installed. Imports none of them."""

from __future__ import annotations

import re
import sys
from collections.abc import Iterator
from importlib.metadata import PackageNotFoundError, requires, version

from probe.cli.health.requirement import Requirement

PACKAGE = "probe-vqa"
EXTRAS = {
    "bench": "models behind OpenAI's, Anthropic's and Google's interfaces, and your own server",
    "grok": "xAI's models",
    "models": "detectors and pointers behind OpenAI's protocol, without the harness",
    "export": "suites as data sets of Hugging Face's form",
    "human": "people who answer in a browser",
    "serve": "the tools for other programs, over MCP",
    "segment": "masks from colours and depth (--perception segmenter)",
    "sam3": "masks with SAM 3's weights",
    "blender": "pictures by Blender",
    "film": "films of episodes, and clips in reports",
    "rerun": "recordings of episodes for Rerun's viewer (`probe film --format rrd`)",
    "graspgen": "grasps from a GraspGen server",
    "robot": "robots behind bridges, and their twin",
    "ray": "many machines (--on ray)",
    "shortcuts": "classifiers that look for shortcuts in suites",
    "train": "training a model and serving it",
}
"""What users' extras are for."""

_NAME = re.compile(r"[A-Za-z0-9][A-Za-z0-9._-]*")
_EXTRA = re.compile(r"""extra\s*==\s*['"]([\w-]+)""")
_PYTHON = re.compile(r"""python_version\s*==\s*['"]([\d.]+)""")


def installing(extra: str = "") -> str:
    """The command that installs the core or an extra, in the clone's folder."""
    what = f".[{extra}]" if extra else "."
    return f"python3 -m pip --python .venv/bin/python install -e '{what}'"


def lacking(extra: str = "") -> list[str]:
    """Packages that the core, or an extra, asks for and that aren't here."""
    try:
        asked = requires(PACKAGE) or []
    except PackageNotFoundError:
        return [PACKAGE]
    mine = [it for it in asked if _extra_of(it) == extra]
    return [_NAME.match(it)[0] for it in mine if not _is_here(it)]  # pyright: ignore[reportOptionalSubscript]


def extra_findings() -> Iterator[Requirement]:
    """Of each extra whether it is installed."""
    for extra, use in EXTRAS.items():
        if missing := lacking(extra):
            found = f"missing: {', '.join(missing)}"
            yield Requirement(f"extra {extra}", False, found, use, installing(extra))
        else:
            yield Requirement(f"extra {extra}", True, "installed", use)


def _extra_of(requirement: str) -> str:
    found = _EXTRA.search(requirement)
    return found[1] if found else ""


def _is_here(requirement: str) -> bool:
    python = _PYTHON.search(requirement)
    name = _NAME.match(requirement)
    if name is None or (python and not sys.version.startswith(f"{python[1]}.")):
        return python is None
    try:
        version(name[0])
    except PackageNotFoundError:
        return False
    return True
