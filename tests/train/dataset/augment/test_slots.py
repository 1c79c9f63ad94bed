import re

from probe.train.dataset.augment.slots import pattern_of


def test_what_fills_the_slots_is_found():
    found = re.fullmatch(pattern_of("Is the {thing} (red)?"), "Is the blue mug (red)?")
    assert found and found.groupdict() == {"thing": "blue mug"}
    assert not re.fullmatch(pattern_of("Is the {thing} (red)?"), "Is the blue mug red?")


def test_a_slot_that_comes_again_is_filled_the_same_way():
    pattern = pattern_of("The {thing} is the {thing}.")
    assert re.fullmatch(pattern, "The mug is the mug.")
    assert not re.fullmatch(pattern, "The mug is the jug.")


def test_a_slot_may_have_choices():
    pattern = pattern_of("I push {way}.", {"way": ("left", "right")})
    assert re.fullmatch(pattern, "I push left.") and not re.fullmatch(pattern, "I push it.")
