"""A Suite on disk: versioned JSON with a manifest, checked when it is read."""

from __future__ import annotations

import hashlib
import os
from dataclasses import replace
from functools import cache
from importlib import resources
from pathlib import Path
from typing import Annotated, Literal

import pydantic

from probe import reading
from probe.assets.library import Pool
from probe.checksum import with_sum
from probe.errors import BadData, UnknownName
from probe.files import read_document, write_bytes
from probe.perception.dials import Dials, ErrorRate
from probe.scene.cameras import View
from probe.scene.document import SceneDocument
from probe.scene.setup_file import MOST_PX, sees_basket
from probe.scene.visibility import Visibility
from probe.tasks.headline import HeadlineErrors
from probe.tasks.look_alike import look_alike
from probe.tasks.reserved import Difference, difference, unlike
from probe.tasks.suite import Suite
from probe.tasks.task import (
    LETTERS,
    Certificate,
    Letter,
    Mark,
    Option,
    QuestionType,
    RulesVersion,
    Task,
)
from probe.tasks.type_rules import Form, rules_of
from probe.texts import plain

CANARY = "PROBE SUITE; NOT FOR TRAINING; canary 6d0f1c52-6c0e-4e7c-9a53-0b6f2f8f7d41"
"""Anyone who finds this text in training data knows that a suite got there."""

_REMEDY = "Fetch the suite again, or build it with `probe suite build`"


_Pixel = Annotated[int, pydantic.Field(ge=0, lt=MOST_PX)]


class VisibilityDocument(pydantic.BaseModel, extra="forbid"):
    """Pixels of an object."""

    visible_px: int = pydantic.Field(ge=0)
    alone_px: int = pydantic.Field(ge=0)


class CertificateDocument(pydantic.BaseModel, extra="forbid", allow_inf_nan=False):
    """What was measured."""

    visibility: dict[int, VisibilityDocument]
    measures: dict[str, float]
    candidates: tuple[str, ...]


class MarkDocument(pydantic.BaseModel, extra="forbid"):
    """One mark."""

    letter: Letter
    instance: int
    point: tuple[_Pixel, _Pixel]


class TaskDocument(
    pydantic.BaseModel, extra="forbid", validate_by_name=True, serialize_by_alias=True
):
    """One task."""

    id: str = pydantic.Field(pattern=r"^[a-z0-9-]+$")
    question_type: Annotated[QuestionType, pydantic.Field(alias="kind")]
    form: Form
    seed: int = pydantic.Field(ge=0)
    version: RulesVersion
    subject: str
    question: str
    options: tuple[str, ...] = pydantic.Field(min_length=2, max_length=len(LETTERS))
    answer: Letter
    targets: tuple[int, ...]
    cover: int | None
    named: tuple[int, ...]
    marks: tuple[MarkDocument, ...]
    certificate: CertificateDocument
    scene: SceneDocument
    # Left out where it is the top one, as files of before there was a choice do.
    camera: View = pydantic.Field(default="top", exclude_if=lambda it: it == "top")
    # Left out of tasks that allow as many as usual.
    manipulations: int | None = pydantic.Field(default=None, ge=1, exclude_if=lambda it: it is None)

    @pydantic.model_validator(mode="after")
    def _names_what_is_there(self) -> TaskDocument:
        present = {placed.instance for placed in self.scene.objects}
        named = {*self.targets, *self.named, *(mark.instance for mark in self.marks)}
        named |= set() if self.cover is None else {self.cover}
        if not named <= present:
            raise ValueError(f"instances {sorted(named - present)} aren't in its scene")
        if self.answer not in LETTERS[: len(self.options)]:
            raise ValueError(f"its answer {self.answer} is none of its options")
        rules = rules_of(self.question_type)
        if self.form not in rules.forms:
            known = ", ".join(rules.forms)
            raise ValueError(f"the forms of {self.question_type} are {known}, not {self.form!r}")
        if self.scene.setup and sees_basket(self.scene.setup.setup(), self.camera):
            raise ValueError(f"its camera, {self.camera}, sees the basket of its set-up")
        if len(self.targets) < (fewest := rules.fewest_targets):
            raise ValueError(f"{self.question_type} is about {fewest} targets or more")
        return self

    @staticmethod
    def of(task: Task) -> TaskDocument:
        """The document of a task."""
        proof = task.certificate
        visibility = {
            number: VisibilityDocument(visible_px=seen.visible_px, alone_px=seen.alone_px)
            for number, seen in proof.visibility.items()
        }
        return TaskDocument(
            id=task.id,
            question_type=task.question_type,
            form=task.form,
            seed=task.seed,
            version=task.version,
            subject=task.subject,
            question=task.question,
            options=tuple(option.text for option in task.options),
            answer=task.answer,
            targets=task.targets,
            cover=task.cover,
            named=task.named,
            marks=tuple(
                MarkDocument(letter=mark.letter, instance=mark.instance, point=mark.point)
                for mark in task.marks
            ),
            certificate=CertificateDocument(
                visibility=visibility,
                measures=dict(proof.measures),
                candidates=proof.candidates,
            ),
            scene=SceneDocument.of(task.scene),
            camera=task.camera,
            manipulations=task.manipulations,
        )

    def task(self) -> Task:
        """The task it describes."""
        options = zip(LETTERS, self.options, strict=False)
        proof = self.certificate
        visibility = {
            number: Visibility(seen.visible_px, seen.alone_px)
            for number, seen in proof.visibility.items()
        }
        return Task(
            id=self.id,
            question_type=self.question_type,
            form=self.form,
            seed=self.seed,
            subject=self.subject,
            question=self.question,
            options=tuple(Option(letter, text) for letter, text in options),
            answer=self.answer,
            scene=self.scene.scene(),
            targets=self.targets,
            cover=self.cover,
            named=self.named,
            marks=tuple(Mark(mark.letter, mark.instance, mark.point) for mark in self.marks),
            certificate=Certificate(visibility, proof.measures, proof.candidates),
            camera=self.camera,
            manipulations=self.manipulations,
            version=self.version,
        )

    def digest(self) -> str:
        """Content hash; 16 hex digits."""
        return hashlib.sha256(self.model_dump_json().encode()).hexdigest()[:16]


_Metres = Annotated[float, pydantic.Field(ge=0, le=0.1)]


class HeadlineErrorsDocument(pydantic.BaseModel, extra="forbid"):
    """Errors of tools."""

    grasp: _Metres
    push: _Metres
    over: ErrorRate
    under: ErrorRate
    missed: ErrorRate
    hallucinated: ErrorRate
    general: ErrorRate = pydantic.Field(default=0.0, exclude_if=lambda rate: rate == 0)

    @staticmethod
    def of(headline: HeadlineErrors) -> HeadlineErrorsDocument:
        """The document of these errors."""
        return HeadlineErrorsDocument(
            grasp=headline.grasp, push=headline.push, **vars(headline.dials)
        )

    def headline(self) -> HeadlineErrors:
        """The errors that it describes."""
        dials = Dials(self.over, self.under, self.missed, self.hallucinated, self.general)
        return HeadlineErrors(self.grasp, self.push, dials)


class SuiteDocument(pydantic.BaseModel, extra="forbid"):
    """A whole suite, with a hash of every task and a fingerprint of every object."""

    version: Literal[3] = 3
    name: str = pydantic.Field(min_length=1)
    canary: str = CANARY
    # Of private suites alone: SHA-256 of the salt they were made with.
    commitment: str | None = pydantic.Field(default=None, pattern=r"^[0-9a-f]{64}$")
    # Of suites since there is a pool for training: which objects they were made of.
    pool: Pool | None = pydantic.Field(default=None, exclude_if=lambda it: it is None)
    # Of suites whose scores are taken with tools that err.
    headline: HeadlineErrorsDocument | None = pydantic.Field(
        default=None, exclude_if=lambda it: it is None
    )
    objects: dict[str, tuple[float, ...]]
    manifest: dict[str, str]
    tasks: Annotated[list[TaskDocument], pydantic.FailFast()]

    @pydantic.model_validator(mode="after")
    def _is_whole(self) -> SuiteDocument:
        if self.canary != CANARY:
            raise ValueError("the canary string has been changed")
        ids = [task.id for task in self.tasks]
        if len(set(ids)) < len(ids):
            raise ValueError("a task id is there twice")
        if set(ids) != set(self.manifest):
            odd = sorted(set(ids) ^ set(self.manifest))
            raise ValueError(f"tasks and manifest differ in {odd[0]}")
        for task in self.tasks:
            if task.digest() != self.manifest[task.id]:
                raise ValueError(f"task {task.id} isn't what it was when the suite was frozen")
            unknown = {placed.object_id for placed in task.scene.objects} - set(self.objects)
            if unknown:
                raise ValueError(
                    f"task {task.id} shows {sorted(unknown)[0]}, which has no fingerprint"
                )
        return self


def digest_of(task: Task) -> str:
    """Content hash of a task, as in a suite's manifest; 16 hex digits."""
    return TaskDocument.of(task).digest()


def write_suite(path: Path, suite: Suite, *, private: bool = False) -> None:
    """Write a suite as JSON that ends with a checksum; floats keep every bit.

    Args:
        path: The file.
        suite: What to write.
        private: Only its owner can read it; so it is of any suite that is committed to a salt.

    Raises:
        OutputFailed: It can't be written; nothing half-written is left.
    """
    left_out = {"commitment"} if suite.commitment is None else None
    text = _document(suite).model_dump_json(indent=1, exclude=left_out)
    private = private or suite.commitment is not None
    write_bytes(path, with_sum(text.encode()), private=private)


def content_hash(suite: Suite) -> str:
    """SHA-256 of all that a suite holds but its name; 64 hex digits, however its file is laid out.

    Objects' fingerprints count in the order of their ids.
    """
    sorted_ = replace(suite, objects=dict(sorted(suite.objects.items())))
    text = _document(sorted_).model_dump_json(exclude={"name"})
    return hashlib.sha256(text.encode()).hexdigest()


def _document(suite: Suite) -> SuiteDocument:
    tasks = [TaskDocument.of(task) for task in suite.tasks]
    return SuiteDocument(
        name=suite.name,
        commitment=suite.commitment,
        pool=suite.pool,
        headline=HeadlineErrorsDocument.of(suite.headline) if suite.headline else None,
        objects=dict(suite.objects),
        manifest={task.id: task.digest() for task in tasks},
        tasks=tasks,
    )


def read_suite(path: Path) -> Suite:
    """Read a suite that write_suite wrote.

    Raises:
        BadData: The file is missing, truncated, changed, or not a suite of this version.
    """
    document = read_document(path, SuiteDocument, _REMEDY, most=reading.SUITE)
    tasks = tuple(task.task() for task in document.tasks)
    headline = document.headline.headline() if document.headline else None
    named = (document.name, tasks, document.objects, document.commitment, document.pool)
    return Suite(*named, headline=headline)


def packaged_suites() -> list[str]:
    """Names of the suites that come with the package."""
    files = (resources.files("probe.tasks") / "data").iterdir()
    return sorted(Path(file.name).stem for file in files if file.name.endswith(".json"))


@cache
def packaged_suite(name: str) -> Suite:
    """A suite that comes with the package; read once in each process.

    Raises:
        UnknownName: There is none of this name.
        BadData: Its file isn't the one that was packaged.
    """
    if name not in packaged_suites():
        raise UnknownName("suite", name, packaged_suites())
    with resources.as_file(resources.files("probe.tasks") / f"data/{name}.json") as path:
        if hashlib.sha256(path.read_bytes()).hexdigest() != _packaged_hash(path.name):
            raise BadData(path, "isn't the file that was packaged", "Install PROBE again")
        return read_suite(path)


def _packaged_hash(file: str) -> str | None:
    """What `data/SHA256SUMS` says of a suite's file."""
    text = (resources.files("probe.tasks") / "data/SHA256SUMS").read_text("utf-8")
    return next((line[:64] for line in text.splitlines() if line[66:] == file), None)


def check_name(suite: Suite, path: Path, differs: Difference = difference) -> None:
    """Refuse a suite under a packaged one's name, or nearly, that is neither that nor a part of it.

    Args:
        suite: Of any name.
        path: Its file, for the message.
        differs: Compares its tasks with the packaged ones.

    Raises:
        BadData: It isn't what it says it is.
    """
    if suite.name not in packaged_suites():
        check_new_name(suite.name, path)
        return
    reason = unlike(suite, packaged_suite(suite.name), differs)
    if reason:
        words = f"is called {suite.name} but isn't the packaged {suite.name}: {reason}"
        raise BadData(path, words, "Take the packaged one, or give this one a name of its own")


def check_new_name(name: str, path: Path) -> None:
    """Refuse a name that people would take for a packaged suite's.

    Raises:
        BadData: It differs from one only by case, spaces, punctuation or signs that look alike.
    """
    if known := look_alike(name, packaged_suites()):
        reason = f'its suite is called "{plain(name)}", which looks like the packaged {known}'
        raise BadData(path, reason, "Give it a name that nobody can take for that")


def demo_suite() -> Suite:
    """The six tasks of the demo."""
    return packaged_suite("demo")


def find_suite(name: str) -> Suite:
    """A suite by the name of one that comes with the package, or by its file.

    Raises:
        UnknownName: It is neither.
        BadData: The file isn't a whole suite, or bears the name of a packaged one that it isn't.
    """
    # A link is looked at, wherever it leads; a name that no file can have is none. A folder may
    # well be called like a suite: a run's output, say.
    is_folder = name in packaged_suites() and Path(name).is_dir()
    if name.endswith(".json") or (os.path.lexists(name) and not is_folder):
        suite = read_suite(Path(name))
        check_name(suite, Path(name))
        return suite
    return packaged_suite(name)
