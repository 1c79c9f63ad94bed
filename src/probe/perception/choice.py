"""Which perception an episode has, as one value. Knows no command line."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from probe.assets.spec import ObjectSpec
from probe.perception.dials import Dials, NoisyDetector
from probe.perception.enrolled.detector import EnrolledDetector
from probe.perception.enrolled.enrolment import Enrolment
from probe.perception.enrolled.enrolment_file import read_enrolment
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
        guessed: Whether the same thing may be outlined otherwise next time: in two pieces, or in
            one with its neighbour.
    """

    detector: Detector
    finder: Finder | None = None
    teller: SceneDescriber | None = None
    guessed: bool = False


Perceiver = Callable[[Mapping[int, ObjectSpec], Poses], Perception]
"""Makes an episode's perception from what the catalogue says of the objects, by instance, and
from where they are. Only an oracle may look at either."""


def ideal(words: Mapping[int, ObjectSpec], poses: Poses) -> Perception:
    """The oracle, without errors."""
    return Perception(Oracle(words, poses))


def segmented(words: Mapping[int, ObjectSpec], poses: Poses) -> Perception:
    """Things told apart by colours and depth, without names; no truth is used."""
    return Perception(Segmenter(), guessed=True)


@dataclass(frozen=True, eq=False)
class Enrolled:
    """A Perceiver that knows an operator's objects by their looks; no truth is used.

    Attributes:
        enrolment: The objects; see read_enrolment().
    """

    enrolment: Enrolment

    def __call__(self, words: Mapping[int, ObjectSpec], poses: Poses) -> Perception:
        """An episode's perception."""
        return Perception(EnrolledDetector(self.enrolment, Segmenter()), guessed=True)


def enrolled(path: Path) -> Perceiver:
    """Names from an operator's objects, by their looks; no truth is used.

    Args:
        path: The operator's list, YAML or JSON, with the signatures beside it; see
            docs/reference/perception.md.

    Raises:
        BadData: One of the two can't be read, or an object was never shown.
    """
    return Enrolled(read_enrolment(path))


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
        detector = NoisyDetector(Oracle(words, poses), dials, poses, seed, run, absent)
        return Perception(detector, guessed=dials.over > 0 or dials.under > 0)

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
        return Perception(segmenter, finder, ModelSceneDescriber(ask, convention), guessed=True)

    return perceiver
