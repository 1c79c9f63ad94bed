"""Episodes with a slip: one turn is said again too late, is refused, and isn't learnt."""

from __future__ import annotations

import re
from contextlib import suppress
from dataclasses import replace

import numpy as np
import pytest

from packed_teacher import packed_episodes
from painted_teacher import SIZE, taught
from probe.agents.phrases import plainly
from probe.agents.reading import read_graph
from probe.assets.library import open_library
from probe.episodes.play import set_table
from probe.render.renderer import Renderer
from probe.toolshed.result import MOVING
from probe.train.dataset.augment.certain import NotCertain
from probe.train.dataset.augment.listed_ids import SayWithoutFinding, without_finding
from probe.train.dataset.augment.refusing import with_a_slip
from probe.train.dataset.augment.rephrasing import rephrased
from probe.train.dataset.examples import example_of
from probe.train.dataset.rows import trl_row
from probe.train.dataset.text_only import no_pictures
from probe.transcripts.messages import participation_of

SAY = SayWithoutFinding(plainly)


def listed(task, record):
    return without_finding(rephrased(task, record, SAY))


def slipped(record, seed=0):
    return with_a_slip(record, np.random.default_rng(seed), SAY)


@pytest.fixture(scope="module")
def all_slips(episodes):
    found = []
    for task, record in episodes:
        with suppress(NotCertain):
            before = listed(task, record)
            found.append((task, before, slipped(before, len(found))))
    assert len(found) > len(episodes) / 2
    return found


@pytest.fixture(scope="module")
def slips(all_slips):
    """Those with an object_id that is out of date."""
    return [it for it in all_slips if the_refused(it[2])]


@pytest.fixture(scope="module")
def early(all_slips):
    """Those before anything was listed."""
    found = [it for it in all_slips if not the_refused(it[2])]
    assert len(all_slips) / 8 < len(found) < len(all_slips) / 2
    return found


def the_refused(record):
    (at,) = (at for at, step in enumerate(record.steps) if step.status == "malformed")
    return at


def test_the_rest_is_as_it_was(slips):
    for _, before, after in slips:
        at = the_refused(after)
        assert (*after.steps[:at], *after.steps[at + 2 :]) == before.steps
        assert [reply.calls for reply in after.participation.replies] == [1] * len(after.steps)


def test_the_first_manipulation_may_come_before_any_list(early):
    for _, before, after in early:
        slip, *rest = after.steps
        assert tuple(rest) == before.steps and rest[0].call.name == "perceive_scene"
        assert slip.call == next(step.call for step in rest if step.call.name in MOVING)
        id = slip.call.values["object_id"]
        assert slip.text.startswith(f"There is no object_id '{id}'. ")
        assert slip.text.endswith("There are none yet.")


def by_a_former_id(after, at):
    """Whether it is the turn that comes, with an object_id that its thing had before."""
    slip, coming = after.steps[at].call, after.steps[at + 2].call
    ids = [it.values.get("object_id") for it in (slip, coming)]
    if ids[1] is None or re.sub(rf"\b{ids[0]}\b", ids[1], slip.words) != coming.words:
        return False
    lists = [read_graph(it.text) for it in after.steps if it.call.name == "perceive_scene"]
    one, two = (
        {seen.name for it in lists for seen in it.objects if seen.object_id == id} for id in ids
    )
    return bool(one & two - {None})


def test_an_earlier_turn_is_said_again_or_the_coming_one_with_a_former_object_id(slips):
    kinds = set[bool]()
    for _, before, after in slips:
        at = the_refused(after)
        again = after.steps[at].call in [step.call for step in before.steps[:at]]
        assert again != by_a_former_id(after, at)
        kinds.add(again)
    assert kinds == {True, False}


def test_its_object_id_is_in_no_list_any_more(slips):
    for _, _, after in slips:
        at = the_refused(after)
        again, look = after.steps[at : at + 2]
        id = again.call.values["object_id"]
        assert f"object_id: {id}\n" not in look.text
        assert any(f"object_id: {id}\n" in step.text for step in after.steps[:at])
        assert again.text.startswith(f"{id} is out of date: ")
        assert look.text == after.steps[at - 1].text
        assert look.call.words == f"By now {id} is out of date. I look at what there is."


def test_slips_come_at_different_turns(slips):
    before = max((it for _, it, _ in slips), key=lambda it: len(it.steps))
    assert len({the_refused(slipped(before, seed)) for seed in range(20)}) > 2


def test_all_but_the_slip_is_learnt(all_slips):
    for task, _, after in all_slips:
        example = example_of(task, after, no_pictures(after), augmented="refused")
        rows = trl_row(example)["messages"]
        said = [row for row in rows if row["role"] == "assistant"]
        at = the_refused(after)
        assert [row["weight"] for row in said] == [int(n != at) for n in range(len(said))]
        assert all(row["weight"] is None for row in rows if row["role"] != "assistant")


def of_steps(record, steps):
    played = replace(record, steps=steps, participation=None)
    return replace(played, participation=participation_of(played))


def test_where_nothing_is_out_of_date_a_slip_comes_first_and_where_nothing_moves_there_is_none():
    record = listed(SIZE, taught())
    first = next(n for n, it in enumerate(record.steps) if it.call.name == "grasp_and_remove")
    short = of_steps(record, record.steps[: first + 1])
    assert {the_refused(slipped(short, seed)) for seed in range(9)} == {0}
    with pytest.raises(NotCertain, match="moves nothing that it listed"):
        slipped(of_steps(record, record.steps[:first]))


@pytest.mark.parametrize("steps", [38, 39])
def test_an_episode_without_turns_left_has_no_slip(steps):
    record = listed(SIZE, taught())
    looks = (record.steps[0],) * (steps - len(record.steps))
    long = of_steps(record, (*looks, *record.steps))
    if steps + 2 <= 40:
        assert {len(slipped(long, seed).steps) for seed in range(20)} == {39, 40}
    else:
        with pytest.raises(NotCertain, match="no turns left"):
            slipped(long)


def test_once_all_manipulations_are_spent_there_is_no_slip(slips):
    """The tools then refuse a manipulation because none is left, whatever its object_id."""
    seen = 0
    for _, before, _, seed in ((*it, seed) for it in slips for seed in range(3)):
        spent = sum(step.call.name in MOVING for step in before.steps)
        question = replace(before.question, manipulations=spent)
        after = slipped(replace(before, question=question), seed)
        if at := the_refused(after):
            assert after.steps[at + 2].call.name in MOVING
            seen += 1
    assert seen > len(slips) / 2


def test_what_withstood_may_be_as_it_was_and_is_not_asked_for_again(slips):
    seen = 0
    for _, before, _, seed in ((*it, seed) for it in slips for seed in range(3)):
        failed = tuple(
            replace(step, status="failed") if step.call.name in MOVING else step
            for step in before.steps
        )
        after = slipped(replace(before, steps=failed), seed)
        if at := the_refused(after):
            assert by_a_former_id(after, at)
            seen += 1
    assert seen


def test_only_the_scripted_teachers_words_go_on_after_one():
    record = listed(SIZE, taught())
    with pytest.raises(NotCertain, match="isn't the scripted one"):
        slipped(replace(record, agent="somebody"))


def test_with_find_object_there_is_no_slip():
    with pytest.raises(NotCertain, match="finds things before it moves them"):
        slipped(rephrased(SIZE, taught(), SAY))


@pytest.mark.slow  # Two tables with physics.
def test_the_tools_refuse_it_so(tmp_path, cache):
    episodes = packed_episodes(tmp_path)
    longest = sorted(episodes, key=lambda it: -len(it[1].steps))[:2]
    objects = open_library("procedural-2", None, cache)
    with Renderer() as renderer:
        for (task, record), first in zip(longest, (True, False), strict=True):
            tools, _ = set_table(task, objects, renderer, pictures=False)
            ways = (slipped(listed(task, record), seed) for seed in range(50))
            after = next(it for it in ways if (the_refused(it) == 0) == first)
            for step in after.steps[:-1]:
                result = tools.call(step.call.name, step.call.values)
                assert (result.text, result.status) == (step.text, step.status)
