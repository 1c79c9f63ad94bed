"""`probe robot session`: agents compared on a robot, on tables that a person lays."""

from __future__ import annotations

from collections.abc import Callable, Generator, Mapping
from contextlib import AbstractContextManager, closing, contextmanager
from pathlib import Path
from typing import Annotated

import tyro

from probe.agents.external.sandbox import Sandbox
from probe.api.resources import cache_folder, everything
from probe.cli.file_agents import who_acts
from probe.cli.metavars import Address, File, Folder
from probe.cli.numbers import check_numbers
from probe.cli.operator import TerminalOperator
from probe.cli.perception import PerceptionChoice
from probe.cli.robot_link import TOKEN_FILE, token_in
from probe.cli.robot_safety import COMMANDS, SafetyChoice, guarded
from probe.cli.screen import say
from probe.episodes.files import set_aside_cut
from probe.episodes.folder import RECORDS, check_suite, occupied
from probe.episodes.ordered import note_ordered
from probe.episodes.perceptions import used_by
from probe.errors import BadData, Unfinished
from probe.render.renderer import Renderer
from probe.runs.plan import RunOrder
from probe.runs.run import check_folder
from probe.runs.session.events import Begun
from probe.runs.session.log import LOG
from probe.runs.session.plan import SessionPlan, read_plan, tasks_of
from probe.runs.session.resources import Robot, SessionResources
from probe.runs.session.session import RobotSession
from probe.runs.session.verify import account_of
from probe.runs.work import AgentOf
from probe.station.remote import RobotStation, connected
from probe.tasks.suite import Suite
from probe.tasks.suite_file import content_hash, find_suite
from probe.tasks.task import Task

OVER = "Each was interrupted as often as a session tries it; play its task in a new session."
"""What to do about episodes that a session which is over lacks."""


def session(
    address: Address,
    plan: File,
    safety: Annotated[SafetyChoice, tyro.conf.arg(name="")] = SafetyChoice(),  # noqa: B008
    film: bool = False,
    token_file: Path = TOKEN_FILE,
    certificate: Path | None = None,
    out: Path = Path("outputs/session"),
) -> None:
    """Compare agents on a robot, on tables that you lay; the same command goes on where it stopped.

    See docs/how-to/robot-session.md. Ctrl-C pauses.

    Args:
        address: Of the robot's bridge.
        plan: The session's file.
        safety: How a person watches over the robot while an agent acts.
        film: Keep pictures of the arm in motion as well, for `probe film`.
        token_file: Has the bridge's token.
        certificate: Of the bridge, if no public authority vouches for it.
        out: Folder for the log, the records and their pictures.
    """
    check_numbers(safety.numbers)
    planned, token = read_plan(plan), token_in(token_file)
    suite, things = tasks_of(planned, find_suite(planned.suite)), everything()
    perceiver = PerceptionChoice(planned.perception, planned.enrolment).perceiver()
    order = RunOrder("", perception=used_by(perceiver))
    with _taken_up(out, suite, order), Renderer(cache_folder() / "light") as renderer:
        agents = _agents(planned, out)
        set_aside_cut(out / RECORDS)
        for name in agents:
            note_ordered(out, name, "", planned.runs)
        operator = TerminalOperator()
        robot = _robot_at(address, token, certificate, safety, out, film=film)
        its = SessionResources(suite, agents, robot, perceiver, things, renderer, operator, out)
        begun = Begun(plan=planned, agents=tuple(agents), suite=content_hash(suite))
        try:
            RobotSession(begun, its).run()
        except KeyboardInterrupt:
            say("Paused. The same command goes on.")
            return
    _tell(out)


@contextmanager
def _taken_up(out: Path, suite: Suite, order: RunOrder) -> Generator[None]:
    """A folder for this process alone, if its records may stand beside what is played now."""
    check_suite(out, suite)
    with occupied(out, suite):
        check_folder(out, suite, order)
        yield


def verify_session(out: Folder) -> None:
    """Check a session's folder: that no truth, record, order or verdict was changed.

    Args:
        out: The folder.
    """
    _tell(out)


def _tell(out: Path) -> None:
    account = account_of(out)
    if account.amiss:
        more = f", and {len(account.amiss) - 1} more things" if account.amiss[1:] else ""
        reason = f"{account.amiss[0]}{more}: this session proves nothing"
        raise BadData(out / LOG, reason, "Keep it, and find out who changed it")
    say(
        f"{account.results} of {account.wanted} episodes have a result; {account.interrupted} were "
        f"interrupted and count for nothing. {account.seals} sealed truths were opened; all fit."
    )
    missing = account.wanted - account.results
    if missing or not account.finished:
        remedy = OVER if account.finished else "The session isn't over."
        raise Unfinished(missing, account.wanted, "episodes", remedy)


def _agents(plan: SessionPlan, out: Path) -> Mapping[str, AgentOf]:
    """What makes each agent, by its name, in the plan's order."""
    made = [who_acts(agent, None, Sandbox(), plan.suite, out) for agent in plan.agents]
    names = [name for name, _ in made]
    if len(set(names)) < len(names):
        raise BadData("agents", f"two are called {names}", "Give their classes different names")
    return dict(made)


def _robot_at(
    address: str,
    token: str,
    certificate: Path | None,
    safety: SafetyChoice,
    out: Path,
    *,
    film: bool,
) -> Callable[[Task], AbstractContextManager[Robot]]:
    @contextmanager
    def robot(task: Task) -> Generator[Robot]:
        with closing(connected(address, token, certificate, log=out / COMMANDS)) as client:
            station = RobotStation(client, task.setup, task.camera, slow=safety.slow_motions)
            keeps = station.film if film else None
            yield Robot(station, station.park, lambda: guarded(station, safety, out), keeps)

    return robot
