"""What a run ends with: a line for people, or JSON for scripts."""

from __future__ import annotations

import json
from collections.abc import Generator
from contextlib import contextmanager, redirect_stdout
from dataclasses import asdict, dataclass
from pathlib import Path

from probe.cli.screen import say, standard_error
from probe.episodes.folder import RECORDS


@dataclass(frozen=True)
class RunSummary:
    """What a run came to.

    Attributes:
        suite: Name of the suite.
        tasks: How many of its tasks were asked for.
        episodes: How many episodes were asked for of this shard, earlier ones included.
        missing: How many of them failed through no fault of the agent.
        records: File of the records.
    """

    suite: str
    tasks: int
    episodes: int
    missing: int
    records: str


@contextmanager
def only_json(wanted: bool) -> Generator[None]:
    """Let all that is said meanwhile go to standard error, if JSON alone is wanted."""
    if not wanted:
        yield
        return
    with redirect_stdout(standard_error()):
        yield


def tell(found: RunSummary, out: Path, *, as_json: bool) -> None:
    """Say where the records are, or print the summary as one line of JSON."""
    if as_json:
        say(json.dumps(asdict(found)))
    else:
        say(f"Records are in {out / RECORDS}; `probe report {out}` shows them.")
