import numpy as np
import pytest

from probe.agents.scripted import Scripted
from tabletops import Block, Obedient, spec

SPECS = {
    1: spec("blue bowl", "blue"),
    2: spec("red die", "red"),
    3: spec("yellow duck", "yellow"),
    4: spec("green book", "green"),
    5: spec("red die", "red"),
    6: spec("brown box", "brown"),
}
COVER = Block(1, (300, 300, 499, 499), 0.08, (30, 60, 150))
BOOK = Block(4, (700, 100, 899, 299), 0.03, (40, 120, 50))
BOX = Block(6, (600, 600, 899, 899), 0.15, (110, 70, 42))
NONE = "None of the above"
OPTIONS = ["red die", "white cup", "black pen", "gray tin", NONE]


def rng():
    return np.random.default_rng(5)


def under(instance):
    return Block(instance, (370, 370, 429, 429), 0.02)


@pytest.mark.parametrize("first", ["grasp", "push"])
def test_beneath_names_what_comes_to_light(play, first):
    agent = Scripted("beneath", "blue bowl", rng(), first)
    skills = Obedient()
    record = play(agent, OPTIONS, SPECS, [COVER, BOOK, under(2)], skills)
    assert record.answer and record.answer.choice == "A"
    assert [call[0] for call in skills.calls][0] == first


def test_beneath_says_none_if_something_unlisted_comes_to_light(play):
    agent = Scripted("beneath", "blue bowl", rng())
    record = play(agent, OPTIONS, SPECS, [COVER, BOOK, under(3)])
    assert record.answer and record.answer.choice == "E"


def test_beneath_abstains_if_nothing_comes_to_light(play):
    agent = Scripted("beneath", "blue bowl", rng())
    record = play(agent, OPTIONS, SPECS, [COVER, BOOK])
    assert record.end == "stopped" and record.answer is None


def test_beneath_clears_what_still_lies_on_it(play):
    agent = Scripted("beneath", "blue bowl", rng())
    lid = Block(4, (350, 350, 449, 449), 0.05, (40, 120, 50))
    cover = Block(1, (300, 300, 499, 499), 0.04, (30, 60, 150))
    record = play(agent, OPTIONS, SPECS, [cover, lid, under(2)])
    assert record.answer and record.answer.choice == "A"


def test_a_failed_grasp_is_followed_by_a_push(play):
    skills = Obedient("blocked")
    record = play(Scripted("beneath", "blue bowl", rng()), OPTIONS, SPECS, [COVER], skills)
    assert [call[0] for call in skills.calls[:3]] == ["grasp", "push", "grasp"]
    assert record.answer is None


def test_find_points_at_an_option_in_the_last_picture(play):
    agent = Scripted("find", "", rng())
    hidden = Block(2, (700, 700, 759, 759), 0.02)
    record = play(agent, OPTIONS, SPECS, [COVER, BOOK, BOX, hidden])
    assert record.answer and record.answer.choice == "A"
    assert record.answer.point_px is not None
    assert 700 <= record.answer.point_px[0] <= 759


def test_find_says_none_only_when_all_is_cleared(play):
    record = play(Scripted("find", "", rng()), OPTIONS, SPECS, [COVER, BOOK, BOX])
    assert record.answer and record.answer.choice == "E"
    half_hidden = Block(3, (50, 50, 90, 90), share=0.1)
    record = play(Scripted("find", "", rng()), OPTIONS, SPECS, [COVER, half_hidden])
    assert record.answer is None


def test_count_adds_what_comes_to_light_and_keeps_what_counts(play):
    dice = [Block(2, (100, 800, 159, 859)), Block(5, (700, 700, 759, 759), 0.02)]
    agent = Scripted("count", "red die", rng())
    record = play(agent, ["1", "2", "3", "4", NONE], SPECS, [COVER, BOOK, BOX, *dice])
    assert record.answer and record.answer.choice == "B"
    assert {o.instance for o in record.scenes[-1].objects} >= {2, 5}


def test_count_says_none_if_the_number_is_not_offered(play):
    agent = Scripted("count", "red die", rng())
    record = play(agent, ["1", "2", "3", "4", NONE], SPECS, [COVER])
    assert record.answer and record.answer.choice == "E"


def test_the_same_generator_gives_the_same_episode(play):
    def once():
        agent = Scripted("find", "", rng(), "push")
        return play(agent, OPTIONS, SPECS, [COVER, BOOK, BOX]).untimed()

    assert once() == once()


@pytest.mark.parametrize("question_type", ["find", "count"])
def test_with_its_budget_spent_it_abstains_unless_it_is_bold(play, question_type):
    blocks = [
        Block(
            20 + n,
            (10 + 250 * (n % 4), 10 + 250 * (n // 4), 200 + 250 * (n % 4), n // 4 * 250 + 200),
        )
        for n in range(12)
    ]
    specs = {
        20 + n: spec(f"{letter * 3} board", "brown") for n, letter in enumerate("bcdfghjklmnp")
    }
    options = [*("1", "2", "3", "4"), NONE] if question_type == "count" else OPTIONS
    strict = play(Scripted(question_type, "red die", rng()), options, specs, blocks)
    bold = play(Scripted(question_type, "red die", rng(), bold=True), options, specs, blocks)
    assert strict.manipulations == bold.manipulations == 10
    assert strict.answer is None
    assert bold.answer and bold.answer.choice == "E"
