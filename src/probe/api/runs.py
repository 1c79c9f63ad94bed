"""Many episodes into a folder of records, and records out of one."""

from __future__ import annotations

from contextlib import closing
from pathlib import Path

from probe.api.agents import SETTINGS, AgentName, make_agent
from probe.api.progress import Track, silent
from probe.api.resources import everything
from probe.engines.local import LocalEngine
from probe.episodes.conditions import AS_FROZEN
from probe.episodes.files import read_records as _read_records
from probe.episodes.folder import RECORDS
from probe.episodes.noise import Noise
from probe.episodes.record import EpisodeRecord
from probe.episodes.tool_errors import NoiseChoice, tool_errors
from probe.runs.plan import RunOrder
from probe.runs.run import begun, work
from probe.runs.work import WorkerSetup
from probe.tasks.suite import Suite, check_objects


def run(
    suite: Suite,
    out: str | Path,
    *,
    agent: AgentName = "scripted",
    runs: int = 1,
    noise: Noise | NoiseChoice = "own",
    workers: int = 1,
    track: Track = silent,
) -> list[EpisodeRecord]:
    """Run a built-in agent on every task of a suite; continues where it stopped.

    Args:
        suite: See load_suite().
        out: Folder for the records; episodes that it holds already are not run again.
        agent: "scripted", "random", or one of the baselines.
        runs: Episodes of each task.
        noise: How far the hand misses where it is sent: "none", "paper", or a Noise. "own": hand
            and detector err as in the suite's headline setting, or not at all if it has none.
        workers: Processes.
        track: Watches the work.

    Returns:
        All records of the folder, in the order in which they were written. An episode that failed
        through no fault of the agent has `end == "fault"`; calling again repeats it.

    Raises:
        BadData: The folder is about another suite, or was run under other conditions.
        OutputFailed: The folder can't be written.
    """
    folder, things = Path(out), everything()
    check_objects(suite, things)
    errors = tool_errors(suite.headline, noise, AS_FROZEN, setting=SETTINGS[agent])
    order = RunOrder(agent, runs, *errors)
    setup = WorkerSetup(order, everything, make_agent)
    with (
        begun(folder, suite, order) as start,
        closing(work(folder, start, setup, LocalEngine(workers))) as results,
    ):
        for _ in track(results, f"{agent} at work"):
            pass
    return read_records(folder)


def read_records(path: str | Path) -> list[EpisodeRecord]:
    """The records of a folder that was run, or of a file of records.

    Raises:
        BadData: The file is missing, or a line of it is cut off, changed, or no record.
    """
    found = Path(path)
    return _read_records(found / RECORDS if found.is_dir() else found)
