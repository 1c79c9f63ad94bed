from collections import Counter

import pytest

from probe.perception.nouns import (
    ALIKE,
    KIND,
    LOOKS,
    SAME,
    looks_meant,
    names_meant,
    outlines_meant,
)


@pytest.mark.parametrize(
    ("said", "meant", "worth"),
    [
        ("pitcher", "jug", SAME),
        ("jug", "pitcher", SAME),
        ("bowl", "plate", ALIKE),
        ("fruit", "pear", KIND),
        ("food", "pear", KIND),
        ("food", "bread", KIND),
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


def test_no_group_holds_a_word_twice():
    from probe.perception.nouns import _nouns

    known = _nouns()
    for group in (*known.same, *known.alike, *known.kinds.values(), *known.shapes.values()):
        assert not [word for word, count in Counter(group).items() if count > 1], group
