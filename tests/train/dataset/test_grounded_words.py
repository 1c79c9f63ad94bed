"""What the teacher notes of a list can be read in the short lists that a student is told."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator

import pytest

from packed_teacher import all_episodes
from probe.episodes.record import EpisodeRecord
from probe.train.collect.teacher import speaker
from probe.train.dataset.augment.listed_ids import SayWithoutFinding, without_finding
from probe.train.dataset.augment.rephrasing import rephrased
from probe.transcripts.result_texts import ResultTexts

LINE = re.compile(
    r"^- (object_\d+) at (\[\d+, \d+\])(?:(, new)|, another)?: (.*), \1, \[\d+, \d+\](.*)$",
    re.MULTILINE,
)

Known = dict[str, tuple[str, str, str, str]]
"""By object_id: its point, what it is, what follows the size of its box, and whether it is new."""


@pytest.fixture(scope="module")
def said(tmp_path_factory) -> list[tuple[str, Known, str]]:
    """Questions with their options, what is known of a table, and what the teacher says then."""
    told = list[tuple[str, Known, str]]()
    for task, record in all_episodes(tmp_path_factory.mktemp("packed")):
        words = SayWithoutFinding(speaker(task, record.run))
        spoken = rephrased(task, record, words)
        options = (f"{option.letter}: {option.text}" for option in task.options)
        asked = "\n".join([task.question, *options])
        told += [(asked, *each) for each in known_and_said(without_finding(spoken))]
    assert len(told) > 1000
    return told


def known_and_said(record: EpisodeRecord) -> Iterator[tuple[Known, str]]:
    """What a student knows before each call that isn't a look, and the words with that."""
    texts, known = ResultTexts("0-1000", "short"), Known()
    for step in record.steps:
        if step.call.name != "perceive_scene":
            yield dict(known), step.call.words
        text = texts.told(step.call.name, step.text)
        if step.call.name == "perceive_scene":
            for id in re.findall(r"object_\d+", text.partition("out of date: ")[2]):
                del known[id]
            for id, point, new, what, more in LINE.findall(text):
                # What is told again isn't marked again.
                before = known.get(id, ("", "", "", ""))
                known[id] = (point, what, more, new or (before[3] if before[1] == what else ""))


def called(known: Known, name: str) -> set[str]:
    return {id for id, (_, what, *_) in known.items() if what == name}


SO_FAR = re.compile(
    r"I have counted (?:each (?P<name>.*?) so far: (?P<each>.*?)|no (?P<none>.*?) so far)\. "
    r"(?:New, from top to bottom: (?P<new>.*?)\. )?I could search"
)


def test_it_counts_on_until_it_has_all_that_have_the_name(said):
    notes = [(known, found) for _, known, words in said if (found := SO_FAR.match(words))]
    assert len(notes) > 100 and {bool(found["none"]) for _, found in notes} == {True, False}
    for known, found in notes:
        name = found["name"] or found["none"]
        counted = f"{found['each'] or ''}; {found['new'] or ''}"
        each = re.findall(r"\((\d+)\) ([^;]*), (object_\d+)", counted)
        assert {it[2] for it in each} == called(known, name)
        assert {it[1] for it in each} <= {name}
        numbers = [int(it) for it in re.findall(r"\((\d+)\) ", counted)]
        assert numbers == sorted({*numbers})


def test_to_count_it_goes_through_the_first_list_in_its_order(said):
    lists = [
        (known, found[1])
        for _, known, words in said
        if (found := re.match(r"From top to bottom: (.*?)\. I could search this: ", words))
    ]
    assert len(lists) > 100
    for known, each in lists:
        told = [
            re.fullmatch(r"(object_\d+) (.*?)(?:, so \((\d+)\) \2, \1)?", it)
            for it in each.split("; ")
        ]
        assert [it and it[1] for it in told] == [*known]
        named = [it.groups() for it in told if it and it[2] != "without a name"]
        assert all(known[id][1] == what for id, what, _ in named)
        counted = [(what, number) for _, what, number in named if number]
        assert [number for _, number in counted] == [str(n + 1) for n in range(len(counted))]
        for name, _ in counted:
            assert len(counted) == len(called(known, name))


def test_marks_are_where_the_question_and_the_list_say(said):
    notes = [
        (question, known, *found)
        for question, known, words in said
        for found in re.findall(r"Mark ([AB]) at \((\d+), (\d+)\) is on (object_\d+)\.", words)
    ]
    assert len(notes) > 100
    for question, known, letter, u, v, id in notes:
        mark = re.search(rf"{letter} at \((\d+), (\d+)\)", question)
        assert mark and [round(int(it) / 1.024) for it in mark.groups()] == [int(u), int(v)]
        point = [int(it) for it in re.findall(r"\d+", known[id][0])]
        assert abs(point[0] - int(u)) <= 9 and abs(point[1] - int(v)) <= 9


def test_what_it_calls_new_is_what_the_lists_call_new(said):
    notes = [
        (known, found[1] or "")
        for _, known, words in said
        if (
            found := re.search(
                r"(?:This is new since the start: (.*?)|Nothing new can be named)\.", words
            )
        )
    ]
    assert len(notes) > 100
    for known, each in notes:
        new = {id for id, (_, _, _, is_new) in known.items() if is_new}
        assert {*re.findall(r"object_\d+", each)} == new
    assert sum(bool(each) for _, each in notes) > 20


def test_of_what_is_new_it_says_which_option_it_is(said):
    noted = Counter[bool]()
    for question, _, words in said:
        offered = {text: letter for letter, text in re.findall(r"^([A-E]): (.*)$", question, re.M)}
        for new, options in re.findall(
            r"This is new since the start: (.*?)\. Of these: (.*?)\.", words
        ):
            told = dict(each.rsplit(" is ", 1) for each in options.split("; "))
            assert {*told} == {each.rsplit(", ", 1)[0] for each in new.split("; ")}
            for name, option in told.items():
                assert option == offered.get(name, "no option")
                noted[name in offered] += 1
    assert noted[True] > 20 and noted[False] > 20


def test_all_that_it_could_search_is_told_by_name_and_object_id(said):
    lists = [
        (known, [part.rsplit(", ", 1) for part in found[1].split("; ") if part])
        for _, known, words in said
        if (found := re.search(r"I could search this: (?:(.*?); )?nothing more\. ", words))
        and found[1]
    ]
    assert sum("I could search this: nothing more. " in words for *_, words in said) > 100
    assert max(len(each) for _, each in lists) > 6
    assert all(known[id][1] == name for known, each in lists for name, id in each)


def test_object_ids_and_names_belong_together(said):
    forms = (
        r"(?:Next is|I turn to) the (?P<what>.*?), (?P<id>object_\d+)\.",
        r"Mark [AB] is (?P<id>object_\d+), the (?P<what>.*?)(?: \(\w+\))?\.(?: |$)",
        r"(?:this: |since the start: |each [^.;:]*: |; )(?:object_\d+ [^.;]*, so )?(?:\(\d+\) )?"
        r"(?P<what>[^.;]*?), (?P<id>object_\d+)(?=[.;,])",
    )
    for form in forms:
        found = [(known, it) for _, known, words in said for it in re.finditer(form, words)]
        assert len(found) > 5, form
        for known, it in found:
            assert known[it["id"]][1] == it["what"]


def test_a_colour_that_a_name_lacks_is_in_its_line(said):
    found = [
        (known[it["id"]][2], it["colour"])
        for _, known, words in said
        for it in re.finditer(
            r"Mark [AB] is (?P<id>object_\d+), [^.]* \((?P<colour>\w+)\)\.", words
        )
    ]
    assert found
    for line, colour in found:
        assert colour in re.findall(r"\w+", line.partition(", under ")[0])


def test_what_hides_a_marked_thing_is_in_its_line(said):
    """Or it touches the thing, or is where the mark was."""
    told = re.compile(
        r"Mark (?P<letter>[AB]) is (?P<id>object_\d+), (?:(?!Mark ).)*?"
        r"what is marked (?P=letter)(?: I see|, I have to take) (?P<over>object_\d+)"
    )
    found = [(known, it) for _, known, words in said if (it := told.search(words))]
    assert len(found) > 20
    for known, it in found:
        assert it["over"] in re.findall(r"object_\d+", known[it["id"]][2])
