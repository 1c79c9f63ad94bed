"""`probe serve`: the five tools for any program that speaks MCP."""

from __future__ import annotations

from collections.abc import Generator
from contextlib import contextmanager
from functools import partial
from pathlib import Path
from typing import Annotated

import tyro

from probe.assets.library import Library
from probe.cli.numbers import check_numbers
from probe.cli.objects import all_objects, check
from probe.cli.perception import PerceptionChoice
from probe.cli.screen import warn
from probe.episodes.claimed_run import claimed_run
from probe.episodes.conditions import Conditions, RendererKind
from probe.episodes.episode import Episode
from probe.episodes.folder import start_folder
from probe.episodes.grading import question_of
from probe.episodes.perceptions import ORACLE_USED, used_by
from probe.episodes.play import open_episode
from probe.episodes.tool_errors import tool_errors
from probe.errors import MissingExtra, UnknownName
from probe.interfaces.session import Session
from probe.interfaces.words import question_text
from probe.perception.choice import Perceiver
from probe.render.renderer import Renderer
from probe.runs.plan import Job, RunOrder
from probe.runs.run import check_folder
from probe.runs.viewpoints import circumstances_of, renderer_of
from probe.scene.seeds import generator
from probe.tasks.suite import Suite, part
from probe.tasks.suite_file import find_suite
from probe.tasks.task import Task


def serve(
    suite: str = "demo",
    task: str | None = None,
    seed: int = 0,
    out: Path = Path("outputs/serve"),
    agent: str = "mcp",
    renderer: RendererKind = "own",
    seeing: Annotated[PerceptionChoice, tyro.conf.arg(name="")] = PerceptionChoice(),  # noqa: B008
) -> None:
    """Let another program use the tools on one task, over MCP on standard input and output.

    One process is one session: one client, one table, one episode. See docs/how-to/serve.md.

    Args:
        suite: One of the package ("v2", "demo"), or a file that `probe suite build` wrote.
        task: Id of a task of it; without it, the seed chooses.
        seed: Chooses a task.
        out: Folder that the record is added to; `probe report` shows it.
        agent: Who acts, for the record.
        renderer: What draws the pictures: as the task was frozen, or another, the same
            for all records of a folder; blender needs the extra of that name, and more time.
        seeing: What the tools see with, the same for all records of a folder; see
            docs/reference/perception.md.
    """
    try:
        from probe.interfaces.mcp_server import serve as serve_mcp
    except ImportError as error:
        raise MissingExtra("Serving the tools", "serve") from error
    check_numbers({"--seed": seed})
    perceiver = seeing.perceiver()
    tasks, used = find_suite(suite), used_by(perceiver)
    hand, conditions = tool_errors(
        tasks.headline, "own", Conditions(renderer=renderer), oracle=used == ORACLE_USED
    )
    order = RunOrder(agent, noise=hand, conditions=conditions, perception=used)
    chosen = _chosen(tasks, task, seed)
    check_folder(out, tasks, order)
    things = all_objects()
    with (
        Renderer(engine=renderer_of(chosen, conditions)) as drawing,
        _claimed(out, tasks, chosen, agent) as run,
    ):
        opening = partial(_open, part(tasks, chosen), things, drawing, order, perceiver, run)
        session = Session(opening, out)
        question = question_of(chosen)
        # Standard output is the protocol's. Some clients show no instructions to their model.
        warn(*question_text(question).splitlines())
        try:
            serve_mcp(session, question, chosen.scale)
        finally:
            session.close()


def _chosen(suite: Suite, task: str | None, seed: int) -> Task:
    tasks = {each.id: each for each in suite.tasks}
    if task is None:
        return suite.tasks[int(generator(seed, "serve").integers(len(suite.tasks)))]
    if task not in tasks:
        raise UnknownName("task", task, list(tasks))
    return tasks[task]


@contextmanager
def _claimed(out: Path, suite: Suite, task: Task, agent: str) -> Generator[int]:
    """The number of the session's run, in a folder that is made if need be."""
    start_folder(out, suite)
    with claimed_run(out, task.id, agent) as run:
        yield run


def _open(
    suite: Suite,
    things: Library,
    renderer: Renderer,
    order: RunOrder,
    perceiver: Perceiver,
    run: int,
) -> Episode:
    """Set the table of a suite's only task, with the luck of a run."""
    check(suite, things)
    (task,) = suite.tasks
    circumstances = circumstances_of(order, Job(task, run), things.assets)
    return open_episode(task, order.agent, things, renderer, circumstances, perceiver)
