"""Planted leaks are found, by the right finder; tasks without any are left alone."""

from __future__ import annotations

from dataclasses import replace

import pytest

from imaginary_tasks import (
    LORE,
    ImaginaryTask,
    compare,
    count,
    examples,
    find,
    offer,
    size,
)
from probe.shortcuts.investigation import investigate
from probe.shortcuts.table import leaks

pytestmark = pytest.mark.slow


def found(tasks) -> set[str]:
    return {finding.hits.by for finding in leaks(investigate(tasks, LORE))}


def often(draw: ImaginaryTask) -> bool:
    return draw.rng.random() < 0.5


@pytest.mark.parametrize("make", [find, count, size, compare])
@pytest.mark.parametrize("seed", [1])
def test_nothing_is_found_where_nothing_is(make, seed):
    assert found(examples(make, 300, seed=seed)) == set()


def test_the_smallest_is_right_too_often():
    def leak(draw: ImaginaryTask) -> None:
        if often(draw) and draw.right < 4:
            named = draw.options[:4]
            least = min(named, key=lambda name: max(LORE.by_name[name].size))
            draw.right = named.index(least)

    by = found(examples(find, 300, leak))
    assert {"smallest", "logistic on catalogue", "boosting on catalogue"} <= by
    assert not any("on letter" in name or "on areas" in name for name in by)


def test_one_letter_is_right_too_often():
    def leak(draw: ImaginaryTask) -> None:
        if draw.rng.random() < 0.25:
            answer = "None of the above" if draw.right == 4 else draw.options[draw.right]
            rest = [text for text in draw.options[:4] if text != answer]
            if answer != "None of the above":
                draw.options[:4] = [rest[0], rest[1], answer, rest[2]]
                draw.right = 2

    by = found(examples(find, 300, leak))
    assert {"always C", "logistic on letter"} <= by
    assert not any("on catalogue" in name or "on options" in name for name in by)


def test_a_wording_tells_the_letter():
    def leak(draw: ImaginaryTask) -> None:
        if often(draw):
            draw.question = f"{('What', 'Which', 'Name what', 'Say', 'Tell')[draw.right]} is it"

    by = found(examples(find, 300, leak))
    assert {"logistic on wording", "logistic on question"} <= by
    assert not any("always" in name or "on areas" in name for name in by)


def test_a_wording_tells_that_it_is_none():
    def leak(draw: ImaginaryTask) -> None:
        if draw.right == 4:
            draw.question = f"{draw.question}, if any"

    assert "logistic on options" in found(examples(find, 300, leak))


def test_what_is_seen_is_all_there_is():
    def make(rng, lot):
        return count(rng, lot, hidden=0 if rng.random() < 0.5 else None)

    by = found(examples(make, 300))
    assert {"seen + 0", "logistic on graph", "observer"} <= by
    assert "seen + 2" not in by


@pytest.mark.parametrize("wanted", ["area_px", "overlapped"])
def test_what_shows_of_the_marked_things_tells(wanted):
    def leak(draw: ImaginaryTask) -> None:
        a, b = (getattr(draw.things[n], wanted) for n in (0, 1))
        lead = (a - b) * (-1 if draw.form == "smaller" else 1) * (1 if wanted == "area_px" else -1)
        if draw.rng.random() < 0.7:
            draw.right = 0 if lead > 0 else 1

    by = found(examples(size, 300, leak))
    assert {"larger area" if wanted == "area_px" else "less occluded", "logistic on areas"} <= by
    assert not any("on letter" in name or "on wording" in name for name in by)


@pytest.mark.parametrize(
    ("of", "number", "rule"),
    [
        ((2, 3), "top_m", "higher cover"),
        ((2, 3), "tilt", "flatter cover"),
        ((0, 1), "top_m", "higher thing"),
    ],
)
def test_what_depth_shows_of_covers_and_things_tells(of, number, rule):
    def leak(draw: ImaginaryTask) -> None:
        a, b = (getattr(draw.things[n], number) for n in of)
        lead = (a - b) * (-1 if draw.form == "smaller" else 1) * (-1 if number == "tilt" else 1)
        if draw.rng.random() < 0.7:
            draw.right = 0 if lead > 0 else 1

    by = found(examples(size, 300, leak))
    assert {rule, "logistic on depth"} <= by
    assert not any("on areas" in name or "on patches" in name for name in by)


def test_what_is_named_lies_as_high_as_the_right_option():
    def leak(draw: ImaginaryTask) -> None:
        named = next(n for n, thing in enumerate(draw.things) if thing.name)
        cover = draw.things[named]
        name = str(cover.name)
        draw.question = f"{draw.question} beneath the {name}"
        if draw.right < 4 and often(draw):
            room = LORE.by_name[draw.options[draw.right]].size[2]
            top = room + min(LORE.by_name[name].size)
            draw.things[named] = replace(cover, top_m=top)

    by = found(examples(find, 300, leak))
    assert {"fits by height", "boosting on depth"} <= by
    assert not any("on catalogue" in name or "on graph" in name for name in by)


def test_the_patch_tells_which_is_darker():
    def leak(draw: ImaginaryTask) -> None:
        a, b = (draw.things[n].lab[0] for n in (0, 1))
        if draw.form == "darker" and draw.rng.random() < 0.9:
            draw.right = 0 if a < b else 1

    by = found(examples(compare, 300, leak))
    assert {"patch colour", "observer", "logistic on patches"} <= by


def test_what_is_half_hidden_has_the_colour_of_the_right_option():
    red, blue = (41.0, 58.0, 38.0), (39.0, 6.0, -46.0)

    def leak(draw: ImaginaryTask) -> None:
        # One thing only is half hidden, and its colour is that of the right option alone.
        draw.things = [thing for thing in draw.things if thing.name]
        candidates = ["red mug", "blue brick", "blue egg", "blue die", "blue pawn"]
        offer(draw, candidates, 0)
        lab = red if often(draw) and draw.right < 4 else blue
        draw.things.append(replace(draw.things[0], name=None, category="", lab=lab))

    assert "logistic on patches" in found(examples(find, 300, leak))
