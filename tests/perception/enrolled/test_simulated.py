"""A small catalogue shown to a simulated camera, then a pile of it: names without labels."""

from dataclasses import replace

import numpy as np
import pytest

from probe.assets.library import open_library
from probe.perception.enrolled.detector import EnrolledDetector
from probe.perception.enrolled.enrolment import EnrolledWords
from probe.perception.enrolled.enrolment_file import enrolment_of
from probe.perception.enrolled.simulated import PLACES, TURNS, enrol_simulated, standing
from probe.perception.segmenter import Segmenter
from probe.render.renderer import Renderer
from probe.scene.scene import PlacedObject
from probe.scene.setup import UR5_TABLE

SMALL = replace(UR5_TABLE, picture_px=512)


@pytest.mark.slow
def test_what_was_shown_is_named_in_another_place(cache):
    things = open_library("procedural", None, cache)
    chosen = {spec.category: spec.id for spec in things.specs}
    ids = list(chosen.values())[:3]
    names = {object_id: things[object_id].name for object_id in ids}
    camera = SMALL.camera()
    with Renderer(cache / "light") as renderer:
        shown = enrol_simulated(renderer, things, ids, camera, "oak_planks")
        assert all(len(views) == len(TURNS) for views in shown.values())
        placed = [
            PlacedObject(n, i, standing(things.body(i).mesh.vertices, "", -x))
            for n, (i, x) in enumerate(zip(ids, PLACES, strict=True), start=1)
        ]
        frame = renderer.draw(placed, camera, rgb=True)
    labels = frame.labels
    assert labels is not None
    known = enrolment_of({EnrolledWords(names[i]): shown[i] for i in ids})
    found = EnrolledDetector(known, Segmenter()).detect(replace(frame, labels=None, shares=None))
    called = {
        thing.words.name: int(np.bincount(labels[thing.mask]).argmax())
        for thing in found
        if thing.nameable
    }
    assert called == {names[item.object_id]: item.instance for item in placed}
