"""What is told of a practice question once it has ended: what was right, and why."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable
from dataclasses import dataclass

from PIL import Image

from probe.assets.library import Library
from probe.episodes.oracle_view import OracleView, oracle_view
from probe.episodes.play import score
from probe.episodes.record import EpisodeRecord
from probe.files import encode
from probe.perception.things import Thing, Words
from probe.render.renderer import Renderer
from probe.tasks.english import plural
from probe.tasks.grading import Outcome
from probe.tasks.task import Task
from probe.toolshed.pictures import outlined
from probe.types import Array

_AFTER_THE_LETTER: dict[Outcome, str] = {
    "no point": "you pointed at nothing",
    "missed": "the point isn't on it",
    "lost": "it isn't on the table any more",
    "covered": "too little of it shows to be pointed at",
    "not removed": "something that was to be removed isn't in the basket",
    "others removed": "something else has left the table too",
    "others moved": "something else has moved by over 5 cm",
}
"""Why an answer with the right letter is wrong all the same."""

_UNNAMED = Words(None, "", (), "")


@dataclass(frozen=True)
class Feedback:
    """What a person is told of their answer.

    Attributes:
        correct: Whether it would have scored.
        verdict: What was answered, and what is right.
        reason: What the pictures show of it.
        pictures: The table at the start, and without what hides the evidence, as PNG.
    """

    correct: bool
    verdict: str
    reason: str
    pictures: tuple[bytes, ...]


def explain(task: Task, record: EpisodeRecord, library: Library, renderer: Renderer) -> Feedback:
    """Grade an episode that has ended, and draw its task's evidence.

    Args:
        task: What it was about.
        record: What happened.
        library: Has the task's objects.
        renderer: Has them loaded; what was loaded in it is replaced.
    """
    worth = score(task, record, renderer)
    view = oracle_view(task, library, renderer)
    chosen = record.answer.choice if record.answer else None
    return Feedback(
        worth.correct,
        verdict_of(task, chosen, worth.outcome),
        _reason(task, view, library),
        (_png(view.first.rgb), _png(_with_targets(task, view))),
    )


def verdict_of(task: Task, chosen: str | None, outcome: Outcome) -> str:
    """What was answered and what is right, in words.

    Args:
        task: What was asked.
        chosen: The letter; None for no answer.
        outcome: What that is worth.
    """
    words = {option.letter: f"{option.letter}, {option.text}" for option in task.options}
    right = words[task.answer]
    if outcome == "right":
        return f"Right: {right}."
    if outcome in _AFTER_THE_LETTER:
        return f"The letter is right ({right}), but {_AFTER_THE_LETTER[outcome]}: that is wrong."
    if chosen is None:
        return f"You gave no answer. Right is {right}."
    said = next((text for letter, text in words.items() if letter == chosen), chosen)
    return f"Wrong: you answered {said}. Right is {right}."


def _reason(task: Task, view: OracleView, library: Library) -> str:
    """What the second picture shows, in words."""
    gone = _listed(task, view.removed, library)
    shown = f"The second picture shows the same table without {gone}." if gone else ""
    targets = _listed(task, task.targets, library)
    return f"{shown} The answer rests on what is outlined: {targets}.".strip()


def _listed(task: Task, instances: Iterable[int], library: Library) -> str:
    """Things in words: "the red mug, 3 salt shakers and B (the plate)"."""
    letters = {mark.instance: mark.letter for mark in task.marks}
    names = {number: library[task.scene[number].object_id].name for number in instances}
    marked = [f"{letters[it]} (the {name})" for it, name in names.items() if it in letters]
    counts = Counter(name for it, name in names.items() if it not in letters)
    words = [_counted(name, count) for name, count in counts.items()] + marked
    *most, last = words or [""]
    return f"{', '.join(most)} and {last}" if most else last


def _counted(name: str, count: int) -> str:
    return f"the {name}" if count == 1 else f"{count} {plural(name) or name}"


def _with_targets(task: Task, view: OracleView) -> Array:
    """The picture without what hides the evidence, with an outline around all that decides."""
    picture, labels = view.revealed.rgb, view.revealed.labels
    assert picture is not None and labels is not None
    for target in task.targets:
        mask = labels == target
        if mask.any():
            picture = outlined(picture, Thing.of(mask, _UNNAMED))
    return picture


def _png(picture: Array | None) -> bytes:
    assert picture is not None, "evidence is drawn with colours"
    return encode(Image.fromarray(picture), "PNG")
