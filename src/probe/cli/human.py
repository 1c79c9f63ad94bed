"""`probe human`: people answer the questions of a suite in a browser, with an agent's tools."""

from __future__ import annotations

import signal
import threading
from collections.abc import Generator
from contextlib import closing, contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from typing import Annotated

import tyro

from probe.api.resources import cache_folder
from probe.assets.library import Library
from probe.cli.metavars import SuiteName
from probe.cli.numbers import check_numbers
from probe.cli.objects import all_objects, check
from probe.cli.perception import PerceptionChoice
from probe.cli.screen import say
from probe.episodes.conditions import Conditions, RendererKind
from probe.episodes.episode import Episode
from probe.episodes.files import read_records, set_aside_cut
from probe.episodes.folder import RECORDS, check_suite, claim_setting, occupied
from probe.episodes.perceptions import ORACLE_USED, used_by
from probe.episodes.play import open_episode
from probe.episodes.record import EpisodeRecord
from probe.episodes.remarks import REMARKS
from probe.episodes.tool_errors import NoiseChoice, tool_errors
from probe.errors import MissingExtra
from probe.interfaces.human.feedback import Feedback, explain
from probe.interfaces.human.practice import practice_for
from probe.interfaces.human.session_store import UNFINISHED
from probe.interfaces.human.table_places import TablePlace
from probe.perception.choice import Perceiver, ideal
from probe.render.renderers import Renderers
from probe.runs.plan import Job, RunOrder
from probe.runs.run import check_settings
from probe.runs.viewpoints import circumstances_of, renderer_of
from probe.tasks.suite import Suite
from probe.tasks.suite_file import find_suite
from probe.tasks.task import Task

SETTING = "human"


def human(
    suite: SuiteName,
    out: Path = Path("outputs/human"),
    port: int = 8137,
    noise: NoiseChoice = "own",
    seats: int = 4,
    renderer: RendererKind = "own",
    seeing: Annotated[PerceptionChoice, tyro.conf.arg(name="")] = PerceptionChoice(),  # noqa: B008
) -> None:
    """Let people answer in a browser on this machine, with what agents see and can do.

    Each person enters a name, may practise, and goes through the suite in its order. Ctrl-C ends
    it; the same command continues, with every table as it was left. See docs/how-to/human.md.

    Args:
        suite: "v2", "v1", "demo", or a file that `probe suite build` wrote.
        out: Folder that the records are added to; `probe report` shows it.
        port: Where to listen; 0 for any that is free.
        noise: How far the hand errs, as in `probe run`; the same for all records of a folder.
        seats: Tables that may stand at once; each takes some memory.
        renderer: What draws the pictures, the same for all records of a folder: as the tasks were
            frozen, or another; blender needs the extra of that name, and more time.
        seeing: What the tools see with, the same for all records of a folder; see
            docs/reference/perception.md.
    """
    check_numbers({"--port": port, "--seats": seats})
    perceiver = seeing.perceiver()
    try:
        from probe.interfaces.human.server import run
        from probe.interfaces.human.session_manager import SessionManager
    except ImportError as error:
        raise MissingExtra("The human seat", "human") from error
    tasks, things = find_suite(suite), all_objects()
    practice = practice_for(tasks)
    for each in filter(None, (tasks, practice)):
        check(each, things)
    # A polite end in any case: whoever is in the middle of a question can go on with it.
    signal.signal(signal.SIGTERM, signal.default_int_handler)
    used = used_by(perceiver)
    hand, conditions = tool_errors(
        tasks.headline, noise, Conditions(renderer=renderer), oracle=used == ORACLE_USED
    )
    order = RunOrder("", noise=hand, conditions=conditions, perception=used)
    resources = HumanResources(things, order, perceiver)
    resources.require()
    with (
        taken_up(out, tasks, order),
        closing(SessionManager(tasks, out, resources.furnish, seats, practice)) as sessions,
    ):
        try:
            run(sessions, port, _tell)
        except KeyboardInterrupt:
            say("Waiting until no arm moves any more.")
    say(f"Records are in {out}; the same command goes on.")


@contextmanager
def taken_up(out: Path, suite: Suite, order: RunOrder) -> Generator[None]:
    """A folder that people's records are added to, by this process alone.

    A line that was cut off when an earlier one was killed is moved to a file beside it.

    Raises:
        BadData: It is about another suite, was played under other conditions, holds records of
            others or of tools of another version, or another run is at work there.
        OutputFailed: It can't be written.
    """
    check_suite(out, suite)
    with occupied(out, suite):
        claim_setting(out, SETTING)
        for name in (RECORDS, REMARKS):
            cut = set_aside_cut(out / name)
            if cut is not None:
                say(f"The last line of {name} was cut off: moved to {cut}.")
        for path in (out / RECORDS, *sorted((out / UNFINISHED).glob("*.jsonl"))):
            if path.exists():
                check_settings(path, read_records(path), order)
        yield


def _tell(address: str) -> None:
    say(f"Open {address} in a browser on this machine; Ctrl-C ends it.")


@dataclass(frozen=True)
class HumanResources:
    """What tables are made of.

    Attributes:
        things: Has the suite's objects; it isn't made for several threads.
        order: Under which conditions people play.
        perceiver: What the tools see with; the order says the same.
    """

    things: Library
    order: RunOrder
    perceiver: Perceiver = ideal
    _lock: threading.Lock = field(default_factory=threading.Lock, init=False)

    def require(self) -> None:
        """See that what is to draw can be started here, before anybody sits down.

        Raises:
            NoGraphicsDriver, MissingExtra: It can't.
        """
        with Renderers() as renderers:
            renderers.require(self.order.conditions.renderer)

    @contextmanager
    def furnish(self) -> Generator[TablePlace]:
        """Renderers for one place of a seat, and what is done with them."""
        with Renderers(cache_folder() / "light") as renderers:

            def set_table(task: Task, name: str, run: int) -> Episode:
                with self._lock:
                    job = Job(task, run)
                    circumstances = circumstances_of(self.order, job, self.things.assets)
                    renderer = renderers[renderer_of(task, self.order.conditions)]
                    return open_episode(
                        task, name, self.things, renderer, circumstances, self.perceiver
                    )

            def explained(task: Task, record: EpisodeRecord) -> Feedback:
                with self._lock:
                    renderer = renderers[renderer_of(task, self.order.conditions)]
                    return explain(task, record, self.things, renderer)

            yield TablePlace(set_table, explained)
