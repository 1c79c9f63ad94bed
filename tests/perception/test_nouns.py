from collections import Counter

import pytest

from probe.perception.nouns import (
    ALIKE,
    KIND,
    LOOKS,
    LOOSE,
    SAME,
    _nouns,
    kin,
    looks_meant,
    names_meant,
    outlines_meant,
)
from probe.perception.tokens import tokens


@pytest.mark.parametrize(
    ("said", "meant", "worth"),
    [
        ("pitcher", "jug", SAME),
        ("jug", "pitcher", SAME),
        ("bowl", "plate", ALIKE),
        ("fruit", "pear", KIND),
        ("food", "pear", KIND),
        ("food", "bread", KIND),
        ("hammer", "tool", LOOSE),
        ("ketchup", "bottle", ALIKE),
    ],
)
def test_one_word_stands_for_another(said, meant, worth):
    assert names_meant(said)[meant] == worth


def test_unlike_things_are_not_mixed_up():
    assert "banana" not in names_meant("hammer") and not names_meant("zeppelin")
    assert "jug" not in names_meant("jug")


def test_shapes_and_materials_fit_things():
    assert looks_meant("round")["plate"] == LOOKS and looks_meant("wooden")["wood"] == LOOKS
    assert not looks_meant("plate")
    assert outlines_meant("carton") == {"boxy": ALIKE}


def test_members_of_a_narrow_kind_know_each_other():
    (kind, others), *_ = [each for each in kin("nectarine") if each[0] == "fruit"]
    assert kind == "fruit" and "apple" in others and "nectarine" not in others
    assert not kin("hammer")


def test_the_words_of_the_file_are_those_that_are_compared():
    known = _nouns()
    covers = (known.contents, known.kinds, known.wide, known.shapes, known.materials)
    words = {word for cover in covers for each in cover.items() for word in (each[0], *each[1])}
    words |= {word for group in (*known.same, *known.alike) for word in group}
    assert [word for word in sorted(words) if tokens(word) != [word]] == []
    assert [two for two in known.apart.values() if tokens(two) != two.split()] == []


def test_no_group_holds_a_word_twice():
    known = _nouns()
    covers = (known.contents, known.kinds, known.wide, known.shapes, known.materials)
    groups = [*known.same, *known.alike, *(group for cover in covers for group in cover.values())]
    for group in groups:
        assert not [word for word, count in Counter(group).items() if count > 1], group
