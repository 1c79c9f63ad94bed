from __future__ import annotations

from collections import Counter

from probe.assets.library import open_library
from probe.perception.general import UNKNOWN, kind_of, kinds, kinds_in, kinds_told


def test_every_built_in_category_has_a_kind_that_says_less(cache):
    library = open_library("procedural-2", None, cache)
    categories = {spec.category for spec in library.specs}
    assert categories <= kinds().keys()
    assert all(kind_of(it) != it for it in categories)


def test_a_kind_is_of_several_categories():
    assert min(Counter(kinds().values()).values()) >= 6
    assert len(set(kinds().values())) <= 50


def test_a_name_may_be_of_the_kinds_of_all_categories_that_end_as_it_does():
    assert kinds_in("Small light green lime") == {"fruit"}
    assert {"box", "container"} <= kinds_in("white open box")
    assert kinds_in("A at (1, 2)") == kinds_in("3") == kinds_in("") == frozenset()


def test_what_is_of_no_known_category_is_an_object():
    assert kind_of("ghost") == UNKNOWN and UNKNOWN in kinds_told()
    assert kind_of("lime") == "fruit" and "fruit" in kinds_told()
