"""Which perception an episode has, as one value. Knows no command line."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

from probe.assets.spec import ObjectSpec
from probe.perception.dials import Dials, NoisyDetector
from probe.perception.oracle import Oracle, words_of
from probe.perception.pointer import Finder, Pointer
from probe.perception.points import Convention
from probe.perception.posture import Poses
from probe.perception.scene_describer import ModelSceneDescriber
from probe.perception.scene_graph import SceneDescriber
from probe.perception.segmenter import Masker, Segmenter
from probe.perception.things import Detector
from probe.types import Ask


@dataclass(frozen=True)
class Perception:
    """What the tools see with.

    Attributes:
        detector: Finds things in a frame.
        finder: Finds what words describe; None to match them with the words of detected things.
        teller: Tells the scene graph; None to make it from detected things.
    """

    detector: Detector
    finder: Finder | None = None
    teller: SceneDescriber | None = None


Perceiver = Callable[[Mapping[int, ObjectSpec], Poses], Perception]
"""Makes an episode's perception from what the catalogue says of the objects, by instance, and
from where they are. Only an oracle may look at either."""


def ideal(words: Mapping[int, ObjectSpec], poses: Poses) -> Perception:
    """The oracle, without errors."""
    return Perception(Oracle(words, poses))


def dialled(dials: Dials, seed: int, run: int = 0, rumours: Sequence[ObjectSpec] = ()) -> Perceiver:
    """The oracle with errors.

    Args:
        dials: Their rates.
        seed: Of the episode.
        run: Number of the run.
        rumours: Objects that invented things may be called; those in the scene are left out.
    """

    def perceiver(words: Mapping[int, ObjectSpec], poses: Poses) -> Perception:
        present = {spec.name for spec in words.values()}
        absent = [words_of(spec) for spec in rumours if spec.name not in present]
        return Perception(NoisyDetector(Oracle(words, poses), dials, poses, seed, run, absent))

    return perceiver


def pointing(
    ask: Ask, masker: Masker | None = None, convention: Convention = "pixels"
) -> Perceiver:
    """A model that points and tells; nothing of the simulation's truth is used.

    Args:
        ask: The model.
        masker: Makes masks of points (Sam3); None for the segmenter of colours and depth.
        convention: How the model writes points down.
    """

    def perceiver(words: Mapping[int, ObjectSpec], poses: Poses) -> Perception:
        segmenter = Segmenter()
        finder = Pointer(ask, masker or segmenter, convention)
        return Perception(segmenter, finder, ModelSceneDescriber(ask, convention))

    return perceiver
