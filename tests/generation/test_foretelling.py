"""Somebody who has the generator, the ids and the order of a suite's tasks foretells its letters.

Of v1, every one; of a private suite of 1,000 tasks, none better than by chance.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import cache

import numpy as np
import pytest
from scipy import stats

from probe.assets.library import Library, open_library
from probe.generation.attempt import Attempt
from probe.generation.build import assemble, places_of
from probe.generation.build_folder import KEPT, BuildFolder, CandidateLog
from probe.generation.plan import ATTEMPTS, PAIRED, plan, plan_of
from probe.generation.salt import PRIVATE_FROM, Salt
from probe.generation.task_writer import task_id
from probe.tasks.suite import Suite, freeze
from probe.tasks.suite_file import packaged_suite, read_suite, write_suite
from probe.tasks.task import LETTERS, PAIR, Letter, Option, QuestionType, Task
from task_examples import FIND

SALT = Salt(bytes.fromhex("5b7e0c51d6a94f3e8f20c7b1a6d3940e17c85fa2be603d99e4714c082ab5f6d3"))
COUNTS: dict[QuestionType, int] = {
    "beneath": 170, "compare": 160, "count": 170, "find": 170, "reduce": 170, "size": 160,
}  # fmt: skip
BASES = (1000, 1500, 0, 2_000_000)
"""Numbers of first episodes that docs and packaged suites mention, the likeliest first."""

LEVEL = 0.001
"""How rarely chance alone goes beyond the limit, for each attack."""


@dataclass(frozen=True)
class Seen:
    """What somebody sees of a task before it is answered: never a scene, a seed or a letter."""

    question_type: QuestionType
    id: str
    position: int
    """Among those of its type."""


Attack = Callable[[Sequence[Seen]], list[Letter | None]]


def seen(tasks: Sequence[Task]) -> list[Seen]:
    found = list[Seen]()
    for task in tasks:
        position = sum(it.question_type == task.question_type for it in found)
        found.append(Seen(task.question_type, task.id, position))
    return found


def by_position(base: int) -> Attack:
    """The plan of the episode at a task's place."""
    return lambda suite: [
        plan(it.question_type, (base + it.position) * ATTEMPTS).letter for it in suite
    ]


def by_id(suite: Sequence[Seen]) -> list[Letter | None]:
    """Seeds whose hash an id is, found by trying; a few hundred thousand are enough for v1."""
    return [by_hash(it.question_type).get(it.id[: len(it.question_type) + 9]) for it in suite]


@cache
def by_hash(question_type: QuestionType) -> dict[str, Letter]:
    """Letters of the plans of many episodes, by the ids that their attempts have."""
    letters = dict[str, Letter]()
    for base in BASES:
        for episode in range(base, base + 250):
            letter = plan_of(question_type, episode).letter
            for number in range(40):
                letters.setdefault(task_id(question_type, episode * ATTEMPTS + number), letter)
    return letters


def by_salt(guess: Salt) -> Attack:
    """Ids keyed with a salt that somebody might have taken, over first tries."""

    def attack(suite: Sequence[Seen]) -> list[Letter | None]:
        letters: dict[str, Letter] = {
            attempt.id: attempt.plan.letter
            for place in places_of(COUNTS, 0)
            for attempt in (Attempt(place, number, guess) for number in range(5))
        }
        return [letters.get(it.id) for it in suite]

    return attack


def by_digits(suite: Sequence[Seen]) -> list[Letter | None]:
    """The id's last digit."""
    offered: list[tuple[Letter, ...]] = [
        PAIR if it.question_type in PAIRED else LETTERS for it in suite
    ]
    return [
        letters[int(it.id[-1], 16) % len(letters)]
        for it, letters in zip(suite, offered, strict=True)
    ]


def limit(question_types: Sequence[QuestionType]) -> int:
    """Most right answers that chance brings, but for LEVEL of all cases."""
    pairs = sum(question_type in PAIRED for question_type in question_types)
    two = stats.binom.pmf(np.arange(pairs + 1), pairs, 1 / 2)
    five = stats.binom.pmf(
        np.arange(len(question_types) - pairs + 1), len(question_types) - pairs, 1 / 5
    )
    return int(np.searchsorted(np.cumsum(np.convolve(two, five)), 1 - LEVEL))


def hits(attack: Attack, tasks: Sequence[Task]) -> tuple[int, int]:
    """How many letters are foretold rightly, of how many that are foretold; and the limit."""
    guesses = attack(seen(tasks))
    made = [(task, letter) for task, letter in zip(tasks, guesses, strict=True) if letter]
    right = sum(task.answer == letter for task, letter in made)
    return right, limit([task.question_type for task, _ in made])


@pytest.fixture(scope="module")
def library(cache) -> Library:
    return open_library("procedural", None, cache)


@pytest.fixture(scope="module")
def private(library: Library, tmp_path_factory) -> Sequence[Task]:
    """1,000 tasks as a private build names, plans and orders them; without their scenes."""
    parts = BuildFolder(tmp_path_factory.mktemp("private.parts"))
    places, marks = places_of(COUNTS, 0), freeze("part", (FIND,), library).objects
    tries = np.random.default_rng(3).geometric(0.4, size=len(places)) - 1
    for place, number in zip(places, tries, strict=True):
        last = Attempt(place, int(number), SALT)
        seeds = [Attempt(place, each, SALT).bears for each in range(last.number)]
        log = [CandidateLog(place.question_type, seed, "nest", None, "", 1.0) for seed in seeds]
        log.append(CandidateLog(place.question_type, last.bears, KEPT, None, "", 1.0))
        parts.log_path(place).write_text("".join(f"{line}\n" for line in log))
        letters: tuple[Letter, ...] = PAIR if place.question_type in PAIRED else LETTERS
        task = replace(
            FIND,
            question_type=place.question_type,
            form=last.plan.form,
            id=last.id,
            seed=last.bears,
            scene=replace(FIND.scene, seed=last.bears),
            targets=tuple(placed.instance for placed in FIND.scene.objects[:2]),
            answer=last.plan.letter,
            options=tuple(Option(each, each) for each in letters),
        )
        write_suite(parts.task_path(place), Suite("part", (task,), marks))
    path = parts.folder.with_name("private.json")
    assemble(path, parts, places, library, SALT)
    return read_suite(path).tasks


KNOWN = {
    **{f"plan from episode {base} on": by_position(base) for base in BASES},
    "ids": by_id,
    "ids, zeros as salt": by_salt(Salt(bytes(32))),
    "ids, ones as salt": by_salt(Salt(b"\xff" * 32)),
    "last digit": by_digits,
}


@pytest.mark.parametrize("attack", KNOWN.values(), ids=KNOWN)
def test_letters_of_a_private_suite_are_foretold_by_chance_alone(private, attack):
    assert len(private) == 1000
    right, most = hits(attack, private)
    assert right <= most


@pytest.mark.parametrize(("name", "first"), [("v1", 1000), ("v1-scans", 1500)])
def test_the_same_attacks_foretell_every_letter_of_a_public_suite(name, first):
    tasks = packaged_suite(name).tasks
    for attack in (by_position(first), by_id):
        right, most = hits(attack, tasks)
        assert right == len(tasks) > most


def left_over(letters: Sequence[str], question_types: Sequence[QuestionType]) -> tuple[int, int]:
    """Of five tasks in a row, somebody was told four letters, all different: is the fifth left?"""
    right = told = 0
    for start in range(0, len(letters) - 4):
        five = letters[start : start + 5]
        if (
            len({*question_types[start : start + 5]}) > 1
            or question_types[start] in PAIRED
            or start % 5
        ):
            continue
        if len({*five[:4]}) == 4:
            told += 1
            right += five[4] not in five[:4]
    return right, told


def test_blocks_of_the_plan_cant_be_counted_out(private):
    five = [task for task in private if task.question_type not in PAIRED]
    right, told = left_over([t.answer for t in five], [t.question_type for t in five])
    assert told > 10 and right <= float(stats.binom.ppf(1 - LEVEL, told, 1 / 5))
    # In the order of episodes it is, every time.
    places = [place for place in places_of(COUNTS, 0) if place.question_type not in PAIRED]
    letters = [plan_of(*place, SALT).letter for place in places]
    right, told = left_over(letters, [place.question_type for place in places])
    assert right == told == 4 * 170 // 5


def test_seeds_in_records_are_neither_small_nor_what_scenes_are_made_from(private):
    made = {Attempt(place, n, SALT).seed for place in places_of(COUNTS, 0) for n in range(40)}
    borne = [task.seed for task in private]
    assert all(PRIVATE_FROM <= seed < 2**128 for seed in borne)
    assert len({*borne}) == 1000 and not made & {*borne}
    # Bits that go with nothing: each is set in half of the seeds.
    bits = np.array([[seed >> bit & 1 for bit in range(127)] for seed in borne])
    low, high = (float(stats.binom.ppf(share, 1000, 1 / 2)) for share in (1e-5, 1 - 1e-5))
    assert low <= bits.sum(axis=0).min() and bits.sum(axis=0).max() <= high
