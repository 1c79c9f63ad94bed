"""A question about a starting scene, with its answer and the proof that it is hard. Data only."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Literal, get_args

from probe.scene.cameras import View
from probe.scene.lighting import lighting_of
from probe.scene.scene import Scene
from probe.scene.setup import Setup, picture_scale
from probe.scene.viewpoint import Viewpoint
from probe.scene.visibility import Visibility
from probe.tasks.registry import question_types
from probe.tasks.type_rules import Form
from probe.types import PictureScale

QUESTION_TYPES: tuple[str, ...] = question_types()
"""Names of the question types there are."""

if TYPE_CHECKING:
    QuestionType = str
    """Name of a question type; one of QUESTION_TYPES."""
else:
    # At run time a Literal, so that files and options with other names are refused.
    QuestionType = Literal[QUESTION_TYPES]

Letter = Literal["A", "B", "C", "D", "E"]
LETTERS: tuple[Letter, ...] = get_args(Letter)

PAIR: tuple[Letter, Letter] = "A", "B"
"""Letters of Compare and Size, whose options are the two marked things."""

NONE_OF_THE_ABOVE = "None of the above"
"""Text of the last of five options, E."""

RulesVersion = Literal[2, 3]
"""Of the rules that tasks are made by; 2 made v1."""

DEPTH_RULES: RulesVersion = 3
"""Since these, heights and tilts of covers, which a depth camera sees, don't tell an answer."""

STEP_RULES: RulesVersion = 3
"""Since these, every task states how many removals it takes."""

OPEN_RULES: RulesVersion = 3
"""Since these, some tasks can be answered from the first picture."""

ERROR_RULES: RulesVersion = 3
"""Since these, a suite says how far tools err where its scores are taken."""

SIX_RULES: RulesVersion = 3
"""Since these, Count goes up to six, and numbers are offered on one side of those that could be."""

PILE_RULES: RulesVersion = 3
"""Since these, things may lie on a cover, and count as what hides with it."""

KIND_RULES: RulesVersion = 3
"""Since these, candidates are of several categories where that can be, and Reduce draws what hides
them from all slabs, narrow ones too."""

AIM_RULES: RulesVersion = 3
"""Since these, covers of marked things have no holes. Compare's are aimed by what is wrong with
what shows, several casts may be tried, and colours are compared of what has one main colour."""

ONCE_RULES: RulesVersion = 3
"""Since these, no two tasks of a suite ask about the same things."""

TRIAL_RULES: RulesVersion = 3
"""Since these, scripted agents try a task in even light, whatever light it is drawn in."""

APART_RULES: RulesVersion = 3
"""Since these, what shows of a hidden thing tells it from the other candidates."""

NEWEST_RULES: RulesVersion = 3


@dataclass(frozen=True)
class Option:
    """One answer to choose from."""

    letter: Letter
    text: str


@dataclass(frozen=True)
class Mark:
    """A letter drawn on the first picture.

    Attributes:
        letter: A or B.
        instance: What it is on, for the whole episode wherever that goes.
        point: Pixel (u, v) of the first picture, well inside its visible part.
    """

    letter: Letter
    instance: int
    point: tuple[int, int]


@dataclass(frozen=True)
class Certificate:
    """What was measured in the starting scene; for auditors, never for agents.

    Attributes:
        visibility: Of each object, by instance.
        measures: The numbers of the rule of the task's type, by name.
        candidates: What the options were drawn from, the one that was left out included: object
            ids, or numbers in Count.
    """

    visibility: Mapping[int, Visibility]
    measures: Mapping[str, float]
    candidates: tuple[str, ...]


@dataclass(frozen=True)
class Task:
    """A question, its answer, and the table it is about.

    Attributes:
        id: Says nothing of the answer.
        question_type: Its type.
        form: What exactly it asks.
        seed: What it was made from, or in a private suite a number that leads to it by the salt
            alone; never shown to an agent.
        subject: The words of the question that name a thing: the cover, what is counted, in the
            singular, what a colour is compared with, or the colour itself; else empty.
        question: What the agent is asked.
        options: A to E, E being "None of the above"; in Compare and Size A and B.
        answer: The right letter.
        scene: The table at the start.
        targets: Instances that decide: the hidden one, all that are counted, or the two that are
            marked.
        cover: Instance of the one thing that the question names and that hides the target, or None.
        named: Instances that Reduce, Exact and Memory want removed, else empty.
        marks: Of Compare and Size, else empty.
        certificate: What was measured when it was made: visibilities, candidates, margins.
        camera: Which of the set-up's cameras shows it.
        manipulations: Grasps and pushes that its question allows; None for as many as usual.
        version: Of the rules it was made by.
    """

    id: str
    question_type: QuestionType
    form: Form
    seed: int
    subject: str
    question: str
    options: tuple[Option, ...]
    answer: Letter
    scene: Scene
    targets: tuple[int, ...]
    cover: int | None
    named: tuple[int, ...]
    marks: tuple[Mark, ...]
    certificate: Certificate
    camera: View = "top"
    manipulations: int | None = None
    version: RulesVersion = NEWEST_RULES

    @property
    def setup(self) -> Setup:
        """What stands around its objects."""
        return self.scene.setup

    @property
    def viewpoint(self) -> Viewpoint:
        """From where, in which light and by which renderer, it is seen as it was made."""
        setup = self.setup
        light = lighting_of(setup.lighting, self.scene.table)
        return Viewpoint(setup.camera(self.camera), light, setup.renderer)

    @property
    def scale(self) -> PictureScale:
        """What its pictures show."""
        return picture_scale(self.setup, self.viewpoint.camera)
