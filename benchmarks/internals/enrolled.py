"""Names by looks, without labels: `python benchmarks/internals/enrolled.py`.

Measures internals, not the public API.

25 procedural objects of different categories are enrolled before the simulated camera. In piles of
12 to 15 of them, each object of which 30 % and 400 px show is looked up: is the segment that
covers most of it called by its name (right), by another one (wrong), or only described? Labels
serve for counting alone.
"""

from __future__ import annotations

from collections import Counter
from dataclasses import replace
from typing import get_args

import numpy as np
import tyro

from probe.api.resources import cache_folder, library
from probe.assets.library import Library
from probe.assets.tables import table_ids
from probe.errors import Unsatisfiable
from probe.perception.enrolled.detector import EnrolledDetector
from probe.perception.enrolled.enrolment import EnrolledWords
from probe.perception.enrolled.enrolment_file import enrolment_of
from probe.perception.enrolled.simulated import enrol_simulated
from probe.perception.naming import SEEN_PX, SEEN_SHARE
from probe.perception.segmenter import Segmenter
from probe.render.photograph import load_scene, measure, photograph
from probe.render.renderer import Renderer
from probe.scene.cameras import View
from probe.scene.scene import Scene
from probe.scene.setup import UR5_TABLE
from probe.world.scenes import make_scene

OBJECTS = 25
ENROLLING_PX = 512


def catalogue(seed: int) -> Library:
    """Objects drawn at random, no two of one name or category."""
    things = library("procedural")
    chosen = dict[str, str]()
    for number in np.random.default_rng([77, seed]).permutation(len(things.specs)):
        spec = things.specs[number]
        if spec.name not in {things[i].name for i in chosen.values()}:
            chosen.setdefault(spec.category, spec.id)
    ids = list(chosen.values())[:OBJECTS]
    return Library(tuple(things[i] for i in ids), None, things.cache)


def detector_of(renderer: Renderer, things: Library, view: View) -> EnrolledDetector:
    """What knows the catalogue by its looks from one camera."""
    camera = replace(UR5_TABLE.camera(view), width_px=ENROLLING_PX, height_px=ENROLLING_PX)
    ids = [spec.id for spec in things.specs]
    shown = enrol_simulated(renderer, things, ids, camera, table_ids(None)[0])
    words = {EnrolledWords(things[i].name): views for i, views in shown.items()}
    return EnrolledDetector(enrolment_of(words), Segmenter())


def tally(
    renderer: Renderer, scene: Scene, things: Library, view: View, detector: EnrolledDetector
) -> Counter[str]:
    """How the objects that show in a loaded scene are called."""
    camera = scene.setup.camera(view)
    frame, shown = photograph(renderer, scene, camera=camera), measure(renderer, scene, camera)
    labels = frame.labels
    assert labels is not None
    found = detector.detect(replace(frame, labels=None, shares=None))
    told = Counter[str]()
    for item in scene.objects:
        seen = shown.get(item.instance)
        if seen is None or seen.fraction < SEEN_SHARE or seen.visible_px < SEEN_PX:
            continue
        mask = labels == item.instance
        best = max(found, key=lambda thing: int(np.count_nonzero(thing.mask & mask)))
        name = best.words.name
        right = name == things[item.object_id].name
        told["described" if name is None else "right" if right else "wrong"] += 1
    return told


def main(scenes: int = 15, first_seed: int = 500_004, objects: int = 0) -> None:
    """Print by camera how many objects are named right, wrong or only described.

    Args:
        scenes: How many piles.
        first_seed: Of the first of them.
        objects: Seed of the catalogue.
    """
    things = catalogue(objects)
    with Renderer(cache_folder() / "light") as renderer:
        detectors = {view: detector_of(renderer, things, view) for view in get_args(View)}
        sums = {view: Counter[str]() for view in detectors}
        for seed in range(first_seed, first_seed + scenes):
            try:
                scene = make_scene(seed, things, table_ids(None), 12 + seed % 4)
            except Unsatisfiable as failure:
                print(failure, flush=True)
                continue
            load_scene(renderer, scene, things, things.table(scene.table))
            for view, detector in detectors.items():
                sums[view] += tally(renderer, scene, things, view, detector)
            print(seed, {view: dict(told) for view, told in sums.items()}, flush=True)


if __name__ == "__main__":
    tyro.cli(main)
