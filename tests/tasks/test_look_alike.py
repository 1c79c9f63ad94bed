"""Names that can be taken for others."""

from __future__ import annotations

import pytest

from probe.tasks.look_alike import look_alike

KNOWN = ("demo", "v1", "v1-scans", "v1-unfiltered")


@pytest.mark.parametrize(
    ("name", "known"),
    [
        ("Demo", "demo"),
        ("demo ", "demo"),
        (" demo", "demo"),
        ("d e m o", "demo"),
        ("dem0", "demo"),
        ("dem\u043e", "demo"),  # Cyrillic o
        ("\u0501\u0435\u043c\u043e", "demo"),  # nothing but Cyrillic
        ("de\u200bmo", "demo"),  # a space of no width
        ("\uff44\uff45\uff4d\uff4f", "demo"),  # wide letters
        ("d\u00e9mo", "demo"),
        ("\ua4d3emo", "demo"),  # Lisu; known to no table of ours
        ("V1", "v1"),
        ("vl", "v1"),
        ("v\u04c0", "v1"),
        ("v1_scans", "v1-scans"),
        ("v1\u2010scans", "v1-scans"),
        ("v1scans", "v1-scans"),
    ],
)
def test_names_that_look_alike_are_found(name, known):
    assert look_alike(name, KNOWN) == known


@pytest.mark.parametrize(
    "name",
    [*KNOWN, "mine", "demo2", "demo-human", "v2", "v1-human", "v10", "v", "", "\u6f14\u793a",
     "\u6d4b\u8bd5\u4e00\u4e8c", "dome", "v1-scan"],
)  # fmt: skip
def test_others_are_left_alone(name):
    assert look_alike(name, KNOWN) is None
