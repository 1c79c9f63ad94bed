"""The schema of a scene graph that a model writes."""

from __future__ import annotations

from typing import Annotated, get_args

from pydantic import BaseModel, BeforeValidator, ConfigDict, Field, model_validator

from probe.perception.scene_graph import Kind, Region

MOST = 100
"""Objects in a graph."""


def _plain(value: object) -> object:
    return " ".join(value.split()) if isinstance(value, str) else value


def _parted(value: object) -> object:
    """A relation as its three parts, whether it is written in one line or as a list."""
    return value.split() if isinstance(value, str) else value


def _listed(value: object) -> object:
    return [] if value is None else value


Line = Annotated[str, BeforeValidator(_plain)]
Number = Annotated[float, Field(allow_inf_nan=False)]
ToldRelation = Annotated[tuple[int, Kind, int], BeforeValidator(_parted)]
Regions = Annotated[list[Region], BeforeValidator(_listed), Field(max_length=len(get_args(Region)))]


class DescribedObject(BaseModel):
    """One object as a model writes it; point and box in the model's own units."""

    model_config = ConfigDict(frozen=True, extra="ignore")

    number: int
    name: Annotated[Line, Field(min_length=1, max_length=60)] | None = None
    description: Annotated[Line, Field(min_length=1, max_length=300)]
    point: tuple[Number, Number]
    box: tuple[Number, Number, Number, Number]


class GraphReply(BaseModel):
    """A whole graph as a model writes it."""

    model_config = ConfigDict(frozen=True, extra="ignore")

    objects: Annotated[list[DescribedObject], Field(max_length=MOST)]
    relations: Annotated[
        list[ToldRelation], BeforeValidator(_listed), Field(max_length=20 * MOST)
    ] = []
    cluttered: Regions = []
    clear: Regions = []

    @model_validator(mode="after")
    def _numbers_fit(self) -> GraphReply:
        numbers = [item.number for item in self.objects]
        if len(set(numbers)) < len(numbers):
            raise ValueError("two objects have the same number")
        for first, kind, second in self.relations:
            if first == second or {first, second} - set(numbers):
                raise ValueError(f"relation '{first} {kind} {second}' is between no two objects")
        return self
