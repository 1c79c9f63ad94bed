"""Which perception an episode had, on disk."""

from __future__ import annotations

from typing import Literal

import pydantic

from probe.episodes.perceptions import ORACLE_USED, PerceptionUsed


class PerceptionDocument(pydantic.BaseModel, extra="forbid"):
    """Perception without labels; records of episodes with labels don't have it."""

    kind: Literal["segmenter", "enrolled"]
    objects: int = pydantic.Field(ge=0, le=500)
    enrolment: str = pydantic.Field(pattern="^([0-9a-f]{12})?$")

    @pydantic.model_validator(mode="after")
    def _of_one_kind(self) -> PerceptionDocument:
        if (self.kind == "enrolled") != bool(self.objects and self.enrolment):
            raise ValueError("an enrolment has objects and a digest, and nothing else has")
        return self

    @staticmethod
    def of(used: PerceptionUsed) -> PerceptionDocument | None:
        """The document of a perception; None for the usual one."""
        if used.kind == "oracle":
            return None
        return PerceptionDocument(kind=used.kind, objects=used.objects, enrolment=used.enrolment)

    def used(self) -> PerceptionUsed:
        """The perception it describes."""
        return PerceptionUsed(self.kind, self.objects, self.enrolment)


def used_of(document: PerceptionDocument | None) -> PerceptionUsed:
    """The perception of a record's document; the usual one where nothing is said."""
    return ORACLE_USED if document is None else document.used()
