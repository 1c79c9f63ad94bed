"""Who is let in: an agent of a file, with what it is allowed."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from probe.agents.external.process import AgentFailed, AgentProcess
from probe.agents.external.protocol import AgentReady, Confinement, Opening
from probe.agents.external.readable_paths import reach
from probe.agents.external.sandbox import AgentFile, Sandbox
from probe.errors import BadData

_GB = 10**9
WORDS = 1000
"""Characters of somebody else's words that are kept of what went wrong."""


@dataclass(frozen=True)
class FileAgentFactory:
    """What makes an agent of a file for each episode; a value that workers can be sent.

    Attributes:
        file: Where it comes from.
        sandbox: What it is allowed.
        hidden: Files and folders that it must not read.
        pictures: Whether it looks at pictures.
        log: Where what it prints goes; None for nowhere.
    """

    file: AgentFile
    sandbox: Sandbox = Sandbox()
    hidden: tuple[Path, ...] = ()
    pictures: bool = False
    log: Path | None = None

    def opening(self, seed: int = 0) -> Opening:
        """What its process is told first."""
        files = self.sandbox.files
        found = reach(self.file.path, files, self.hidden)
        return Opening(
            file=str(self.file.path),
            name=self.file.name,
            seed=seed,
            memory=round(self.sandbox.memory_gb * _GB),
            network=self.sandbox.network,
            readable=found.whole,
            listable=found.names,
            modules=tuple(str(path.resolve()) for path in files if path.is_dir()),
        )


def introduced(invitation: FileAgentFactory) -> tuple[Confinement, AgentReady]:
    """Make the agent once: what its process is kept from, its name, and whether it sees.

    Raises:
        BadData: There is no agent in the file.
        WorkerDied: A process for it couldn't be set up.
    """
    try:
        process = AgentProcess(invitation.opening())
    except AgentFailed as failure:
        remedy = "See docs/reference/agents.md"
        raise BadData(invitation.file.path, printable(str(failure))[:WORDS], remedy) from failure
    process.close()
    return process.confined, process.ready


def printable(text: str) -> str:
    """Somebody else's text without what a terminal would obey."""
    return "".join(sign if sign.isprintable() or sign in "\n\t" else "\ufffd" for sign in text)
