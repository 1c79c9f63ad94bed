"""A model's part in an episode on disk, as a part of its record."""

from __future__ import annotations

from dataclasses import asdict
from typing import Annotated

import pydantic

from probe.episodes.participation import ModelReply, Participation, Points


class _Document(pydantic.BaseModel, extra="forbid", allow_inf_nan=False):
    pass


class ReplyDocument(_Document):
    """How many calls a reply made, and its words if it made none."""

    calls: int = pydantic.Field(ge=0)
    words: str = ""


class ParticipationDocument(_Document, validate_by_name=True, serialize_by_alias=True):
    """How a model took part."""

    setting: Annotated[str, pydantic.Field(alias="arm")]
    points: Points
    replies: tuple[ReplyDocument, ...]
    tokens_in: int | None
    tokens_out: int | None
    cost: float | None
    faults: tuple[str, ...]

    @staticmethod
    def of(participation: Participation) -> ParticipationDocument:
        """The document of a model's part."""
        return ParticipationDocument.model_validate(asdict(participation))

    def participation(self) -> Participation:
        """The part it describes."""
        replies = tuple(ModelReply(reply.calls, reply.words) for reply in self.replies)
        return Participation(
            self.setting,
            self.points,
            replies,
            self.tokens_in,
            self.tokens_out,
            self.cost,
            self.faults,
        )
