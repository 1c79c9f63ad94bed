"""`probe suite certify`: what people make of tasks, and a suite without those they reject."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Sequence
from pathlib import Path

from probe.api.gathering import NoRuns, one_suite
from probe.api.grading import Graded, grade_folder, scene_renderer_of
from probe.cli.checksum_notice import tell_unsummed
from probe.cli.human import SETTING
from probe.cli.screen import ScreenTable, say, track
from probe.episodes.folder import setting_of_folder, standing
from probe.episodes.remarks import latest, read_remarks
from probe.errors import BadData
from probe.generation.human_answers import (
    Agreement,
    HumanAnswer,
    HumanEffort,
    HumanVerdict,
    agreements,
    efforts,
    verdicts,
)
from probe.tasks.suite import Suite, selection
from probe.tasks.suite_file import write_suite


def certify(
    human: tuple[Path, ...],
    out: Path,
    name: str | None = None,
    least: float = 0.5,
    doubters: int = 1,
) -> None:
    """Drop the tasks that people fail or call ambiguous, and write the others as a new suite.

    Args:
        human: Folders that `probe human` wrote to, all of one suite.
        out: File for the new suite.
        name: Of the new suite; by default the old one's with "-human".
        least: Share of the people at a task who must be right for it to stay.
        doubters: How many people must call a task ambiguous for it to be dropped, whatever they
            answered.
    """
    suite = one_suite(human)
    _check(human, least, doubters)
    said = _all_said(human, suite)
    if not said:
        raise NoRuns(f"Nobody has finished a task in {human[0]}. Run `probe human` first.")
    notes = _notes(human)
    found = verdicts([task.id for task in suite.tasks], said, notes, least=least, doubters=doubters)
    _print(found, agreements(said), efforts(said))
    dropped = {verdict.task for verdict in found if verdict.dropped}
    tasks = tuple(task for task in suite.tasks if task.id not in dropped)
    if not tasks:
        raise BadData(suite.name, "no task is left", "Ask more people, or lower --least")
    write_suite(out, selection(suite, tasks, name or f"{suite.name}-human"))
    say(f"{len(tasks)} of {len(suite.tasks)} tasks are in {out}; {len(dropped)} were dropped.")


def _check(folders: Sequence[Path], least: float, doubters: int) -> None:
    if not 0 <= least <= 1:
        raise BadData("--least", f"{least} is no share", "Say a number from 0 to 1")
    if doubters < 1:
        raise BadData("--doubters", f"{doubters} would drop every task", "Say 1 or more")
    for folder in folders:
        if setting_of_folder(folder) != SETTING:
            remedy = "Name a folder that `probe human` wrote to"
            raise BadData(folder, "its records aren't people's", remedy)


def _all_said(folders: Sequence[Path], suite: Suite) -> list[HumanAnswer]:
    """The first run that people finished of each task; later ones know too much."""
    first: dict[tuple[str, str], HumanAnswer] = {}
    with scene_renderer_of(suite) as scene_renderer:
        for folder in folders:
            found = grade_folder(folder, suite, scene_renderer, track)
            tell_unsummed(folder)
            for graded in _standing(found):
                said = _said(graded)
                first.setdefault((said.task, said.person), said)
    return list(first.values())


def _standing(graded: Iterable[Graded]) -> list[Graded]:
    """Without failures of ours."""
    graded = list(graded)
    counting = {id(record) for record in standing(record for _, record, _ in graded)}
    return [it for it in graded if id(it[1]) in counting and it[1].end != "fault"]


def _said(graded: Graded) -> HumanAnswer:
    task, record, score = graded
    answer, seconds = record.answer, record.seconds
    return HumanAnswer(
        task=task.id,
        question_type=task.question_type,
        person=record.agent,
        letter=answer.choice if answer else None,
        correct=score.correct,
        turns=len(record.steps),
        manipulations=record.manipulations,
        seconds=sum(seconds.agent) + sum(seconds.tools) if seconds.agent else None,
    )


def _notes(folders: Sequence[Path]) -> dict[str, dict[str, str]]:
    """Of each task, by person, why they call it ambiguous."""
    notes: defaultdict[str, dict[str, str]] = defaultdict(dict)
    for folder in folders:
        for (task, person), remark in latest(read_remarks(folder)).items():
            if remark.ambiguous:
                notes[task][person] = remark.note
    return dict(notes)


def _print(
    found: Sequence[HumanVerdict], agreed: Sequence[Agreement], took: Sequence[HumanEffort]
) -> None:
    table = ScreenTable("task", "people", "right", "verdict", "notes")
    for it in found:
        notes = "\n".join(f"{who}: {note or '(no note)'}" for who, note in it.notes.items())
        table.add(it.task, str(it.people), str(it.right), it.reason, notes)
    table.show()
    table = ScreenTable("agreement", "tasks", "pairs", "same letter", "Krippendorff's alpha")
    for it in agreed:
        same = f"{it.same} ({it.same / it.pairs:.0%})" if it.pairs else "none"
        alpha = "undefined" if it.alpha is None else f"{it.alpha:.2f}"
        table.add(it.name, str(it.tasks), str(it.pairs), same, alpha)
    table.show()
    table = ScreenTable("effort", "episodes", "right", "seconds", "turns", "manipulations")
    for it in took:
        spreads = (_spread(each) for each in (it.seconds, it.turns, it.manipulations))
        table.add(it.name, str(it.episodes), str(it.right), *spreads)
    table.show()
    say("Effort: median (10th to 90th percentile).")


def _spread(spread: tuple[float, float, float] | None) -> str:
    if spread is None:
        return "unknown"
    low, middle, high = spread
    return f"{middle:.0f} ({low:.0f} to {high:.0f})"
