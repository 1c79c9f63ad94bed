"""Agents that installed packages offer: entry points of the group `probe.agents`."""

from __future__ import annotations

from importlib.machinery import PathFinder
from importlib.metadata import EntryPoint, entry_points
from pathlib import Path

from probe.agents.external.sandbox import AgentFile
from probe.errors import BadData

GROUP = "probe.agents"


def installed_agents() -> dict[str, EntryPoint]:
    """The entry points, by name; nothing of the packages is imported."""
    return {found.name: found for found in entry_points(group=GROUP)}


def file_of(found: EntryPoint) -> AgentFile:
    """The file and the class that an entry point names ("package.module:Class").

    The file is looked up, not imported: that is left to the agent's own process.

    Raises:
        BadData: There is no such file.
    """
    path: list[str] | None = None
    file: str | None = None
    for part in found.module.split("."):
        spec = PathFinder.find_spec(part, path)
        if spec is None:
            break
        file = spec.origin
        path = list(spec.submodule_search_locations or ())
    else:
        if file is not None and file.endswith(".py"):
            return AgentFile(Path(file).resolve(), found.attr or None)
    said = f"{found.name} = {found.value}"
    raise BadData(said, "names no Python file that is here", "Install its package again")
