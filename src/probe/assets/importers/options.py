"""How objects are to be added: what a user says beyond the files."""

from __future__ import annotations

from dataclasses import dataclass

from probe.assets.importers import IMPORTERS
from probe.assets.importers.source import Axis, Format, SourceFrame


@dataclass(frozen=True)
class ImportOptions:
    """How objects are to be added.

    Attributes:
        format: Which importer.
        unit: Metres per unit; None for the format's own.
        up: The axis that points up in the files; None for the format's own.
        licence: SPDX identifier for objects whose source states none.
        source: Who made them, for objects whose source doesn't say.
    """

    format: Format
    unit: float | None = None
    up: Axis | None = None
    licence: str | None = None
    source: str | None = None

    @property
    def key(self) -> str:
        """The options in the words that libraries on disk were hashed with; never change them."""
        return (
            f"Order(format={self.format!r}, unit={self.unit!r}, up={self.up!r}, "
            f"licence={self.licence!r}, source={self.source!r})"
        )

    @property
    def frame(self) -> SourceFrame:
        own = IMPORTERS[self.format].frame
        return SourceFrame(self.unit or own.unit, self.up or own.up)
