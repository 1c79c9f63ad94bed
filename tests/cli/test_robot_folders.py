"""`probe robot run` and `session`: folders that they leave alone, before a robot moves."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import pytest

from probe.cli.robot_run import run
from probe.cli.robot_session import session, verify_session
from probe.engines.plan import TRIES
from probe.episodes.folder import SUITE, claim_setting, start_folder
from probe.episodes.ordered import read_ordered
from probe.episodes.perceptions import PerceptionUsed
from probe.errors import BadData, Unfinished
from probe.runs.session.events import Begun, Ended, Reasoned, Sealed, Unblinded
from probe.runs.session.log import LOG, SessionLog
from probe.runs.session.order import slots_of
from probe.runs.session.plan import SessionPlan, tasks_of
from probe.runs.session.seal import seal_of, truth_of
from probe.runs.session.session import tables_of
from probe.tasks.suite import Suite
from probe.tasks.suite_file import content_hash, write_suite
from run_folders import DEMO, episode, on_robot, write_run

TASK = next(task for task in DEMO.tasks if task.question_type == "beneath")
PLAN = SessionPlan(suite="demo", tasks=(TASK.id,), agents=("always-A",), seed=0, operator="Jana")
LAID = tasks_of(PLAN, DEMO)
NOWHERE = "ws://127.0.0.1:9"


def ran(out: Path) -> None:
    run(NOWHERE, "demo", TASK.id, token_file=out / "token", out=out)


def held(out: Path) -> None:
    token, plan = out.parent / "token", out.parent / "session.yaml"
    token.write_text("a token of this bridge, long enough\n")
    plan.write_text(PLAN.model_dump_json(exclude_none=True))
    session(NOWHERE, plan, token_file=token, out=out)


@pytest.mark.parametrize(("command", "suite"), [(ran, DEMO), (held, LAID)])
@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"perception": PerceptionUsed("enrolled", 3, "0" * 12)}, "with perception enrolled"),
        ({"tools": 1}, "version 1 of the tools"),
    ],
)
def test_records_made_otherwise_get_no_company(
    tmp_path: Path,
    command: Callable[[Path], None],
    suite: Suite,
    changes: dict[str, object],
    words: str,
) -> None:
    out = tmp_path / "out"
    record = replace(on_robot(episode(TASK), out), **changes)
    write_run(out, [record], suite, pictures=False)
    before = sorted(out.iterdir())
    with pytest.raises(BadData, match=f"{words}.*Choose another folder"):
        command(out)
    assert sorted(out.iterdir()) == before


@pytest.mark.parametrize(("command", "suite"), [(ran, DEMO), (held, LAID)])
def test_agents_do_not_answer_where_people_do(
    tmp_path: Path, command: Callable[[Path], None], suite: Suite
) -> None:
    out = tmp_path / "out"
    start_folder(out, suite)
    claim_setting(out, "human")
    with pytest.raises(BadData, match="is kept for records of the setting human"):
        command(out)
    assert read_ordered(out) == {} and not (out / LOG).exists()


def test_a_session_that_is_over_and_lacks_a_result_is_unfinished(tmp_path: Path) -> None:
    write_suite(tmp_path / SUITE, LAID)
    slots, log = slots_of(PLAN, PLAN.agents), SessionLog(tmp_path)
    log.add(Begun(plan=PLAN, agents=PLAN.agents, suite=content_hash(LAID)))
    (slot,) = slots
    for _ in range(TRIES):
        log.add(Sealed(of=slot.key, seal=seal_of(truth_of(TASK.answer, ""))))
        log.add(Ended(of=slot.key, verdict="interrupted", fault="RobotLost: gone"))
        log.add(Reasoned(of=slot.key, words="The cable came out."))
    log.add(Unblinded(agents=tables_of(slots)))
    words = "1 of 1 episodes are missing. Each was interrupted as often as a session tries it"
    with pytest.raises(Unfinished, match=words):
        verify_session(tmp_path)
