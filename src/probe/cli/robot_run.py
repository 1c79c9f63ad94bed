"""`probe robot run`: an agent on a robot."""

from __future__ import annotations

import sys
from contextlib import closing
from pathlib import Path
from typing import Annotated

import tyro

from probe.api.agents import AgentName, make_agent
from probe.api.resources import cache_folder, everything
from probe.cli.metavars import Address
from probe.cli.numbers import check_numbers
from probe.cli.perception import PerceptionChoice
from probe.cli.robot_link import TOKEN_FILE, token_in
from probe.cli.robot_safety import COMMANDS, SafetyChoice, guarded
from probe.cli.screen import say
from probe.episodes.files import append_record, read_records
from probe.episodes.folder import RECORDS, start_folder
from probe.episodes.grading import question_of
from probe.episodes.perceptions import used_by
from probe.episodes.real import open_real_episode
from probe.episodes.run import act_out
from probe.errors import BadData
from probe.perception.choice import ideal
from probe.render.renderer import Renderer
from probe.runs.plan import RunOrder
from probe.runs.run import check_folder
from probe.station.remote import RobotStation, connected
from probe.tasks.suite_file import find_suite


def run(
    address: Address,
    suite: str,
    task: str,
    agent: AgentName = "scripted",
    seeing: Annotated[PerceptionChoice, tyro.conf.arg(name="")] = PerceptionChoice("segmenter"),  # noqa: B008
    safety: Annotated[SafetyChoice, tyro.conf.arg(name="")] = SafetyChoice(),  # noqa: B008
    run: int = 0,
    film: bool = False,
    token_file: Path = TOKEN_FILE,
    certificate: Path | None = None,
    out: Path = Path("outputs/robot"),
) -> None:
    """Let an agent answer a task's question on a robot whose table is laid like the task's.

    Args:
        address: Of the robot's bridge.
        suite: Whose task.
        task: Its id.
        agent: Who acts.
        seeing: What the tools see with.
        safety: How a person watches over the robot.
        run: Number of the agent's run at this task.
        film: Keep pictures of the arm in motion as well, for `probe film`.
        token_file: Has the bridge's token.
        certificate: Of the bridge, if no public authority vouches for it.
        out: Folder for the record and its pictures.
    """
    check_numbers({"--run": run, **safety.numbers})
    tasks, things = find_suite(suite), everything()
    asked, perceiver = tasks[task], seeing.perceiver()
    if perceiver is ideal:
        reason = "reads the simulation's labels, and a robot has none"
        raise BadData("--perception oracle", reason, "Say segmenter or enrolled")
    check_folder(out, tasks, RunOrder(agent, perception=used_by(perceiver)))
    start_folder(out, tasks)
    _check_new(out, task, agent, run)
    question = question_of(asked)
    say(question.text, *(f"{letter}: {text}" for letter, text in question.options))
    with (
        closing(
            connected(address, token_in(token_file), certificate, log=out / COMMANDS)
        ) as client,
        Renderer(cache_folder() / "light") as renderer,
    ):
        acting = make_agent(agent, asked, run, things, renderer)
        robot = RobotStation(client, asked.setup, asked.camera, slow=safety.slow_motions)
        with guarded(robot, safety, out) as station:
            keeps = robot.film if film else None
            episode = open_real_episode(asked, agent, station, perceiver, out, run, keeps)
            record = act_out(episode, question, acting)
    append_record(out / RECORDS, record)
    said = f"No answer: {record.end}"
    if record.answer is not None:
        meant = dict(question.options)[record.answer.choice]
        said = f"It answers {record.answer.choice}: {meant}"
    say(f"{said}{'' if record.fault is None else f' ({record.fault})'}. The record is in {out}")
    if record.fault is not None:
        sys.exit(1)


def _check_new(out: Path, task: str, agent: str, run: int) -> None:
    """See that the folder has no record of this run yet; reports take only one."""
    have = read_records(out / RECORDS) if (out / RECORDS).exists() else ()
    if any((it.task, it.agent, it.run) == (task, agent, run) and it.fault is None for it in have):
        reason = f"it has run {run} of {agent} at {task}"
        raise BadData(out / RECORDS, reason, f"Say --run {run + 1}, or another --out")
