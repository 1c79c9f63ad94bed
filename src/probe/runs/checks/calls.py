"""Whether a record's calls went as calls can go, and its tables follow from one another."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from probe.episodes.record import EpisodeRecord, Step, TableState
from probe.scene.scene import Scene
from probe.toolshed.answer_form import AnswerForm
from probe.toolshed.parse import parse
from probe.toolshed.refusals import PointMissing, Refusal
from probe.toolshed.result import Status
from probe.toolshed.tools import AnswerQuestion, GraspAndRemove, Push, Request
from probe.toolshed.toolshed import MANIPULATIONS, TURNS


def amiss_in_calls(
    record: EpisodeRecord, form: AnswerForm, budget: int = MANIPULATIONS
) -> Iterator[str]:
    """What can't be: more calls than there are turns, a status, a table that nothing moved.

    Args:
        record: Whose calls they are.
        form: What its tools took for a complete answer.
        budget: Manipulations that its task allows.
    """
    if len(record.steps) > TURNS:
        yield f"it has {len(record.steps)} calls, and the rules allow {TURNS}"
    if record.manipulations > budget:
        yield f"it has {record.manipulations} manipulations, and the rules allow {budget}"
    before, used, asked = record.start, 0, False
    for number, step in enumerate(record.steps, start=1):
        request = request_of(step, record.viewpoint.camera.width_px)
        moves = isinstance(request, GraspAndRemove | Push)
        refusal = None
        if isinstance(request, AnswerQuestion):
            last = asked or number >= TURNS
            refusal = form.refusal_of(request.choice, request.point, last=last)
            asked = asked or isinstance(refusal, PointMissing)
        possible = _possible(request if refusal is None else None, budget - used)
        known = (
            replace(before, joints=step.after.joints) if _rests(record, step, before) else before
        )
        for reason in (_of_status(step, possible), _of_table(step, known, moves=moves)):
            if reason:
                yield f"step {number} ({step.call.name[:20]}): {reason}"
        used += moves and step.status in ("done", "failed")
        before = step.after


def request_of(step: Step, side_px: int) -> Request | None:
    """What a call asks for; None if no tool takes it."""
    try:
        return parse(step.call.name, step.call.values, side_px)
    except Refusal:
        return None


def things_of(scene: Scene) -> list[tuple[int, str]]:
    """Which objects are there, whatever their poses."""
    return [(placed.instance, placed.object_id) for placed in scene.objects]


def _rests(record: EpisodeRecord, step: Step, before: TableState) -> bool:
    """Whether only joints differ that a real arm measured: they are never twice the same."""
    return bool(record.frames) and len(step.after.joints) == len(before.joints)


def _of_status(step: Step, possible: tuple[Status, ...]) -> str | None:
    if step.status in possible:
        return None
    return f'it is "{step.status}", and such a call can only be {" or ".join(possible)}'


def _possible(request: Request | None, left: int) -> tuple[Status, ...]:
    """How a call may have gone with so many manipulations left; None is one that was refused."""
    if request is None:
        return ("malformed",)
    if isinstance(request, AnswerQuestion):
        return ("done",)
    if isinstance(request, GraspAndRemove | Push):
        # An id that was never given out, or is out of date, is malformed.
        return ("refused",) if left <= 0 else ("done", "failed", "malformed")
    return ("done", "failed")


def _of_table(step: Step, before: TableState, *, moves: bool) -> str | None:
    if step.after == before:
        return None
    if not moves or step.status not in ("done", "failed"):
        return "the table is another one afterwards, though it moves nothing"
    one, other = before.scene, step.after.scene
    if (one.seed, one.table, things_of(one)) != (other.seed, other.table, things_of(other)):
        return "other objects are on the table afterwards"
    if len(step.after.joints) != len(before.joints):
        return "the arm has another number of joints afterwards"
    return None
