"""Names that somebody may have meant."""

from __future__ import annotations

import pytest

from probe.closest import closest, did_you_mean
from probe.errors import UnknownName

MUGS = ["proc_red_mug", "proc_blue_mug", "proc_red_block", "proc_big_red_block"]


@pytest.mark.parametrize(
    ("name", "known", "first"),
    [
        ("rnu", ["demo", "run", "report"], "run"),
        ("vv1", ["behind", "demo", "v1", "v1.1"], "v1"),
        ("red_block", MUGS, "proc_red_block"),
        ("Red Block", MUGS, "proc_red_block"),
        ("SCENE", ["scene", "serve"], "scene"),
    ],
)
def test_the_nearest_name_comes_first(name, known, first):
    assert closest(name, known)[0] == first


def test_a_name_that_resembles_none_gets_no_suggestion():
    assert did_you_mean("zebra", MUGS) == "" and did_you_mean("", MUGS) == ""


def test_at_most_three_are_named():
    assert did_you_mean("mug", [f"mug_{n}" for n in range(9)]) == (
        "Did you mean mug_0 or mug_1 or mug_2?"
    )


def test_a_short_list_is_told_whole_and_a_long_one_only_where_nothing_is_near():
    assert str(UnknownName("suite", "v2", ["v1", "demo"])) == (
        "There is no suite called 'v2'. Known: v1, demo."
    )
    assert "'demoo'. Did you mean demo? Known: v1, demo." in str(
        UnknownName("suite", "demoo", ["v1", "demo"])
    )
    many = [f"mug_{n}" for n in range(40)]
    near = str(UnknownName("object", "muug_7", many, "See the list."))
    assert "Did you mean mug_7" in near and "Known" not in near
    assert near.endswith("There are 40. See the list.")
    assert "Known: mug_0, mug_1" in str(UnknownName("object", "zebra", many))
