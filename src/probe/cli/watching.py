"""`probe run --watch`: a page that shows the tables of a run for as long as it lasts."""

from __future__ import annotations

from collections.abc import Generator
from contextlib import contextmanager
from pathlib import Path
from tempfile import TemporaryDirectory

from probe.cli.screen import say
from probe.episodes.folder import RECORDS
from probe.errors import MissingExtra
from probe.tasks.suite import Suite


@contextmanager
def watching(
    out: Path, suite: Suite, agent: str, setting: str, total: int, *, on: bool
) -> Generator[Path | None]:
    """Serve the page as long as the block lasts; gives the folder that workers write to.

    Args:
        out: Folder of the records.
        suite: What is asked.
        agent: Name of the agent in the records.
        setting: How it may answer; empty for agents without a model.
        total: Episodes that there are to be.
        on: Whether anybody watches; else the folder is None.
    """
    if not on:
        yield None
        return
    try:
        from probe.interfaces.human.server import served
        from probe.interfaces.watch.app import WatchedRun, app_of
        from probe.interfaces.watch.progress import RecordCount
    except ImportError as error:
        raise MissingExtra("A page to watch", "human") from error
    with TemporaryDirectory(prefix="probe-tables-") as folder:
        who = f"{agent} ({setting})" if setting else agent
        count = RecordCount(out / RECORDS, agent, setting)
        run = WatchedRun(suite.name, who, total, count, Path(folder))
        with served(app_of(run), 0) as address:
            say(f"Watch it at {address} in a browser on this machine.")
            yield Path(folder)
