"""`probe human`: people answer the questions of a suite in a browser, with an agent's tools."""

from __future__ import annotations

import signal
import threading
from collections.abc import Callable, Generator
from contextlib import closing, contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from typing import Annotated

import tyro

from probe.api.resources import cache_folder, everything
from probe.assets.library import Library
from probe.cli.numbers import check_numbers
from probe.cli.screen import say
from probe.episodes.circumstances import Circumstances
from probe.episodes.episode import Episode
from probe.episodes.files import read_records, set_aside_cut
from probe.episodes.folder import RECORDS, check_suite, check_tools_of, claim_setting, occupied
from probe.episodes.noise import NOISES, Noise, NoiseName
from probe.episodes.play import open_episode
from probe.episodes.remarks import REMARKS
from probe.errors import BadData, MissingExtra
from probe.interfaces.human.session_store import UNFINISHED
from probe.render.renderer import Renderer
from probe.tasks.suite import Suite, check_objects
from probe.tasks.suite_file import find_suite
from probe.tasks.task import Task

SETTING = "human"


def human(
    suite: Annotated[str, tyro.conf.Positional],
    out: Path = Path("outputs/human"),
    port: int = 8137,
    noise: NoiseName = "none",
    seats: int = 4,
) -> None:
    """Let people answer in a browser on this machine, with what agents see and can do.

    Each person enters a name and goes through the suite in its order. Ctrl-C ends it; the same
    command continues, with every table as it was left. See docs/how-to/human.md.

    Args:
        suite: "v1", "demo", or a file that `probe suite build` wrote.
        out: Folder that the records are added to; `probe report` shows it.
        port: Where to listen; 0 for any that is free.
        noise: How far the hand errs, as in `probe run`; the same for all records of a folder.
        seats: Tables that may stand at once; each takes some memory.
    """
    check_numbers({"--port": port, "--seats": seats})
    try:
        from probe.interfaces.human.server import run
        from probe.interfaces.human.session_manager import SessionManager
    except ImportError as error:
        raise MissingExtra("The human seat", "human") from error
    tasks, things = find_suite(suite), everything()
    check_objects(tasks, things)
    # A polite end in any case: whoever is in the middle of a question can go on with it.
    signal.signal(signal.SIGTERM, signal.default_int_handler)
    resources = HumanResources(things, NOISES[noise])
    with (
        taken_up(out, tasks, NOISES[noise]),
        closing(SessionManager(tasks, out, resources.furnish, seats)) as sessions,
    ):
        try:
            run(sessions, port, _tell)
        except KeyboardInterrupt:
            say("Waiting until no arm moves any more.")
    say(f"Records are in {out}; the same command goes on.")


@contextmanager
def taken_up(out: Path, suite: Suite, noise: Noise) -> Generator[None]:
    """A folder that people's records are added to, by this process alone.

    A line that was cut off when an earlier one was killed is moved to a file beside it.

    Raises:
        BadData: It is about another suite, has another noise, holds records of others or of tools
            of another version, or another run is at work there.
        OutputFailed: It can't be written.
    """
    check_suite(out, suite)
    with occupied(out, suite):
        claim_setting(out, SETTING)
        for name in (RECORDS, REMARKS):
            cut = set_aside_cut(out / name)
            if cut is not None:
                say(f"The last line of {name} was cut off: moved to {cut}.")
        _check_earlier(out, noise)
        yield


def _check_earlier(out: Path, noise: Noise) -> None:
    records = read_records(out / RECORDS) if (out / RECORDS).exists() else []
    check_tools_of(out / RECORDS, records)
    for path in sorted((out / UNFINISHED).glob("*.jsonl")):
        check_tools_of(path, read_records(path))
    if any(record.noise != noise for record in records):
        raise BadData(out, "holds records with another noise", "Choose another folder")


def _tell(address: str) -> None:
    say(f"Open {address} in a browser on this machine; Ctrl-C ends it.")


@dataclass(frozen=True)
class HumanResources:
    """What tables are made of.

    Attributes:
        things: Has the suite's objects; it isn't made for several threads.
        noise: How far the hand errs.
    """

    things: Library
    noise: Noise
    _lock: threading.Lock = field(default_factory=threading.Lock, init=False)

    @contextmanager
    def furnish(self) -> Generator[Callable[[Task, str, int], Episode]]:
        """A renderer for one seat, and a function that sets tables with it."""
        with Renderer(cache_folder() / "light") as renderer:

            def set_table(task: Task, name: str, run: int) -> Episode:
                with self._lock:
                    circumstances = Circumstances(run, self.noise)
                    return open_episode(task, name, self.things, renderer, circumstances)

            yield set_table
