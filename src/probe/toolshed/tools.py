"""The tools' texts and arguments: product text, read by every agent. Knows no station."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import Annotated, Any, Literal

import pydantic
from pydantic.json_schema import GenerateJsonSchema, JsonSchemaValue
from pydantic_core import PydanticCustomError

from probe.types import USUAL_SCALE, PictureScale

ObjectId = Annotated[
    str,
    pydantic.Field(
        max_length=40,
        description='Id of the object from perceive_scene or find_object, such as "object_1".',
    ),
]


def _in_picture(number: float, info: pydantic.ValidationInfo) -> float:
    """A coordinate below the edge of the pictures that the call is about."""
    context: dict[str, int] = info.context or {}
    side = context.get("side_px", USUAL_SCALE.side_px)
    if number >= side:
        raise PydanticCustomError("less_than", "Input should be less than {lt}", {"lt": side})
    return number


Coordinate = Annotated[
    float,
    pydantic.Field(ge=0),
    pydantic.AfterValidator(_in_picture),
    pydantic.WithJsonSchema(
        {"exclusiveMaximum": USUAL_SCALE.side_px, "minimum": 0, "type": "number"}
    ),
]

_Letter = Literal["A", "B", "C", "D", "E"]


def _as_letter(said: object) -> object:
    """A letter as a person might write it ("b ")."""
    return said.strip().upper() if isinstance(said, str) and len(said) < 9 else said


class _Arguments(pydantic.BaseModel, extra="forbid", allow_inf_nan=False):
    pass


class PerceiveScene(_Arguments):
    """List what the camera sees right now, and get the current picture.

    The list is YAML: every object that shows, with its object_id, its name where enough of it shows
    to tell, a description, a point on it and its box; relations between neighbours (left_of,
    right_of, above, below as seen in the picture; on, covering, touching); which parts of the
    picture are cluttered and which are clear. Points are (u, v) in pixels from the picture's top
    left corner. An object keeps its object_id until it moves or something covers it. The list tells
    only what shows. Something that lies behind or under other objects is in no list until they have
    been moved away.
    """


class FindObject(_Arguments):
    """Locate one object in the current picture and get its object_id.

    Say what it looks like ("red mug") or where it is ("the thing at (512, 300)"). The reply gives
    its object_id, a point on it, its box, and the picture with the object outlined. Where the words
    fit in part or not at all, it lists what may be meant, each with an object_id. Moving an object
    takes an object_id. It stays good until the object moves or something covers it; then look again
    for a new one.
    """

    description: Annotated[
        str,
        pydantic.Field(
            min_length=1,
            max_length=300,
            description="Name, colour or other looks of one object, or a place in the picture "
            'as "(u, v)" in pixels. "left", "top", "largest" and the like choose among several.',
        ),
    ]


class GraspAndRemove(_Arguments):
    """Pick an object up with the gripper and drop it into the basket outside the picture.

    Use it to uncover what lies beneath or behind. It can fail: no grasp may fit, other objects
    may be in the way, the object may slip. Where its neighbours leave the fingers no room, the
    gripper may first push it a few centimetres. The reply says what happened and comes with
    the new picture. Neighbours may get moved. Each attempt counts as one manipulation, whether
    it works or not. What is in the basket stays there.
    """

    object_id: ObjectId


class Push(_Arguments):
    """Push an object across the table in a straight line with the closed gripper.

    Use it when a grasp fails, or to slide something aside and keep it on the table. The gripper
    comes down in the nearest free spot behind the object, or on top of it where there is none;
    what stands ahead of it gets pushed along. The reply says what happened and comes with the
    new picture. Each attempt counts as one manipulation, whether it works or not.
    """

    object_id: ObjectId
    direction: Annotated[
        Literal["up", "down", "left", "right"],
        pydantic.Field(description="Which way, as seen in the picture."),
    ]
    distance_cm: Annotated[
        float,
        pydantic.Field(
            ge=3,
            le=20,
            description="How far: 3 to 20 centimetres.",
        ),
    ]


class AnswerQuestion(_Arguments):
    """Give the final answer. This ends the episode and can't be taken back.

    If the question asks you to point at something, give a point as well: a place on that object in
    the last picture you were shown. Otherwise give none. "None of the above" needs no point.
    """

    choice: Annotated[
        _Letter,
        pydantic.BeforeValidator(_as_letter, json_schema_input_type=_Letter),
        pydantic.Field(description="Letter of the option that you choose."),
    ]
    point: Annotated[
        tuple[Coordinate, Coordinate] | None,
        pydantic.Field(description="[u, v] in pixels from the top left, if one is asked for."),
    ] = None


Request = PerceiveScene | FindObject | GraspAndRemove | Push | AnswerQuestion

TOOLS: dict[str, type[Request]] = {
    "perceive_scene": PerceiveScene,
    "find_object": FindObject,
    "grasp_and_remove": GraspAndRemove,
    "push": Push,
    "answer_question": AnswerQuestion,
}


@dataclass(frozen=True)
class ToolSchema:
    """A tool as a model is told of it.

    Attributes:
        name: What to call.
        description: What it does.
        parameters: JSON schema of its arguments.
    """

    name: str
    description: str
    parameters: dict[str, Any]


_AS_WRITTEN: Mapping[str, str] = MappingProxyType({})


def tool_schemas(
    scale: PictureScale = USUAL_SCALE, words: Mapping[str, str] = _AS_WRITTEN
) -> tuple[ToolSchema, ...]:
    """All five tools, in a fixed order, as they are told where pictures have this scale.

    Args:
        scale: Of the pictures.
        words: What is said of a tool ("push") or of an argument ("push.direction") instead.
    """
    return tuple(_schema(name, model, scale, words) for name, model in TOOLS.items())


class _Untitled(GenerateJsonSchema):
    """Leaves out the titles: they would only repeat the names in capitals."""

    def field_title_should_be_set(self, schema: object) -> bool:
        return False


def _schema(
    name: str, model: type[Request], scale: PictureScale, words: Mapping[str, str]
) -> ToolSchema:
    parameters: JsonSchemaValue = model.model_json_schema(schema_generator=_Untitled)
    usual = str(parameters.pop("description"))
    description = words.get(name, usual)
    parameters.pop("title")
    for field, told in parameters.setdefault("properties", {}).items():
        told["description"] = words.get(f"{name}.{field}", told["description"])
    if name == "grasp_and_remove" and scale.opening != USUAL_SCALE.opening:
        description += f" The gripper opens {100 * scale.opening:.1f} cm wide."
    return ToolSchema(name, description, _scaled(parameters, scale))


def _scaled(parameters: JsonSchemaValue, scale: PictureScale) -> JsonSchemaValue:
    """A tool's parameters with what depends on the set-up."""
    fields = parameters["properties"]
    if "distance_cm" in fields:
        width = f"{100 * scale.width:.0f} cm"
        fields["distance_cm"]["description"] += (
            f" Across its middle the picture shows {width}."
            if scale.oblique
            else f" The picture is {width} wide."
        )
    if "direction" in fields and scale.oblique:
        fields["direction"]["description"] += ' "up" is away from the camera.'
    if "point" in fields:
        for place in fields["point"]["anyOf"][0]["prefixItems"]:
            place["exclusiveMaximum"] = scale.side_px
    return parameters
