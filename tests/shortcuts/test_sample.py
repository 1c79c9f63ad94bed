"""What classifiers are given says nothing of what is hidden or right."""

from dataclasses import replace

import pytest

from imaginary_tasks import LORE, compare, count, examples, find, size
from probe.generation.first_look import FirstLook
from probe.scene.visibility import Visibility
from probe.shortcuts.families import FAMILIES, features
from probe.shortcuts.rules import rules_for
from probe.shortcuts.sample import example_of
from probe.tasks.task import Certificate
from task_examples import FIND, with_answer

LOOK = FirstLook((), (), {})


def test_a_sample_depends_on_no_answer_certificate_or_scene():
    proof = Certificate({1: Visibility(9, 9)}, {"visible_share": 0.9}, ("proc_lemon",))
    bare = replace(FIND.scene, objects=FIND.scene.objects[1:])
    other = replace(with_answer("D"), certificate=proof, scene=bare, id="find-9", seed=9)
    assert example_of(other, LOOK).sample == example_of(FIND, LOOK).sample
    assert example_of(FIND, LOOK).right == 1 and example_of(other, LOOK).right == 3


def test_parts_are_for_the_report():
    proof = replace(FIND.certificate, measures={"partly": 1.0})
    assert example_of(replace(FIND, certificate=proof), LOOK).part == "partly"
    assert example_of(FIND, LOOK).part == ""


def test_all_but_two_families_are_blind_to_places():
    for make in (find, count):
        (example,) = examples(make, 1)
        sample = example.sample
        turned = replace(sample, options=(*sample.options[3::-1], sample.options[4]))
        for family in set(FAMILIES) - {"letter", "wording", "question", "all"}:
            straight, told = features(family, sample, LORE), features(family, turned, LORE)
            for one, other in zip(straight, (*told[3::-1], told[4]), strict=True):
                assert dict(one) == pytest.approx(dict(other), abs=1e-9), family


def test_every_rule_chooses_among_the_options():
    for make in (find, count, size, compare):
        for example in examples(make, 5):
            for name, rule in rules_for(example.sample).items():
                places = rule(example.sample, LORE)
                assert set(places) <= set(range(len(example.sample.options))) and places, name


def test_rules_of_size_turn_with_the_question():
    (example,) = examples(size, 1)
    said = {
        form: rules_for(example.sample)["larger area"](replace(example.sample, form=form), LORE)
        for form in ("larger", "smaller")
    }
    a, b = (example.sample.look.things[place].area_px for place in (0, 1))
    assert said["larger"] == ((0,) if a > b else (1,))
    assert said["smaller"] == ((1,) if a > b else (0,))
