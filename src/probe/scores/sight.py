"""Whether results of models that see stand beside results of models that don't, in words."""

from __future__ import annotations

from collections.abc import Iterable

_WITHOUT_SIGHT = "text-only"


def sight_words(settings: Iterable[str]) -> str:
    """What to say where "text-only" stands beside other settings; empty if it doesn't.

    Args:
        settings: Of all results, as rows name them.
    """
    without = [setting.split(",")[0] == _WITHOUT_SIGHT for setting in settings]
    if all(without) or not any(without):
        return ""
    return (
        "Some of these results are of the setting text-only, in which a model acts with the tools "
        "and sees no picture. A difference from another setting may come from the setting"
    )
