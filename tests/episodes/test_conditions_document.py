"""Conditions on disk: files of before there were other lights and renderers keep their bytes."""

import pytest

from probe.episodes.conditions import AS_FROZEN, Conditions
from probe.episodes.conditions_document import ConditionsDocument
from probe.scene.lighting import Lighting
from probe.scene.viewpoint import Viewpoint

EVEN, DAY = Viewpoint(), Viewpoint(lighting=Lighting("day_room_3"))


def test_an_even_light_of_its_own_is_called_ambient_as_ever():
    written = ConditionsDocument.of(AS_FROZEN, EVEN).model_dump()
    assert written["lighting"] == "ambient"
    assert "renderer" not in written


def test_another_light_of_its_own_is_not_called_ambient():
    assert ConditionsDocument.of(AS_FROZEN, DAY).lighting == "own"


@pytest.mark.parametrize("viewpoint", [EVEN, DAY])
@pytest.mark.parametrize(
    "conditions",
    [AS_FROZEN, Conditions(lighting="hdri", camera="moved"), Conditions(renderer="blender")],
)
def test_conditions_come_back_as_they_were(conditions, viewpoint):
    text = ConditionsDocument.of(conditions, viewpoint).model_dump_json()
    assert ConditionsDocument.model_validate_json(text).conditions() == conditions
