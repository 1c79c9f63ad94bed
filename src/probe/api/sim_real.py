"""Simulation against reality: two folders of records, the tasks that both share, one page."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path

import pydantic

from probe.api.grading import graded
from probe.api.progress import Track, silent
from probe.api.rows import rows_of, setting_of_record
from probe.episodes.folder import SUITE, setting_of_folder
from probe.episodes.tool_errors import label_of
from probe.errors import BadData
from probe.files import write_text
from probe.reading import is_there
from probe.report.sim_real import OperatorReason, SimRealReport, write_sim_real_page
from probe.runs.session.events import Ended, Reasoned
from probe.runs.session.log import LOG, begun_in, read_log
from probe.runs.session.order import slots_of
from probe.runs.session.standing import state_of
from probe.scores.row import Row
from probe.scores.sim_real import SimReal, sim_real
from probe.tasks.identity import identity_of
from probe.tasks.suite_file import read_suite
from probe.tasks.task import Task
from probe.toolshed.version import tools_words

OUT = Path("outputs/sim-real")
PAGE, FIGURES = "index.html", "sim-real.json"


@dataclass(frozen=True)
class _Folder:
    """One place's records: rows without conditions in their settings, and the conditions."""

    tasks: Mapping[str, Task]
    rows: tuple[Row, ...]
    label: str


def write_sim_real(
    sim: str | Path, real: str | Path, out: str | Path = OUT, *, track: Track = silent
) -> SimReal:
    """Compare agents in simulation with the same agents on a robot, and write a page of it.

    Args:
        sim: Folder that `probe run` wrote.
        real: Folder of records of a robot or its twin.
        out: Folder for index.html and sim-real.json.
        track: Watches the work.

    Raises:
        BadData: A folder can't be read, or is of the wrong kind.
        NoPoses: The robot's folder has an answer that is worth what it points at.
    """
    simulated, robot = (
        _read(Path(folder), is_real=is_real, track=track)
        for folder, is_real in ((sim, False), (real, True))
    )
    away = _apart(simulated.tasks, robot.tasks)
    first, second = ([row for row in it.rows if row.task not in away] for it in (simulated, robot))
    found = sim_real(first, second)
    found = replace(found, tasks_left_out={**away, **found.tasks_left_out})
    suite = identity_of(read_suite(Path(real) / SUITE)).title
    versions = tools_words(row.tools for row in (*first, *second))
    labels, reasons = (simulated.label, robot.label), reasons_in(Path(real))
    page = SimRealReport(suite, found, labels, versions, tuple(reasons))
    write_sim_real_page(Path(out) / PAGE, page)
    write_text(Path(out) / FIGURES, _document(found))
    return found


def reasons_in(folder: Path) -> list[OperatorReason]:
    """What an operator wrote about each episode; nothing where there was no session.

    Raises:
        BadData: The session's log can't be trusted.
    """
    if not is_there(folder / LOG):
        return []
    events = read_log(folder)
    begun = begun_in(events, folder)
    found: list[OperatorReason] = []
    for slot in slots_of(begun.plan, begun.agents):
        mine = state_of(slot, events).events
        ends = [it.verdict for it in mine if isinstance(it, Ended)]
        words = [it.words for it in mine if isinstance(it, Reasoned)]
        found += [
            OperatorReason(slot.task, slot.agent, slot.run, *said)
            for said in zip(ends, words, strict=False)
        ]
    return found


def _read(folder: Path, *, is_real: bool, track: Track) -> _Folder:
    suite = read_suite(folder / SUITE)
    found = graded(folder, track)
    if not found:
        raise BadData(folder, "holds no record", "Let agents work on the suite first")
    for _, record, _ in found:
        # An episode that was lost before its first picture has none, wherever it was.
        if bool(record.frames) != is_real and record.end != "fault":
            kind = "simulation" if is_real else "a robot"
            raise BadData(folder, f"has records of {kind}", "Name the simulation's folder first")
    first = found[0][1]
    rows = rows_of(folder, suite, found, title=identity_of(suite).title)
    given = setting_of_folder(folder)
    label = label_of(first, suite.headline, given or setting_of_record(first))
    settings = [given or setting_of_record(record) for _, record, _ in found]
    # Without conditions: these differ between the places anyway.
    plain = tuple(
        row.model_copy(update={"setting": setting})
        for row, setting in zip(rows, settings, strict=True)
    )
    return _Folder({task.id: task for task in suite.tasks}, plain, label or "perception oracle")


def _apart(sim: Mapping[str, Task], real: Mapping[str, Task]) -> dict[str, str]:
    """Tasks that aren't the same in both places, and why."""
    found = dict.fromkeys(sim.keys() - real.keys(), "it isn't in the robot's suite")
    found |= dict.fromkeys(real.keys() - sim.keys(), "it isn't in the simulation's suite")
    both = sim.keys() & real.keys()
    return found | {
        task: "it differs between the suites" for task in both if sim[task] != real[task]
    }


def _document(found: SimReal) -> str:
    # By words, as keys of JSON are texts.
    left = {f"{it.agent} ({it.setting})": why for it, why in found.agents_left_out.items()}
    values = pydantic.TypeAdapter(SimReal).dump_python(
        replace(found, agents_left_out={}), by_alias=True
    )
    return (
        pydantic.TypeAdapter(dict).dump_json({**values, "agents_left_out": left}, indent=1).decode()
        + "\n"
    )
