"""A model that says what a test wants, and keeps what it was asked."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field

from probe.types import Array


@dataclass
class Replies:
    """An Ask: its replies one after the other, the last one for ever."""

    words: Sequence[str]
    asked: list[tuple[Sequence[Array], str]] = field(
        default_factory=list[tuple[Sequence[Array], str]]
    )

    def __call__(self, images: Sequence[Array], text: str) -> str:
        self.asked.append((images, text))
        return self.words[min(len(self.asked), len(self.words)) - 1]
