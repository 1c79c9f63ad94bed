"""A scene graph as a model tells it from the picture. Knows no model, no labels, no depth."""

from __future__ import annotations

import re
from typing import get_args

import pydantic
import yaml

from probe.asking import UnusableReply, asked
from probe.files import fault
from probe.perception.points import IN_WORDS, Convention, to_pixel
from probe.perception.scene_description import DescribedObject, GraphReply
from probe.perception.scene_graph import Contact, GraphEntry, Kind, Region, Relation, SceneGraph
from probe.perception.things import Words
from probe.types import Ask, Frame

_QUESTION = """The picture shows a table from above; it is {width} pixels wide and {height} high.
List every object on the table that shows, and nothing that doesn't, as YAML in this form:
objects:
- number: 1
  name: red mug
  description: A red mug with a white handle, lying on its side.
  point: [512, 300]
  box: [470, 250, 560, 350]
relations:
- 1 left_of 2
cluttered: [middle centre]
clear: [top left, top right]
name: two to four words; leave it out where too little shows to tell what it is.
point: a place well inside what shows of it, {point}.
box: two corners around what shows of it, in the same units and order as two points.
relations: only between neighbours, each one of {kinds}; the first four as seen in the picture, \
"on" for what rests on something, "covering" for what hides a part of it.
cluttered, clear: parts of the picture that are at least half covered, or empty, each one of \
{regions}.
Reply with the YAML and nothing else. If the table is empty, objects is []."""

_FENCED = re.compile(r"```(?:ya?ml|json)?\s*\n(.*?)```", re.DOTALL)


class ModelSceneDescriber:
    """A Teller: a model writes the graph, its schema is checked, one reply may be mended."""

    def __init__(self, ask: Ask, convention: Convention = "pixels") -> None:
        """Set up.

        Args:
            ask: The model.
            convention: How it writes points down.
        """
        self._ask = ask
        self._convention: Convention = convention

    def tell(self, frame: Frame) -> SceneGraph:
        """The scene as the model sees it.

        Raises:
            UnusableReply: Neither of two replies fits; the reason names the first broken field.
            ModelFailed: No reply came.
        """
        assert frame.rgb is not None
        height, width = frame.depth.shape
        question = _QUESTION.format(
            width=width,
            height=height,
            point=IN_WORDS[self._convention],
            kinds=", ".join(get_args(Kind)),
            regions=", ".join(get_args(Region)),
        )
        return asked(
            self._ask,
            [frame.rgb],
            question,
            lambda reply: read_graph(reply, self._convention, width, height),
        )


def read_graph(reply: str, convention: Convention, width_px: int, height_px: int) -> SceneGraph:
    """The graph in a reply; what stands around a fenced block doesn't matter.

    Raises:
        UnusableReply: It isn't YAML, breaks the schema, or points outside the picture.
    """
    fenced = _FENCED.findall(reply)
    try:
        told = GraphReply.model_validate(yaml.safe_load(fenced[-1] if fenced else reply))
    except yaml.YAMLError as error:
        raise UnusableReply(f"it isn't YAML ({' '.join(str(error).split())[:200]})") from error
    except pydantic.ValidationError as error:
        raise UnusableReply(fault(error, "the YAML")) from error
    except (ValueError, RecursionError) as error:  # a date that doesn't exist, brackets in brackets
        raise UnusableReply("it isn't YAML that can be read") from error
    entries = [_entry(item, convention, width_px, height_px) for item in told.objects]
    order = sorted(range(len(entries)), key=lambda index: entries[index].point_px[::-1])
    place = {told.objects[index].number: new for new, index in enumerate(order)}
    relations = [Relation(place[a], kind, place[b]) for a, kind, b in told.relations]
    relations.sort(key=lambda found: (found.kind in get_args(Contact), found))
    return SceneGraph(
        tuple(entries[index] for index in order),
        tuple(relations),
        tuple(told.cluttered),
        tuple(told.clear),
    )


def _entry(
    item: DescribedObject, convention: Convention, width_px: int, height_px: int
) -> GraphEntry:
    def pixel(first: float, second: float) -> tuple[int, int]:
        x, y = (second, first) if convention == "yx1000" else (first, second)
        try:
            return to_pixel(x, y, convention, width_px, height_px)
        except UnusableReply as failure:
            raise UnusableReply(f"object {item.number}: {failure}") from failure

    point = pixel(*item.point)
    corners = pixel(*item.box[:2]), pixel(*item.box[2:])
    (left, right), (top, bottom) = (sorted(ends) for ends in zip(*corners, strict=True))
    words = Words(item.name, "", (), item.description)
    return GraphEntry(words, point, (left, top, right, bottom))
