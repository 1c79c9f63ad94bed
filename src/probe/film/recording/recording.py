"""From a record to a recording on disk."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from probe.assets.library import Library
from probe.episodes.play import score
from probe.episodes.record import EpisodeRecord
from probe.files import write_bytes
from probe.film.captions import call_words
from probe.film.footage import FilmedCall, Footage, take
from probe.film.recording.bodies import tell_looks, tell_motion
from probe.film.recording.layout import layout
from probe.film.recording.plans import PLAN, pads_middle, tell_plan
from probe.film.recording.stream import Level, RecordingWriter, require_rerun
from probe.film.recording.views import tell_look
from probe.manipulation.grasp import GraspResult
from probe.render.renderer import Renderer
from probe.station.arms import arm_of, hand_of
from probe.tasks.grading import Score
from probe.tasks.task import Task
from probe.texts import visible
from probe.toolshed.result import Status

_LEVELS: dict[Status, Level] = {
    "done": "INFO",
    "failed": "WARN",
    "malformed": "ERROR",
    "refused": "ERROR",
}
_HAND_PATH = "world/hand_path"
_PATH_COLOUR = (235, 235, 240)
_PATH_RADIUS = 0.0012


def write_recording(
    task: Task, record: EpisodeRecord, library: Library, renderer: Renderer, path: Path
) -> None:
    """Write an episode for Rerun's viewer: done again, compared with its record, told.

    Args:
        task: What the record is about.
        record: The episode.
        library: Has the task's objects.
        renderer: Draws what the station sees; what was loaded in it is replaced.
        path: The recording's file, which is written whole or not at all.

    Raises:
        CantFilm: The episode can't be done again, or not as it was.
        OtherTools: Tools of another version made the record.
        MissingExtra: Rerun isn't installed.
        OutputFailed: The file can't be written.
    """
    require_rerun()
    footage = take(task, record, library, renderer, looking=True)
    write_bytes(path, recording_of(footage, score(task, record, renderer), library))


def recording_of(footage: Footage, graded: Score, library: Library) -> bytes:
    """A whole recording, as a file has it.

    At the number of a call stands what was there when it was made, what was thought of in it and
    what it told; after the last one, how all ended.
    """
    record, setup = footage.record, footage.task.setup
    name = f"{record.task}, {record.agent}, run {record.run}"
    writer = RecordingWriter(name, layout(setup))
    tell_looks(writer, footage.task.scene, library)
    tell_motion(writer, footage, library)
    writer.at(_when(footage, 0), 1)
    writer.text(_question(footage))
    for number, call in enumerate(footage.calls):
        _tell_before(writer, footage, number)
        _tell_call(writer, footage, number, call)
    _tell_before(writer, footage, len(footage.calls))
    writer.text(f"The episode ended: {record.end}. It counts as: {graded.outcome}.")
    return writer.content()


def _tell_before(writer: RecordingWriter, footage: Footage, number: int) -> None:
    """What was there when a call was made."""
    writer.at(_when(footage, number), number + 1)
    for entity in (PLAN, _HAND_PATH, "grasps"):
        writer.clear(entity)
    pictures = footage.pictures
    if number == 0 or pictures[number] is not pictures[number - 1]:
        writer.picture("agent/picture", pictures[number])
    if number == 0 or footage.looks[number] is not footage.looks[number - 1]:
        tell_look(writer, footage.looks[number])


def _tell_call(writer: RecordingWriter, footage: Footage, number: int, call: FilmedCall) -> None:
    """What a call was, thought of, did and told."""
    setup = footage.task.setup
    arm, hand = arm_of(setup.mount), hand_of(setup)
    told = f"Call {number + 1} of {len(footage.calls)}"
    if call.call.words:
        writer.text(f"Agent: {visible(call.call.words)}")
    writer.text(f"{told}: {call_words(call.call)}")
    moments = footage.moments[call.first : call.last + 1]
    if len(moments) > 1:
        path = np.array([pads_middle(arm, hand, it.joints, it.opening) for it in moments])
        writer.lines(_HAND_PATH, [path], _PATH_COLOUR, _PATH_RADIUS)
    if isinstance(call.outcome, GraspResult):
        for attempt, plan in enumerate(call.outcome.plans, start=1):
            assert plan.frame.taken is not None
            writer.at(plan.frame.taken, number + 1)
            tell_plan(writer, plan, f"{told}, try {attempt}", arm, hand)
    writer.at(_when(footage, number + 1), number + 1)
    writer.text(f"Told: {visible(call.result.text)}", _LEVELS[call.result.status])


def _when(footage: Footage, number: int) -> float:
    """Simulated seconds at which a call was made; after the last one, at which all was over."""
    taken = footage.looks[number].table.taken
    assert taken is not None
    return taken


def _question(footage: Footage) -> str:
    question = footage.question
    return "\n".join([question.text, *(f"{letter}  {text}" for letter, text in question.options)])
