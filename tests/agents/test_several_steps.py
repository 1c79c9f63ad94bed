"""Plans of several steps: covers under covers, like covers, and orders to remove nothing else."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from probe.agents.moves import Way
from probe.agents.phrases import PhraseBook
from probe.agents.scripted import Scripted
from tabletops import Block, Obedient, spec

SPECS = {
    1: spec("blue bowl", "blue"),
    2: spec("red die", "red"),
    3: spec("yellow duck", "yellow"),
    4: spec("green book", "green"),
    5: spec("white egg", "white"),
    6: spec("brown box", "brown"),
    7: spec("gray tray", "gray"),
    8: spec("blue bowl", "blue"),
    9: spec("blue bowl", "blue"),
    10: spec("black die", "black"),
}
NONE = "None of the above"
OPTIONS = ["red die", "white cup", "black pen", "gray tin", NONE]
TRAY = Block(7, (250, 250, 549, 549), 0.10, (120, 120, 120))
BOWL = Block(1, (300, 300, 499, 499), 0.08, (30, 60, 150))
BOX = Block(6, (650, 650, 899, 899), 0.15, (110, 70, 42))
PLACES = (60, 370, 680)
BOWLS = [
    Block(number, (left, 100, left + 199, 299), 0.08, (30, 60, 150))
    for number, left in zip((1, 8, 9), PLACES, strict=True)
]


def agent(
    question_type: str, subject: str, first: Way = "grasp", *, form: str = "plain"
) -> Scripted:
    rng = np.random.default_rng
    return Scripted(question_type, subject, rng(5), first, form=form, say=PhraseBook(rng(6)))


def inside(instance: int) -> Block:
    """Something under the tray's bowl."""
    return Block(instance, (370, 370, 429, 429), 0.02)


def under(place: int, instance: int) -> Block:
    """Something under one of the like bowls."""
    left = PLACES[place] + 70
    return Block(instance, (left, 170, left + 59, 229), 0.02)


def ways(skills: Obedient) -> list[object]:
    return [call[0] for call in skills.calls]


@pytest.mark.parametrize(("hidden", "letter"), [(2, "A"), (3, "E")])
def test_nested_lifts_both_covers_and_names_what_is_at_the_bottom(play, hidden, letter):
    skills = Obedient()
    blocks = [TRAY, BOWL, inside(hidden), BOX]
    record = play(agent("nested", "gray tray"), OPTIONS, SPECS, blocks, skills)
    assert record.answer and record.answer.choice == letter
    assert ways(skills) == ["grasp", "grasp"]


def test_nested_does_not_take_the_inner_cover_for_the_answer(play):
    record = play(agent("nested", "gray tray"), OPTIONS, SPECS, [TRAY, BOWL])
    assert record.answer is None


def test_nested_follows_a_cover_that_is_pushed_and_drags_the_others_along(play):
    class Dragging(Obedient):
        def push(self, station, frame, mask, direction, distance_m, basket):
            done = super().push(station, frame, mask, direction, distance_m, basket)
            if len(self.calls) == 1:
                moved = (60, 0, 60, 0)
                station.blocks = [
                    b if b.instance == 7 else _shifted(b, moved) for b in station.blocks
                ]
            return done

    blocks = [TRAY, BOWL, inside(2)]
    record = play(agent("nested", "gray tray", "push"), OPTIONS, SPECS, blocks, Dragging())
    assert record.answer and record.answer.choice == "A"


def _shifted(block: Block, by: tuple[int, int, int, int]) -> Block:
    box = tuple(c + d for c, d in zip(block.box, by, strict=True))
    return replace(block, box=box)


@pytest.mark.parametrize(("place", "lifted"), [(0, 1), (1, 2), (2, 3)])
def test_decoys_are_lifted_one_by_one_until_an_option_shows(play, place, lifted):
    secrets = [under(other, n) for other, n in zip({0, 1, 2} - {place}, (3, 5), strict=True)]
    skills = Obedient()
    blocks = [*BOWLS, under(place, 2), *secrets, BOX]
    record = play(agent("decoys", "blue bowl"), OPTIONS, SPECS, blocks, skills)
    assert record.answer and record.answer.choice == "A"
    assert ways(skills) == ["grasp"] * lifted


def test_decoys_are_all_lifted_before_none_is_said(play):
    skills = Obedient()
    blocks = [*BOWLS, under(0, 3), under(1, 4), under(2, 5)]
    record = play(agent("decoys", "blue bowl"), OPTIONS, SPECS, blocks, skills)
    assert record.answer and record.answer.choice == "E"
    assert ways(skills) == ["grasp"] * 3


def test_decoys_that_withstand_leave_no_answer(play):
    blocks = [*BOWLS, under(0, 3), under(1, 2), under(2, 5)]
    record = play(agent("decoys", "blue bowl"), OPTIONS, SPECS, blocks, Obedient("blocked"))
    assert record.answer is None


def lying(place: int, instance: int, wide: int, high: int = 30) -> Block:
    """Something of this size in pixels under one of the like bowls."""
    left = PLACES[place] + 20
    return Block(instance, (left, 140, left + wide - 1, 140 + high - 1), 0.02)


@pytest.mark.parametrize(("form", "letter"), [("longest", "E"), ("second", "A"), ("shortest", "E")])
def test_ranked_lifts_all_covers_and_compares_what_shows(play, form, letter):
    skills = Obedient()
    blocks = [*BOWLS, lying(0, 2, 90), lying(1, 3, 120), lying(2, 5, 30, 60), BOX]
    record = play(agent("ranked", "blue bowl", form=form), OPTIONS, SPECS, blocks, skills)
    assert record.answer and record.answer.choice == letter
    assert ways(skills) == ["grasp"] * 3


def test_ranked_says_nothing_before_it_has_seen_all_three(play):
    blocks = [*BOWLS, lying(0, 2, 90), lying(1, 3, 120), BOX]
    record = play(agent("ranked", "blue bowl", form="longest"), OPTIONS, SPECS, blocks)
    assert record.answer is None
    stubborn = Obedient("blocked")
    blocks = [*blocks, lying(2, 5, 60)]
    record = play(agent("ranked", "blue bowl", form="longest"), OPTIONS, SPECS, blocks, stubborn)
    assert record.answer is None


RING = [
    Block(number, (left, top, left + 199, top + 199), 0.08, (30, 60, 150))
    for number, (left, top) in zip((1, 8, 9), ((400, 50), (700, 600), (100, 600)), strict=True)
]
"""Three like bowls: at the top, right and left, in clockwise order."""


def in_ring(place: int, instance: int) -> Block:
    """Something under one of the bowls of the ring."""
    left, top, *_ = RING[place].box
    return Block(instance, (left + 70, top + 70, left + 129, top + 129), 0.02)


@pytest.mark.parametrize(
    ("start", "form", "letter", "lifted"),
    [
        (0, "clockwise", "A", 3),
        (0, "anticlockwise", "E", 2),
        # The named thing isn't seen: it is where neither of the two others is.
        (1, "clockwise", "A", 2),
        (2, "anticlockwise", "E", 2),
    ],
)
def test_relation_lifts_what_it_has_to_and_names_what_is_next(play, start, form, letter, lifted):
    step = 1 if form == "clockwise" else -1
    asked, third = ((start + step) % 3, (start - step) % 3)
    answer, other = (2, 5) if letter == "A" else (5, 2)
    hidden = [in_ring(start, 3), in_ring(asked, answer), in_ring(third, other)]
    skills, text = Obedient(), f"Going {form}, what is next to the yellow duck?"
    ring = agent("relation", "blue bowl", form=form)
    record = play(ring, OPTIONS, SPECS, [*RING, *hidden], skills, text=text)
    assert record.answer and record.answer.choice == letter
    assert ways(skills) == ["grasp"] * lifted


def test_relation_says_nothing_before_it_has_seen_what_is_next(play):
    hidden = [in_ring(0, 3), in_ring(1, 2), in_ring(2, 5)]
    ring = agent("relation", "blue bowl", form="clockwise")
    text = "What is next to the yellow duck?"
    blocks = [*RING, *hidden]
    record = play(ring, OPTIONS, SPECS, blocks, Obedient("blocked"), text=text)
    assert record.answer is None


@pytest.mark.parametrize("first", ["grasp", "push"])
@pytest.mark.parametrize(("hidden", "letter"), [(2, "A"), (3, "E")])
def test_exact_lifts_what_is_named_and_nothing_else(play, first, hidden, letter):
    skills = Obedient()
    book = Block(4, (650, 100, 849, 299), 0.03, (40, 120, 50))
    egg = Block(5, (700, 150, 759, 209), 0.02)
    subject = "green book, blue bowl"
    blocks = [BOWL, inside(hidden), book, egg, BOX]
    record = play(agent("exact", subject, first), OPTIONS, SPECS, blocks, skills)
    assert record.answer and record.answer.choice == letter
    assert ways(skills) == ["grasp", "grasp"]
    assert {placed.instance for placed in record.scenes[-1].objects} == {hidden, 5, 6}


@pytest.mark.parametrize("status", ["blocked", "no_candidate"])
def test_exact_never_pushes_nor_clears_what_lies_on_top(play, status):
    skills = Obedient(status)
    lid = Block(4, (350, 350, 449, 449), 0.09, (40, 120, 50))
    blocks = [BOWL, lid, inside(2)]
    record = play(agent("exact", "blue bowl"), OPTIONS, SPECS, blocks, skills)
    assert record.answer is None
    assert set(ways(skills)) <= {"grasp"}
    assert any(placed.instance == 4 for placed in record.scenes[-1].objects)


UNLIKE = [
    Block(number, (left, 100, left + 199, 299), 0.08, colour)
    for number, left, colour in zip(
        (7, 4, 1), PLACES, ((120, 120, 120), (40, 120, 50), (30, 60, 150)), strict=True
    )
]
"""A tray, a book and a bowl, from left to right."""

THREE_THERE = ["red die", "yellow duck", "white egg", "gray tin", NONE]
"""What lies under the tray, the book and the bowl, in this order, and something else."""


@pytest.mark.parametrize("first", ["grasp", "push"])
@pytest.mark.parametrize(
    ("subject", "letter"),
    [
        ("gray tray, green book, blue bowl", "A"),
        ("green book, gray tray, blue bowl", "B"),
        ("blue bowl, green book, gray tray", "C"),
    ],
)
def test_memory_names_what_was_under_the_cover_that_is_asked_about(play, first, subject, letter):
    skills = Obedient()
    blocks = [*UNLIKE, under(0, 2), under(1, 3), under(2, 5), BOX]
    record = play(agent("memory", subject, first), THREE_THERE, SPECS, blocks, skills)
    assert record.answer and record.answer.choice == letter
    assert ways(skills) == ["grasp"] * 3
    assert {placed.instance for placed in record.scenes[-1].objects} == {2, 3, 5, 6}


def test_memory_does_not_take_what_another_cover_hid_for_the_answer(play):
    blocks = [*UNLIKE, under(0, 10), under(1, 3), under(2, 5), BOX]
    asked = agent("memory", "gray tray, green book, blue bowl")
    record = play(asked, THREE_THERE, SPECS, blocks)
    assert record.answer and record.answer.choice == "E"


@pytest.mark.parametrize("status", ["blocked", "no_candidate"])
def test_memory_says_nothing_before_all_that_is_named_is_gone(play, status):
    skills = Obedient(status)
    blocks = [*UNLIKE, under(0, 2), under(1, 3), under(2, 5)]
    asked = agent("memory", "gray tray, green book, blue bowl")
    record = play(asked, THREE_THERE, SPECS, blocks, skills)
    assert record.answer is None
    assert set(ways(skills)) == {"grasp"}


LARGE = [
    Block(number, (left, 100, left + 249, 349), 0.08, (30, 60, 150))
    for number, left in ((1, 30), (6, 330), (7, 630))
]
NARROW = Block(4, (100, 600, 199, 699), 0.08, (40, 120, 50))
BUDGETED = "One lies flat and is about 10 centimetres long."


def long_or_short(place: int, instance: int, wide: int) -> Block:
    """Something under one of the large covers, so many pixels long; 10 cm are 177."""
    left = 30 + 300 * place + 20
    return Block(instance, (left, 200, left + wide - 1, 239), 0.02)


@pytest.mark.parametrize(("place", "lifted"), [(0, 1), (1, 2), (2, 3)])
@pytest.mark.parametrize(("hidden", "letter"), [(2, "A"), (3, "E")])
def test_budgeted_lifts_only_what_is_large_enough(play, place, lifted, hidden, letter):
    short = zip(sorted({0, 1, 2} - {place}), (5, 10), strict=True)
    secrets = [long_or_short(other, number, 80) for other, number in short]
    skills = Obedient()
    blocks = [*LARGE, NARROW, long_or_short(place, hidden, 180), *secrets]
    subject = "green book, blue bowl, brown box, gray tray"
    budgeted = agent("budgeted", subject)
    record = play(budgeted, OPTIONS, SPECS, blocks, skills, text=BUDGETED, manipulations=3)
    assert record.answer and record.answer.choice == letter
    assert ways(skills) == ["grasp"] * lifted
    assert 4 in {placed.instance for placed in record.scenes[-1].objects}


def test_budgeted_gives_up_when_its_manipulations_are_spent(play):
    skills = Obedient("blocked")
    blocks = [*LARGE, NARROW, long_or_short(0, 2, 180)]
    budgeted = agent("budgeted", "green book, blue bowl, brown box, gray tray")
    record = play(budgeted, OPTIONS, SPECS, blocks, skills, text=BUDGETED, manipulations=3)
    assert record.answer is None and len(skills.calls) == 3
