"""Does this machine have what some commands need: assets, keys, a server, a sandbox?"""

from __future__ import annotations

import os
from collections.abc import Iterator
from http.client import HTTPException
from urllib.error import HTTPError
from urllib.request import Request, urlopen

from probe.agents.external import landlock
from probe.api.resources import assets_folder, library_folder
from probe.cli.address import check_address
from probe.cli.health.requirement import Requirement

_KEYS = {
    "OPENAI_API_KEY": "OpenAI's models, and servers that ask for a key",
    "ANTHROPIC_API_KEY": "Anthropic's models",
    "GOOGLE_API_KEY": "Google's models",
    "XAI_API_KEY": "xAI's models",
}
_SECONDS = 3.0


def around_findings(endpoint: str | None) -> Iterator[Requirement]:
    """Assets, keys, a model's server and what keeps agents in files apart.

    Args:
        endpoint: Address of a server; by default what VLLM_BASE_URL names.

    Raises:
        BadData: It is no address.
    """
    yield from _folders()
    for name, use in _KEYS.items():
        there = bool(os.environ.get(name))
        # A key's value is never shown.
        yield Requirement(name, there, "set" if there else "not set", use, f"export {name}=KEY")
    check_address(endpoint)
    yield _server(endpoint or os.environ.get("VLLM_BASE_URL"))
    found = landlock.version()
    words = f"Landlock, version {found}" if found else "this kernel has no Landlock"
    use = "keeping agents in files from other files (docs/reference/agents.md)"
    yield Requirement("sandbox", bool(found), words, use, "uname -r  # Linux 5.13 or newer has it")


def _folders() -> Iterator[Requirement]:
    assets = assets_folder()
    scans = assets is not None and (assets / "scans").is_dir()
    words = "not set" if assets is None else f"{assets}{'' if scans else ' has no folder scans'}"
    use = "scans: suite v1-scans, --pool scans"
    yield Requirement("PROBE_ASSETS", scans, words, use, "probe assets fetch v1-scans")
    own = library_folder()
    words = str(own) if own.is_dir() else f"none yet in {own}"
    use = "tasks about your own things: --pool own"
    yield Requirement("own objects", own.is_dir(), words, use, "probe assets add --help")


def _server(address: str | None) -> Requirement:
    use = "a model on a server of your own (docs/how-to/models.md)"
    start = "probe doctor --endpoint http://localhost:8000/v1"
    if not address:
        return Requirement("model server", False, "no --endpoint and no VLLM_BASE_URL", use, start)
    key = os.environ.get("OPENAI_API_KEY") or "none"
    asked = Request(f"{address.rstrip('/')}/models", headers={"Authorization": f"Bearer {key}"})
    try:
        with urlopen(asked, timeout=_SECONDS):
            return Requirement("model server", True, f"{address} answers", use)
    except HTTPError as error:
        words = f"{address} answers with status {error.code} to /models"
        return Requirement("model server", False, words, use, f"{start}  # is the path right?")
    except (OSError, HTTPException, ValueError) as error:
        reason = getattr(error, "reason", None) or error
        words = f"{address} doesn't answer: {reason}"
        return Requirement("model server", False, words, use, f"{start}  # after starting it")
