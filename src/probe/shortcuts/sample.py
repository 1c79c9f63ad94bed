"""A task as somebody has it who only looks, apart from its answer. Nothing of its certificate."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from functools import cached_property

from probe.assets.spec import ObjectSpec
from probe.generation.first_look import FirstLook
from probe.generation.observer import says
from probe.generation.plan import block_of
from probe.tasks.english import plural
from probe.tasks.task import LETTERS, PAIR, QuestionType, Task
from probe.tasks.type_rules import Form, rules_of


@dataclass(frozen=True)
class Sample:
    """What a rule or classifier gets of a task.

    Attributes:
        question_type, form: What is asked; its words tell as much.
        question: Its words.
        options: Their texts, from A on.
        look: What the first picture shows.
    """

    question_type: QuestionType
    form: Form
    question: str
    options: tuple[str, ...]
    look: FirstLook

    @property
    def paired(self) -> bool:
        """Whether it asks about two marked things."""
        return len(self.options) == len(PAIR)

    @property
    def numbered(self) -> bool:
        """Whether its options are numbers."""
        return rules_of(self.question_type).numbered


@dataclass(frozen=True)
class LabelledSample:
    """A sample and its answer.

    Attributes:
        task: Its id.
        sample: All that may be used to guess.
        right: Place of the right option.
        block: Number of the block of tasks that together are even in all that was planned.
        part: Stratum in which it is also reported, or empty.
    """

    task: str
    sample: Sample
    right: int
    block: int
    part: str = ""


@dataclass(frozen=True)
class CatalogueFacts:
    """What the catalogue tells of objects by their names; the first of those that share one."""

    specs: tuple[ObjectSpec, ...]

    @cached_property
    def by_name(self) -> Mapping[str, ObjectSpec]:
        """Specs by name."""
        return {spec.name: spec for spec in reversed(self.specs)}

    @cached_property
    def by_plural(self) -> Mapping[str, ObjectSpec]:
        """Specs by the plural of their name."""
        return {many: spec for name, spec in self.by_name.items() if (many := plural(name))}

    @cached_property
    def common(self) -> Counter[str]:
        """How many objects each category has."""
        return Counter(spec.category for spec in self.specs)

    def counted(self, question: str) -> ObjectSpec | None:
        """What a question of Count counts: the longest plural in it."""
        named = [many for many in self.by_plural if says(question, many)]
        return self.by_plural[max(named, key=len)] if named else None


def example_of(task: Task, look: FirstLook) -> LabelledSample:
    """A task as an example."""
    partly = task.certificate.measures.get("partly")
    return LabelledSample(
        task=task.id,
        sample=Sample(
            task.question_type,
            task.form,
            task.question,
            tuple(option.text for option in task.options),
            look,
        ),
        right=LETTERS.index(task.answer),
        block=block_of(task.question_type, task.seed),
        part="" if partly is None else "partly" if partly else "hidden",
    )


def known(catalogue: CatalogueFacts, names: Iterable[str | None]) -> list[ObjectSpec]:
    """Specs of those of some names that the catalogue has."""
    return [
        catalogue.by_name[name] for name in names if name is not None and name in catalogue.by_name
    ]
