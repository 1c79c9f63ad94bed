"""What a twin of Compare is planned to be; test_generate.py makes whole tasks."""

from __future__ import annotations

import pytest

from probe.certify.compare import opposite
from probe.certify.plan import plan


@pytest.mark.parametrize("seed", [0, 1000, 2000, 3000])
def test_the_opposite_shows_the_same_and_is_answered_by_the_other_one(seed):
    one = plan("compare", seed)
    other = opposite(one)
    assert {one.letter, other.letter} == {"A", "B"}
    assert other.cues[:2] == (not one.cues[0], not one.cues[1])
    # A shows more pixels in both or in neither.
    assert ((one.letter == "A") == one.cues[1]) == ((other.letter == "A") == other.cues[1])
    assert (one.wording, one.form) == (other.wording, other.form)
    assert opposite(other) == one
