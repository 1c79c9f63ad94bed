"""Training tasks, a teacher's episodes and collections that tests make by hand."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

from probe.episodes.files import write_records
from probe.episodes.folder import RECORDS, SUITE
from probe.episodes.grading import question_of
from probe.episodes.participation import ModelReply, Participation
from probe.episodes.record import EpisodeRecord, Step, TableState
from probe.episodes.turns import Call
from probe.scene.scene import PlacedObject, Scene
from probe.tasks.suite import Suite
from probe.tasks.suite_file import write_suite
from probe.tasks.task import Letter, QuestionType, Task
from probe.toolshed.result import Answer, Status
from probe.train.choose.candidates import EpisodeCandidate
from probe.train.collect.batches import Batch, EpisodeGrade
from probe.train.collect.settings import CollectionSettings, claim
from run_folders import DEMO
from task_examples import FIND

FIRST_SEED = 2_000_000_000
BY_KIND = {task.question_type: task for task in DEMO.tasks}


def training_task(number: int, question_type: QuestionType = "find", answer: Letter = "B") -> Task:
    """A task with a training seed, on a table of things that stand nowhere else."""
    seed = FIRST_SEED + 1000 * number
    model = FIND if question_type == "find" else BY_KIND[question_type]
    if question_type in ("compare", "size"):
        answer = "A" if answer == "A" else "B"
    placed = tuple(
        replace(it, object_id=f"thing_{question_type}_{number}_{it.instance}")
        for it in model.scene.objects
    )
    scene = Scene(seed, model.scene.table, placed)
    return replace(model, id=f"{question_type}-{number:08x}", seed=seed, answer=answer, scene=scene)


def lesson(
    task: Task,
    *,
    setting: str = "agentic",
    right: bool = True,
    statuses: Sequence[tuple[str, Status]] = (("mug", "done"),),
    run: int = 0,
) -> EpisodeCandidate:
    """An episode in which things were grasped one after another, each found by its name."""
    table = TableState(task.scene, (0.0,) * 6)
    letter = task.answer if right else next(it for it in "AB" if it != task.answer)
    steps = list[Step]()
    for number, (name, status) in enumerate(statuses, start=1):
        found = f"object_id: object_{number}\nname: {name}\ndescription: A {name}."
        find = Call.of("find_object", {"description": name}, f"I want the {name}.")
        steps.append(Step(find, "done", found, (10, 10), table))
        grasp = Call.of("grasp_and_remove", {"object_id": f"object_{number}"}, "I take it.")
        steps.append(Step(grasp, status, "Done: so it is.", (10, 10), table))
    point = (10.0, 10.0) if task.question_type == "find" and setting != "direct" else None
    said = {"choice": letter} if point is None else {"choice": letter, "point": point}
    steps.append(Step(Call.of("answer_question", said), "done", "Ok.", None, table))
    replies = tuple(ModelReply(1) for _ in steps)
    if setting == "direct":
        steps, replies = [], (ModelReply(0, f"I see it.\nANSWER: {letter}"),)
    record = EpisodeRecord(
        task.id, "teacher", run, question_of(task), table, tuple(steps), Answer(letter, point),
        "answered",
        participation=Participation(setting, replies=replies, cost=0.25),
    )  # fmt: skip
    return EpisodeCandidate(task, record, right)


def reminded(it: EpisodeCandidate) -> EpisodeCandidate:
    """The same episode, in which the teacher first said something that called for a reminder."""
    assert it.record.participation is not None
    replies = (ModelReply(0, "Let me think."), *it.record.participation.replies)
    return replace(
        it,
        record=replace(it.record, participation=replace(it.record.participation, replies=replies)),
    )


def grade_of(it: EpisodeCandidate) -> EpisodeGrade:
    return EpisodeGrade(
        task=it.task.id,
        question_type=it.task.question_type,
        seed=it.task.seed,
        setting=it.record.setting,
        run=it.record.run,
        correct=it.correct,
        outcome="right" if it.correct else "wrong",
        manipulations=it.record.manipulations,
        cost=it.record.participation.cost if it.record.participation else None,
    )


def suite_of(tasks: Sequence[Task], name: str = "0of1-00000") -> Suite:
    """A suite whose objects look like nothing in particular."""
    ids = sorted({placed.object_id for task in tasks for placed in task.scene.objects})
    return Suite(name, tuple(tasks), {id: (1.0, 2.0) for id in ids})


def write_batch(out: Path, lessons: Sequence[EpisodeCandidate], name: str = "0of1-00000") -> Batch:
    """A whole batch as `probe collect` leaves it."""
    batch = Batch(out / "batches" / name)
    write_suite(
        batch.folder / SUITE, suite_of(list({it.task.id: it.task for it in lessons}.values()))
    )
    for setting in ("direct", "agentic"):
        mine = [it for it in lessons if it.record.setting == setting]
        if mine:
            tasks = list({it.task.id: it.task for it in mine}.values())
            write_suite(batch.setting(setting) / SUITE, suite_of(tasks))
            write_records(batch.setting(setting) / RECORDS, [it.record for it in mine])
    batch.keep([grade_of(it) for it in lessons])
    return batch


def begin_collection(out: Path) -> Path:
    settings = CollectionSettings(
        agent="teacher", pool="procedural", split=None, points="pixels", noise="none",
        lighting="ambient", shard="0/1", first=2_000_000,
    )  # fmt: skip
    claim(out, settings)
    return out


def moved_away(task: Task) -> Task:
    """The same table with each thing elsewhere."""
    placed = tuple(
        PlacedObject(it.instance, it.object_id, replace(it.pose, position=(0.2, 0.1, 0.05)))
        for it in task.scene.objects
    )
    return replace(task, scene=replace(task.scene, objects=placed))
