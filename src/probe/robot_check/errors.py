"""What ends a check before it has found anything."""

from __future__ import annotations

from probe.errors import ProbeError


class Impossible(ProbeError):
    """A check can't go on.

    Attributes:
        fault: What is wrong, in a few words.
        remedy: How to mend it.
    """

    def __init__(self, fault: str, text: str, remedy: str) -> None:
        super().__init__(f"{text} {remedy}")
        self.fault = fault
        self.text = text
        self.remedy = remedy
