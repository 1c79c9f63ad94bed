"""Sessions from table to table, with a simulated table in the robot's place."""

from __future__ import annotations

import shutil
from collections.abc import Callable, Generator, Iterator, Mapping
from contextlib import contextmanager, nullcontext
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from operators import ScriptedOperator
from probe.agents.baselines import AtOnce, always
from probe.api.grading import graded
from probe.api.resources import everything
from probe.api.sim_real import reasons_in, write_sim_real
from probe.assets.library import Library
from probe.cli.report import write_run_report
from probe.cli.robot_session import verify_session
from probe.episodes.files import line_of, read_records, write_records
from probe.episodes.folder import RECORDS, SUITE
from probe.episodes.turns import Agent, Question
from probe.errors import BadData, RobotLost
from probe.perception.choice import segmented
from probe.render.photograph import load_scene
from probe.render.renderer import Renderer
from probe.runs.session.events import Begun, Ended, Reasoned, Unblinded
from probe.runs.session.log import LOG, read_log
from probe.runs.session.plan import SessionPlan, tasks_of
from probe.runs.session.resources import Robot, SessionResources
from probe.runs.session.session import RobotSession
from probe.runs.session.verify import account_of
from probe.station.simulated import SimulatedStation
from probe.tasks.suite_file import content_hash, write_suite
from probe.tasks.task import Task
from probe.types import Frame
from probe.world.world import World
from run_folders import DEMO, episode, write_run


def small(task: Task) -> Task:
    """The task with small pictures, which are drawn in a fraction of the time."""
    setup = replace(task.setup, name="small", picture_px=256)
    return replace(task, scene=replace(task.scene, setup=setup))


TASKS = tuple(small(task) for task in DEMO.tasks if task.question_type == "beneath")
"""Their answers are E and C."""

SMALL = replace(DEMO, name="laid tables", tasks=TASKS)
PLAN = SessionPlan(
    suite="laid tables",
    tasks=tuple(task.id for task in TASKS),
    agents=("anna", "bert"),
    seed=1,
    operator="Jana",
)
SUITE_LAID = tasks_of(PLAN, SMALL)
BEGUN = Begun(plan=PLAN, agents=PLAN.agents, suite=content_hash(SUITE_LAID))
SAYS = {"anna": "E", "bert": "C"}


class Shaky(SimulatedStation):
    """A table whose camera can be lost."""

    lost = False

    def observe(self, *, rgb: bool) -> Frame:
        if self.lost:
            raise RobotLost("the cable is out")
        return super().observe(rgb=rgb)


@pytest.fixture(scope="module")
def things() -> Library:
    return everything()


@pytest.fixture(scope="module")
def renderer() -> Iterator[Renderer]:
    with Renderer() as drawing:
        yield drawing


class Stage:
    """A session's folder, to be gone on with again and again.

    Args:
        out: The folder.
        things: Have the tasks' objects.
        renderer: For tables and layouts.
    """

    def __init__(self, out: Path, things: Library, renderer: Renderer) -> None:
        self.out, self.loses = out, False
        self._things, self._renderer = things, renderer
        if not (out / SUITE).exists():
            write_suite(out / SUITE, SUITE_LAID)

    @contextmanager
    def robot(self, task: Task) -> Generator[Robot]:
        load_scene(self._renderer, task.scene, self._things, self._things.table(task.scene.table))
        station = Shaky(World(task.scene, self._things), self._renderer, task.viewpoint.camera)
        self._station = station
        yield Robot(station, lambda: None, lambda: nullcontext(station))

    def agent(self, name: str, task: Task, run: int, things: Library, renderer: Renderer) -> Agent:
        def rule(question: Question) -> str | None:
            self._station.lost, self.loses = self.loses, False
            return always(SAYS[name])(question)

        return AtOnce(rule)

    def go_on(self, on: Mapping[str, Callable[[], str | None]] | None = None) -> ScriptedOperator:
        operator = ScriptedOperator(TASKS, on)
        agents = dict.fromkeys(SAYS, self.agent)
        its = SessionResources(
            SUITE_LAID, agents, self.robot, segmented, self._things, self._renderer, operator,
            self.out,
        )  # fmt: skip
        try:
            RobotSession(BEGUN, its).run()
        except KeyboardInterrupt:
            operator.heard.append("paused")
        return operator


def pressed() -> str | None:
    raise KeyboardInterrupt


@pytest.fixture(scope="module")
def finished(
    tmp_path_factory: pytest.TempPathFactory, things: Library, renderer: Renderer
) -> tuple[Path, list[str]]:
    """A session that was paused, whose cable was out once, and that came to its end."""
    stage = Stage(tmp_path_factory.mktemp("session"), things, renderer)
    heard = stage.go_on({"What happened": pressed}).heard
    assert heard[-1] == "paused" and not any("anna" in words for words in heard)
    stage.loses = True
    heard += stage.go_on().heard
    return stage.out, heard


@pytest.mark.slow
def test_a_session_is_paused_goes_on_and_ends(finished: tuple[Path, list[str]]) -> None:
    out, heard = finished
    account = account_of(out)
    assert account.amiss == () and account.finished
    verify_session(out)
    assert (account.wanted, account.results, account.interrupted, account.seals) == (4, 4, 1, 5)
    told = [number for number, words in enumerate(heard) if "anna" in words or "bert" in words]
    assert told == [len(heard) - 2, len(heard) - 1], "names come at the end alone"
    events = read_log(out)
    ends = [it for it in events if isinstance(it, Ended)]
    assert [end.verdict for end in ends].count("interrupted") == 1
    assert sum(end.verdict == "right" for end in ends) == 2, "each is right about one table"
    assert sum(isinstance(it, Reasoned) for it in events) == 5
    assert isinstance(events[-1], Unblinded)
    names = {(task, run): agents for task, run, agents in events[-1].agents}
    for end in ends:
        says = SAYS[names[end.of.task, end.of.run][end.of.number - 1]]
        answer = next(task.answer for task in TASKS if task.id == end.of.task)
        if end.verdict != "interrupted":
            assert end.answer == says and (end.verdict == "right") == (says == answer)


@pytest.mark.slow
def test_its_records_are_graded_shown_and_compared_like_any_other(
    finished: tuple[Path, list[str]], tmp_path: Path
) -> None:
    out, _ = finished
    records = read_records(out / RECORDS)
    assert len(records) == 5 and len({name for it in records for name in it.frames}) == sum(
        len(it.frames) for it in records
    )
    assert [record.fault is None for record in records].count(False) == 1
    scores = [score.correct for _, record, score in graded(out) if record.end != "fault"]
    assert sorted(scores) == [False, False, True, True]
    page = write_run_report([out], tmp_path / "page")
    assert page.exists() and list((tmp_path / "page" / "pictures").glob("*.webp"))
    made = [
        episode(task, agent=name, right=SAYS[name] == task.answer)
        for task in TASKS
        for name in SAYS
    ]
    sim = write_run(tmp_path / "sim", made, SMALL, pictures=False)
    found = write_sim_real(sim, out, tmp_path / "o")
    assert [it.real.success for it in found.agents] == [0.5, 0.5]
    assert sum(it.real.interrupted for it in found.agents) == 1
    assert found.pearson.value is None, "two agents make no correlation"
    assert "The agent said so at once." in (tmp_path / "o" / "index.html").read_text()
    reasons = reasons_in(out)
    assert [it.verdict for it in reasons].count("interrupted") == 1 and len(reasons) == 5


@pytest.mark.slow
def test_the_operator_sees_how_the_table_should_lie(finished: tuple[Path, list[str]]) -> None:
    """Over a table that lies so already, both pictures are one, apart from the edges."""
    folder = finished[0] / "layout"
    wanted, overlay, edges = (
        np.asarray(Image.open(folder / f"{name}.jpg")).astype(int)
        for name in ("wanted", "overlay", "edges")
    )
    assert np.abs(wanted - overlay).mean() < 2
    cyan = (np.abs(edges - (0, 255, 255)) < 60).all(axis=2)
    assert 0.002 < cyan.mean() < 0.1
    assert 'content="2"' in (folder / "layout.html").read_text()


@pytest.mark.slow
@pytest.mark.parametrize(
    ("spoil", "reason"),
    [
        ("record", "its record is missing, or was changed"),
        ("more", "1 records aren't in the log"),
        ("suite", "isn't the suite that the session began with"),
        ("answer", "its truth isn't the suite's"),
    ],
)
def test_what_was_changed_afterwards_is_found(
    finished: tuple[Path, list[str]], tmp_path: Path, spoil: str, reason: str
) -> None:
    out = tmp_path / "copy"
    out.mkdir()
    for name in (LOG, RECORDS, SUITE):
        shutil.copy(finished[0] / name, out / name)
    records = read_records(out / RECORDS)
    if spoil == "record":
        at = next(n for n, it in enumerate(records) if it.agent == "anna" and it.answer)
        records[at] = replace(records[at], agent="bert")
        write_records(out / RECORDS, records)
    elif spoil == "more":
        with (out / RECORDS).open("ab") as file:
            file.write(line_of(replace(records[-1], run=1)))
    else:
        changed = replace(SUITE_LAID.tasks[0], answer="A")
        write_suite(out / SUITE, replace(SUITE_LAID, tasks=(changed, SUITE_LAID.tasks[1])))
    assert any(reason in words for words in account_of(out).amiss)
    with pytest.raises(BadData, match="this session proves nothing"):
        verify_session(out)


@pytest.mark.slow
def test_a_wrong_truth_has_the_table_laid_anew(
    tmp_path: Path, things: Library, renderer: Renderer
) -> None:
    replies = iter(["A", "Z"])
    stage = Stage(tmp_path, things, renderer)
    operator = stage.go_on({
        "Which letter": lambda: next(replies, None), "What happened": pressed,
    })  # fmt: skip
    assert any("another letter" in words for words in operator.heard)
    assert any(words.startswith("Say A or B") for words in operator.heard)
    assert sum("lies so" in words for words in operator.heard) == 2
    assert account_of(tmp_path).seals == 1
