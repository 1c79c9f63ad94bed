"""A graded episode to its row. Knows the rules of a suite, no statistics."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import asdict, dataclass

from probe.episodes.grading import budget_of
from probe.episodes.record import EpisodeRecord
from probe.episodes.tool_errors import label_of
from probe.generation.necessary import NECESSARY
from probe.generation.visibility_rules import is_clear, is_hidden
from probe.scores.fidelity import fidelity
from probe.scores.roster import Listed
from probe.scores.row import Row
from probe.tasks.grading import Score
from probe.tasks.headline import HeadlineErrors
from probe.tasks.task import LETTERS, Task
from probe.tasks.type_rules import rules_of

_PERCEPTION = ("perceive_scene", "find_object")


@dataclass(frozen=True)
class Usage:
    """What a model used in one episode; None where its server doesn't say.

    Attributes:
        cost: US dollars.
    """

    tokens_in: int | None = None
    tokens_out: int | None = None
    cost: float | None = None


def row_of(
    task: Task,
    record: EpisodeRecord,
    score: Score,
    *,
    suite: str,
    setting: str,
    usage: Usage | None = None,
    ordered: int | None = None,
    headline: HeadlineErrors | None = None,
) -> Row:
    """The row of an episode.

    Args:
        task: What was asked.
        record: What happened.
        score: What it is worth by the task's rules.
        suite: Name of the suite.
        setting: How the agent was allowed to answer; the row's setting also says under which
            conditions.
        usage: Of the model; by default what the record says of it.
        ordered: Runs of each task that there are to be; None if unknown.
        headline: The errors of tools in the suite's headline setting, if it has one.
    """
    done = [step.call.name for step in record.steps if step.status in ("done", "failed")]
    return Row.model_validate(
        {
            "suite": suite,
            "task": task.id,
            "kind": task.question_type,
            "stratum": stratum_of(task),
            "options": len(task.options),
            "agent": record.agent,
            "arm": under(setting, record, headline),
            "run": record.run,
            "ordered": ordered,
            "answer": _letter(record),
            "right": task.answer,
            "correct": score.correct,
            "letter_correct": score.letter_correct,
            "outcome": score.outcome,
            "end": record.end,
            "fault": (record.fault or "unknown") if record.end == "fault" else None,
            "turns": len(record.steps),
            "manipulations": record.manipulations,
            "perceptions": sum(name in _PERCEPTION for name in done),
            "turns_spent": record.end == "out_of_turns",
            "manipulations_spent": record.manipulations >= budget_of(task),
            "manipulated": record.manipulations > 0,
            "seconds_agent": _total(record.seconds.agent, record),
            "seconds_tools": _total(record.seconds.tools, record),
            "tools": record.tools,
            "necessary": _necessary(task),
            **asdict(usage or _usage(record)),
            **_execution(task, record, score),
        }
    )


def _usage(record: EpisodeRecord) -> Usage:
    seat = record.participation
    return Usage(seat.tokens_in, seat.tokens_out, seat.cost) if seat else Usage()


def under(setting: str, record: EpisodeRecord, headline: HeadlineErrors | None = None) -> str:
    """A setting's name with a record's conditions: under other conditions it is another setting."""
    label = label_of(record, headline, setting)
    return f"{setting}, {label}" if label else setting


def _execution(task: Task, record: EpisodeRecord, score: Score) -> dict[str, object]:
    if not task.named or record.frames:  # frames: of a real table no poses are known
        return {}
    found = fidelity(record, task.named)
    return {**asdict(found), "strict": score.correct and found.exact}


def stratum_of(task: Task) -> str:
    """How much of the target shows: "hidden", "partly", "open"; empty where a type has one part."""
    if not rules_of(task.question_type).strata:
        return ""
    seen = task.certificate.visibility[task.targets[0]]
    return "hidden" if is_hidden(seen) else "open" if is_clear(seen) else "partly"


def _necessary(task: Task) -> int | None:
    stated = task.certificate.measures.get(NECESSARY)
    return None if stated is None else int(stated)


def _letter(record: EpisodeRecord) -> str | None:
    choice = record.answer.choice if record.answer else None
    return choice if choice in LETTERS else None


def _total(seconds: tuple[float, ...], record: EpisodeRecord) -> float | None:
    """None where a record was kept without its timing."""
    return sum(seconds) if len(seconds) == len(record.steps) else None


def roster_of_tasks(tasks: Iterable[Task]) -> dict[str, Listed]:
    """All that a suite consists of, run or not."""
    return {
        task.id: Listed(task.question_type, stratum_of(task), len(task.options), _necessary(task))
        for task in tasks
    }
