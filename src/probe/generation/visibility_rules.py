"""Thresholds of visibility that all question types share. Numbers in, yes or no out."""

from __future__ import annotations

from probe.perception.naming import SEEN_PX, SEEN_SHARE
from probe.perception.oracle import NOTICED_PX
from probe.scene.visibility import Visibility

HIDDEN_SHARE = 0.05
CLEAR_SHARE = 0.50
PARTLY = (0.05, 0.25)
"""Find's easier third: visible shares."""

LITTLE = (0.03, 0.35)
"""Visible share of a marked thing."""

LITTLE_PX = 200
"""Pixels that at least show of a marked thing, so that people notice it as well."""

REVEALED_SHARE = 0.60
"""Visible share that the hidden object has once its cover is gone."""

LARGEST_GAIN = 0.20
"""Most that the visible share of any other object may grow by then."""


def is_hidden(seen: Visibility) -> bool:
    """Too little to notice."""
    return seen.fraction <= HIDDEN_SHARE and seen.visible_px < NOTICED_PX


def is_clear(seen: Visibility) -> bool:
    """Half of it or more shows."""
    return seen.fraction >= CLEAR_SHARE


def is_seen(seen: Visibility) -> bool:
    """Perception may name it."""
    return seen.fraction >= SEEN_SHARE and seen.visible_px >= SEEN_PX


def is_little(seen: Visibility) -> bool:
    """As much as may show of a marked thing."""
    return LITTLE[0] <= seen.fraction <= LITTLE[1] and seen.visible_px >= LITTLE_PX


def is_partly_visible(seen: Visibility) -> bool:
    """Noticeable, but not nameable."""
    return PARTLY[0] < seen.fraction <= PARTLY[1]
