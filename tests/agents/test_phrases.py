"""The scripted teacher's words: true of what the tools told it, and without any effect."""

from __future__ import annotations

import re
import string
from dataclasses import replace

import numpy as np
import pytest

from probe.agents.phrases import PhraseBook, phrases, plainly, silent
from probe.agents.reading import read_graph
from probe.agents.scripted import Scripted
from probe.agents.type_plan import FirstLookQuestion, plan_for
from probe.episodes.turns import Question, Turn
from probe.errors import UnknownName
from probe.perception.oracle import Oracle
from probe.toolshed.graph import scene_text
from probe.toolshed.result import ToolResult
from tabletops import Block, Done, Obedient, paint, spec

SPECS = {
    1: spec("blue bowl", "blue"),
    2: spec("red die", "red"),
    3: spec("yellow duck", "yellow"),
    4: spec("green book", "green"),
    6: spec("brown box", "brown"),
}
COVER = Block(1, (300, 300, 499, 499), 0.08, (30, 60, 150))
BOOK = Block(4, (700, 100, 899, 299), 0.03, (40, 120, 50))
BOX = Block(6, (600, 600, 899, 899), 0.15, (110, 70, 42))
DIE = Block(2, (370, 370, 429, 429), 0.02)
NONE = "None of the above"
OPTIONS = ["red die", "white cup", "black pen", "gray tin", NONE]
TEXT = "Which? In the first picture, the marks are A at (330, 250) and B at (720, 700)."
PAIR = ["Object A", "Object B"]
MARKED = [
    Block(2, (200, 200, 349, 299), 0.02),
    Block(3, (640, 660, 739, 739), 0.02, (200, 180, 40)),
    Block(1, (150, 150, 319, 349), 0.08, (30, 60, 150)),
    Block(4, (560, 620, 689, 779), 0.08, (40, 120, 50)),
]
CASES = {
    "beneath": ("blue bowl", "plain", OPTIONS, [COVER, BOOK, DIE], "?"),
    "reduce": ("blue bowl, green book", "plain", OPTIONS, [COVER, BOOK, DIE], "?"),
    "find": ("", "plain", OPTIONS, [COVER, BOOK, BOX, DIE], "?"),
    "count": ("red die", "plain", ["1", "2", "3", "4", NONE], [COVER, BOOK, BOX, DIE], "?"),
    "size": ("", "longer", PAIR, MARKED, TEXT),
    "compare": ("yellow", "colour", PAIR, MARKED, TEXT),
}


def rng(seed=5):
    return np.random.default_rng(seed)


def played(play, question_type, say, skills=None):
    subject, form, options, blocks, text = CASES[question_type]
    agent = Scripted(question_type, subject, rng(), form=form, say=say)
    return play(agent, options, SPECS, blocks, skills or Obedient(), text)


def unspoken(record):
    steps = tuple(replace(it, call=replace(it.call, words="")) for it in record.steps)
    return replace(record, steps=steps).untimed()


@pytest.mark.parametrize("question_type", CASES)
def test_words_change_nothing_that_is_done(play, question_type):
    spoken = played(play, question_type, PhraseBook(rng()))
    mute = played(play, question_type, silent)
    assert unspoken(spoken) == mute.untimed()
    assert spoken.answer is not None
    assert all(step.call.words for step in spoken.steps)
    assert not any(step.call.words for step in mute.steps)


@pytest.mark.parametrize("question_type", CASES)
def test_names_that_it_says_were_told_before(play, question_type):
    record = played(play, question_type, PhraseBook(rng()))
    told = "\n".join([CASES[question_type][0], *(text for _, text in record.question.options), ""])
    for step in record.steps:
        for name in (it.name for it in SPECS.values()):
            assert name not in step.call.words or name in told
        told += step.text


@pytest.mark.parametrize("question_type", CASES)
def test_the_answer_it_explains_is_the_one_it_gives(play, question_type):
    record = played(play, question_type, PhraseBook(rng()))
    letter = record.answer.choice
    if letter != "E":
        assert re.search(rf"\b{letter}\b", record.steps[-1].call.words)


def last_words(play, question_type):
    return played(play, question_type, PhraseBook(rng())).steps[-1].call.words


def test_it_says_what_its_answer_rests_on(play):
    """Which ones it counted, of which size the two are, of which colour: as the lists tell."""
    count = played(play, "count", PhraseBook(rng()))
    die = next(it for it in read_graph(count.steps[-2].text).objects if it.name == "red die")
    assert f" {die.object_id}" in count.steps[-1].call.words
    pairs = re.findall(r"\[(\d+), (\d+)\]", last_words(play, "size"))
    one, two, longer = ([*map(int, pair)] for pair in pairs)
    assert sorted([one, two]) == [[100, 80], [150, 100]] and longer == [max(one), max(two)]
    said = last_words(play, "compare")
    assert re.search(r"\bis red\b", said) and re.search(r"\bis yellow\b", said)


def test_plainly_each_thing_is_said_in_one_way():
    slots = {"id": "object_3", "thing": "red die"}
    assert plainly("do grasp", slots) == plainly("do grasp", slots)
    first = phrases()["listed thing"][0]
    assert plainly("listed thing", slots) == first.format(**slots)
    with pytest.raises(UnknownName):
        plainly("no such occasion", slots)


def test_of_two_that_look_as_large_it_guesses(play):
    subject, form, options, _, text = CASES["size"]
    blocks = [Block(2, (280, 200, 379, 299)), Block(3, (660, 660, 759, 759))]
    agent = Scripted("size", subject, rng(), form=form, say=PhraseBook(rng()))
    record = play(agent, options, SPECS, blocks, Obedient(), text)
    letter = record.answer.choice
    guesses = [it.format(letter=letter) for it in phrases()["guess"]]
    assert any(record.steps[-1].call.words.endswith(guess) for guess in guesses)


def test_what_went_along_is_counted_apart(play):
    """A die on the bowl goes along with it."""
    subject, form, options, blocks, text = CASES["count"]
    on_top = [*blocks, Block(2, (440, 440, 489, 489), 0.1)]
    agent = Scripted("count", subject, rng(), form=form, say=PhraseBook(rng()))

    class Taking(Obedient):
        def grasp_and_remove(self, station, frame, mask, drop_at):
            station.blocks = [it for it in station.blocks if it is not on_top[-1]]
            return super().grasp_and_remove(station, frame, mask, drop_at)

    record = play(agent, options, SPECS, on_top, Taking(), text)
    assert "; (2) 1 that went along with what I lifted." in record.steps[-1].call.words
    assert record.answer.choice == "B"


def lists_and_words(record):
    """Each list with the words said of it: those of the call after it."""
    calls = zip(record.steps, record.steps[1:], strict=False)
    return [
        (read_graph(look.text), after.call.words)
        for look, after in calls
        if look.call.name == "perceive_scene"
    ]


def ids(graph, name):
    return [it.object_id for it in graph.objects if it.name == name]


def test_it_goes_through_the_first_list_thing_by_thing_to_count(play):
    subject, form, options, _, text = CASES["count"]
    blocks, specs = [Block(7, (600, 700, 659, 759)), COVER, DIE, BOOK], SPECS | {7: SPECS[2]}
    agent = Scripted("count", subject, rng(), form=form, say=PhraseBook(rng()))
    record = play(agent, options, specs, blocks, Obedient(), text)
    (graph, words), *later = lists_and_words(record)
    gone_through, _, rest = words.removeprefix("From top to bottom: ").partition(". ")
    each = [
        re.fullmatch(r"(object_\d+) (.*?)(?:, so \((\d)\) \2, \1)?", it)
        for it in gone_through.split("; ")
    ]
    assert [it and it.groups()[:2] for it in each] == [
        (it.object_id, it.name or "without a name") for it in graph.objects
    ]
    assert [it[3] for it in each if it and it[2] == "red die"] == ["1"]
    assert {it[3] for it in each if it and it[2] != "red die"} == {None}
    assert rest.startswith("I could search this: ") and later
    assert not any("From top to bottom" in words for _, words in later)


def test_after_each_later_list_it_says_what_it_has_counted_and_counts_on(play):
    (before, _), *told = lists_and_words(played(play, "count", PhraseBook(rng())))
    for graph, words in told:
        had, has = ids(before, "red die"), ids(graph, "red die")
        kept = "; ".join(f"({n}) red die, {id}" for n, id in enumerate(had, 1))
        so_far = "I have counted " + (
            f"each red die so far: {kept}." if had else "no red die so far."
        )
        assert words.startswith(so_far)
        fresh = [f"{id} red die, so ({len(had) + 1}) red die, {id}" for id in has if id not in had]
        new = words.removeprefix(so_far).partition(" I could search this")[0]
        assert new.startswith(" New, from top to bottom: object_") == bool(new)
        assert all(it in new for it in fresh) and new.count("so (") == len(fresh)
        before = graph
    assert len(ids(before, "red die")) == 1


def test_those_that_were_counted_before_stay_in_front(play):
    """A second die comes to light above the first in the picture, and is counted after it."""
    subject, form, options, _, text = CASES["count"]
    blocks, specs = [Block(7, (600, 700, 659, 759)), COVER, DIE], SPECS | {7: SPECS[2]}
    agent = Scripted("count", subject, rng(), form=form, say=PhraseBook(rng()))
    record = play(agent, options, specs, blocks, Obedient(), text)
    (first, words), *_, (last, final) = lists_and_words(record)
    (known,) = ids(first, "red die")
    new, again = ids(last, "red die")
    assert again == known and f"so (1) red die, {known}" in words
    assert final.startswith(f"I have counted each red die so far: (1) red die, {known}. New, ")
    assert f"{new} red die, so (2) red die, {new}" in final


OTHER_DIE = Block(7, (600, 700, 659, 759))


class Covering(Obedient):
    """Its second grasp fails and covers the other die."""

    def grasp_and_remove(self, station, frame, mask, drop_at):
        if len(self.calls) == 1:
            self.calls.append(("grasp",))
            station.blocks.remove(OTHER_DIE)
            return Done("blocked", station.observe(rgb=False))
        return super().grasp_and_remove(station, frame, mask, drop_at)


def test_if_nothing_that_was_counted_shows_any_more_it_says_so(play):
    subject, form, options, _, text = CASES["count"]
    agent = Scripted("count", subject, rng(), form=form, say=PhraseBook(rng()))
    blocks, specs = [OTHER_DIE, COVER, BOOK], SPECS | {7: SPECS[2]}
    told = lists_and_words(play(agent, options, specs, blocks, Covering(), text))
    gone = [words for graph, words in told if not ids(graph, "red die")]
    assert gone and ids(told[0][0], "red die")
    lost = "No red die that I have counted has its object_id any more. "
    assert all(words.startswith(lost) for words in gone)


def test_what_was_counted_and_is_hidden_again_counts_at_the_end(play):
    """A grasp of the book that fails covers one of two dice."""
    subject, form, options, _, text = CASES["count"]
    agent = Scripted("count", subject, rng(), form=form, say=PhraseBook(rng()))
    blocks, specs = [OTHER_DIE, COVER, BOOK, DIE], SPECS | {7: SPECS[2]}
    record = play(agent, options, specs, blocks, Covering(), text)
    told = lists_and_words(record)
    both = next(ids(graph, "red die") for graph, _ in told if len(ids(graph, "red die")) == 2)
    last, final = told[-1]
    (left,) = ids(last, "red die")
    so_far = f"I have counted each red die so far: (1) red die, {left}. "
    assert final.startswith(so_far) and "That makes" not in final
    assert all(id in final for id in both) and record.answer.choice == "B"


def test_without_object_ids_it_remarks_on_none():
    for question_type in ("count", "find", "reduce", "size"):
        subject, form, options, blocks, text = CASES[question_type]
        question = Question(text, tuple(zip("ABCDE", options, strict=False)))
        agent = Scripted(question_type, subject, rng(), form=form, say=PhraseBook(rng()))
        look = agent.act(question, [])
        frame = paint(blocks)
        listed = scene_text(Oracle(SPECS).detect(frame), (), frame)
        assert look and "object_id:" not in listed
        call = agent.act(question, [Turn(look, ToolResult(listed))])
        assert call and call.words and not re.search(r"object_|this:| None\b", call.words)


@pytest.mark.parametrize("question_type", ["beneath", "reduce"])
def test_after_each_list_it_says_what_is_still_there_and_what_is_new(play, question_type):
    record = played(play, question_type, PhraseBook(rng()))
    subjects = CASES[question_type][0].split(", ")
    told = lists_and_words(record)
    for number, (graph, words) in enumerate(told):
        left = [f"{name}, {id}" for name in subjects for id in ids(graph, name)]
        moving = f"I have to move this: {'; '.join(left)}."
        assert words.startswith(moving if left else "Nothing that I have to move shows any more.")
        new = {it.name for it in graph.named} - {it.name for it in told[0][0].named}
        assert ("This is new since the start: " in words) == bool(new) and all(
            re.search(rf"{name}, object_\d+[;.]", words)
            and re.search(rf"Of these: (.*; )?{name} is {as_option(record, name)}[;.]", words)
            for name in new
        )
        assert ("Nothing new can be named." in words) == (number > 0 and not new)


def as_option(record, name):
    letters = [letter for letter, text in record.question.options if text == name]
    return letters[0] if letters else "no option"


@pytest.mark.parametrize("question_type", ["find", "beneath", "reduce"])
def test_it_begins_with_each_option_and_its_letter(play, question_type):
    record = played(play, question_type, PhraseBook(rng()))
    *named, (none, _) = record.question.options
    each = "; ".join(f"{text} is {letter}" for letter, text in named)
    assert none == "E" and record.steps[0].call.words.startswith(f"The options: {each}. ")


def test_it_says_that_no_option_shows_and_then_at_which_one_it_points(play):
    told = lists_and_words(played(play, "find", PhraseBook(rng())))
    for graph, words in told:
        shown = ids(graph, "red die")
        assert ("None of the options shows." in words) != bool(shown)
        assert not shown or words.endswith(f"I point at {shown[0]}.")


@pytest.mark.parametrize("question_type", ["count", "find"])
def test_it_says_what_it_has_to_search_still_and_takes_the_first_of_it(play, question_type):
    record = played(play, question_type, PhraseBook(rng()))
    told = lists_and_words(record)
    for (graph, words), step in zip(told, record.steps[1::3], strict=False):
        left = re.search(r"I could search this: (?:(.*?); )?nothing more\. ", words)
        covers = [it for it in graph.named if it.name in ("blue bowl", "brown box", "green book")]
        in_vain = question_type == "count" or step.call.values.get("choice") == "E"
        assert bool(left) == (step.call.name == "find_object" or in_vain)
        assert not left or bool(left[1]) == (step.call.name == "find_object")
        if left and left[1]:
            each = [part.rsplit(", ", 1) for part in left[1].split("; ")]
            assert {(it.name, it.object_id) for it in covers} >= {(name, id) for name, id in each}
            first = next(it for it in covers if it.object_id == each[0][1])
            assert step.call.values["description"] == first.place


@pytest.mark.parametrize(("question_type", "wanted"), [("size", "longer"), ("compare", "yellow")])
def test_it_says_what_is_asked_and_which_listed_things_the_marks_are_on(
    play, question_type, wanted
):
    subject, form, options, blocks, _ = CASES[question_type]
    frame = paint(blocks)
    graph = read_graph(scene_text(Oracle(SPECS).detect(frame), (), frame))
    points = [
        next(it.point for it in graph.objects if it.name == name)
        for name in ("red die", "yellow duck")
    ]
    text = f"Which? In the first picture, the marks are A at {points[0]} and B at {points[1]}."
    agent = Scripted(question_type, subject, rng(), form=form, say=PhraseBook(rng()))
    told = lists_and_words(play(agent, options, SPECS, blocks, Obedient(), text))
    first, words = told[0]
    die, duck = (ids(first, name)[0] for name in ("red die", "yellow duck"))
    asked, rest = words.split(". ", 1)
    assert wanted in asked
    assert rest.startswith(
        f"Mark A at {points[0]} is on {die}. Mark B at {points[1]} is on {duck}."
    )
    assert f"Mark A is {die}, the red die." in words
    last, final = told[-1]
    assert f"Mark B is {ids(last, 'yellow duck')[0]}, the yellow duck." in final


def test_a_mark_that_no_list_has_a_point_at_is_left_open(play):
    said = "".join(words for _, words in lists_and_words(played(play, "size", PhraseBook(rng()))))
    assert not re.search(r"Mark [AB] (?:at|is) ", said)


def test_after_a_failure_it_says_so_and_why_it_does_something_else(play):
    record = played(play, "beneath", PhraseBook(rng()), Obedient("blocked"))
    told = [step.call.words for step in record.steps]
    pushed = next(n for n, step in enumerate(record.steps) if step.call.name == "push")
    after = phrases()["look blocked"]
    assert told[pushed - 2] in [way.format(thing="blue bowl") for way in after]
    assert any(told[pushed - 1].endswith(way) for way in phrases()["push blocked"])


def test_seeds_choose_other_words(play):
    ways = {played(play, "find", PhraseBook(rng(n))).steps[1].call.words for n in range(12)}
    assert len(ways) > 3
    one, same = (played(play, "find", PhraseBook(rng(3))).untimed() for _ in range(2))
    assert one == same


def test_each_phrase_can_be_said():
    slots = {
        "thing", "other", "letter", "number", "direction", "one", "two", "each", "size_one",
        "size_two", "colour", "colour_one", "colour_two", "id", "text", "place",
        "long_one", "long_two", "greater", "lesser", "letter_more", "letter_less",
    }  # fmt: skip
    for occasion, ways in phrases().items():
        used = [{name for _, name, _, _ in string.Formatter().parse(way) if name} for way in ways]
        assert all(names <= slots for names in used), occasion
        assert len(set(ways)) == len(ways), occasion
        assert all(way[0].isupper() and way.endswith(".") for way in ways), occasion
    with pytest.raises(UnknownName, match="occasion"):
        PhraseBook(rng())("never", {})


def glance(question_type, subject, form, options, blocks, text="?"):
    frame = paint(blocks)
    graph = read_graph(scene_text(Oracle(SPECS).detect(frame), (), frame))
    question = Question(text, tuple(zip("ABCDE", options, strict=False)))
    asked = FirstLookQuestion(question, subject, form, graph)
    return plan_for(question_type).at_sight(asked, PhraseBook(rng()))


@pytest.mark.parametrize("question_type", ["beneath", "reduce", "find", "count", "size"])
def test_at_first_sight_it_is_silent_where_the_evidence_is_hidden(question_type):
    subject, form, options, blocks, text = CASES[question_type]
    lying_on = [replace(block, share=0.1) if block.height < 0.03 else block for block in blocks]
    assert glance(question_type, subject, form, options, lying_on, text) is None


def test_one_of_two_that_can_be_named_tells_the_colour():
    half = [MARKED[0], replace(MARKED[1], share=0.1), *MARKED[2:]]
    asked = ("compare", "red", "colour", PAIR, half, TEXT)
    said = glance(*asked)
    assert said and said.letter == "A" and "red die" in said.words
    other = glance("compare", "yellow", "colour", PAIR, half, TEXT)
    assert other and other.letter == "B" and "red die" in other.words
    assert glance("compare", "", "darker", PAIR, half, TEXT) is None


def test_what_shows_is_answered_at_once():
    found = glance("find", "", "plain", OPTIONS, [BOOK, Block(2, (500, 500, 559, 559))])
    assert found and found.letter == "A" and found.point == (529, 529)
    both = [Block(2, (280, 200, 379, 299)), Block(3, (660, 660, 799, 799))]
    size = glance("size", "", "larger", PAIR, both, TEXT)
    assert size and size.letter == "B"
    one = glance("count", "red die", "plain", ["1", "2"], [Block(2, (500, 500, 559, 559))])
    # Who answers at sight was told no object_ids.
    assert one and "the thing at (529, 529)" in one.words and "object_" not in one.words
    zero = glance("count", "red die", "plain", ["0", "2"], [Block(3, (1, 1, 60, 60))])
    assert zero and zero.letter == "A" and "none" in zero.words
    none = glance(
        "count", "red die", "plain", ["1", "2", "3", "4", NONE], [Block(3, (1, 1, 60, 60))]
    )
    assert none and none.letter == "E"
