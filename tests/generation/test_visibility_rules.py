from __future__ import annotations

import pytest

from probe.generation.visibility_rules import is_clear, is_hidden, is_partly_visible, is_seen
from probe.scene.visibility import Visibility


@pytest.mark.parametrize(
    ("visible", "alone", "hidden", "partly", "seen", "clear"),
    [
        (0, 3000, True, False, False, False),
        (100, 2000, True, False, False, False),  # exactly 5 %
        (101, 2000, False, True, False, False),
        (124, 5000, True, False, False, False),
        (125, 5000, False, False, False, False),  # little, but noticeable
        (750, 3000, False, True, False, False),  # exactly 25 %
        (751, 3000, False, False, False, False),
        (900, 3000, False, False, True, False),  # exactly 30 %
        (399, 1000, False, False, False, False),  # too small to name
        (400, 1000, False, False, True, False),
        (1500, 3000, False, False, True, True),  # exactly half
    ],
)
def test_thresholds(visible, alone, hidden, partly, seen, clear):
    measured = Visibility(visible, alone)
    verdict = is_hidden(measured), is_partly_visible(measured), is_seen(measured)
    assert verdict == (hidden, partly, seen)
    assert is_clear(measured) is clear
