"""The two worlds of a Compare task in pictures: alike to look at, and answered otherwise."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

from probe.assets.colour.difference import ciede2000
from probe.assets.library import Library
from probe.generation.colour_cues import leads_enough, least_lead
from probe.generation.colour_views import ColourViews
from probe.generation.result import Rejected
from probe.render.renderer import Renderer
from probe.scene.scene import Scene
from probe.tasks.task import PAIR
from probe.tasks.truth import ALIKE, which_fits
from probe.tasks.type_rules import Form
from probe.types import Array

MOST_APART = 1.5
"""CIEDE2000 between main colours of what shows in the two worlds; less than an eye sees."""


@dataclass(frozen=True)
class CompareQuestion:
    """What Compare asks about, by a scene's numbers.

    Attributes:
        form: Of the question.
        marked: A and B.
        twins: Object ids of what lies there in the other world.
        word: The colour's name; empty where none is named.
        reference: The thing whose colour is asked for, or None.
    """

    form: Form
    marked: tuple[int, int]
    twins: tuple[str, str]
    word: str
    reference: int | None

    @property
    def compared(self) -> tuple[int, ...]:
        """All whose colours count."""
        return self.marked if self.reference is None else (*self.marked, self.reference)

    @property
    def subject(self) -> int | str:
        """The thing whose colour is asked for, else the colour's name or nothing."""
        return self.word if self.reference is None else self.reference


def other_world(scene: Scene, paints: Mapping[int, str]) -> Scene:
    """The same table with other things, by number and object id, where those of one shape lie."""
    return replace(
        scene,
        objects=tuple(
            replace(o, object_id=paints.get(o.instance, o.object_id)) for o in scene.objects
        ),
    )


def look_at_worlds(
    matter: CompareQuestion,
    scene: Scene,
    labels: Array,
    right: int,
    library: Library,
    renderer: Renderer,
) -> dict[str, float]:
    """Pictures of both worlds; what the renderer had loaded is replaced.

    Args:
        matter: What is asked.
        scene: The world that is asked about.
        labels: Of both.
        right: Index of the right one in it.
        library: Has all things.
        renderer: Takes the pictures.

    Returns:
        By how much the right one's patch fits better ("patch_lead"), how far what shows differs
        between the worlds ("worlds_apart", CIEDE2000), and main colours ("apart_LIGHT").

    Raises:
        Rejected: One of them isn't clear in every light, or what shows tells them apart.
    """
    twin = other_world(scene, dict(zip(matter.marked, matter.twins, strict=True)))
    there = ColourViews(renderer, twin, labels, matter.compared, library)
    others = [there.patch(number) for number in matter.marked]
    _check_lights(matter, there, 1 - right)
    # Last, so that what the scene needs is loaded afterwards.
    here = ColourViews(renderer, scene, labels, matter.compared, library)
    apart = max(
        float(ciede2000(here.patch(number), other))
        for number, other in zip(matter.marked, others, strict=True)
    )
    if apart > MOST_APART:
        raise Rejected("paint", f"what shows differs by {apart:.1f} between the worlds")
    lead = here.lead(matter.form, matter.marked, matter.subject, right)
    if not leads_enough(matter.form, lead):
        raise Rejected("cues", "neither patch fits clearly better")
    apart_by_light = _check_lights(matter, here, right)
    return {"patch_lead": lead, "worlds_apart": apart, **apart_by_light}


def look_at_open_worlds(
    matter: CompareQuestion,
    scene: Scene,
    labels: Array,
    right: int,
    library: Library,
    renderer: Renderer,
) -> dict[str, float]:
    """The same where the marked things lie open: in either world what shows tells the answer.

    The arguments are those of look_at_worlds(), and so is what is done to the renderer.

    Returns:
        By how much the right one's patch fits better ("patch_lead"), and main colours
        ("apart_LIGHT").

    Raises:
        Rejected: In one of the worlds what shows of a thing isn't of its main colour, or doesn't
            tell; or main colours aren't clear in every light.
    """
    twin = other_world(scene, dict(zip(matter.marked, matter.twins, strict=True)))
    _look_at_open(matter, ColourViews(renderer, twin, labels, matter.compared, library), 1 - right)
    # Last, so that what the scene needs is loaded afterwards.
    here = ColourViews(renderer, scene, labels, matter.compared, library)
    return _look_at_open(matter, here, right)


def _look_at_open(matter: CompareQuestion, looks: ColourViews, right: int) -> dict[str, float]:
    apart_by_light = _check_lights(matter, looks, right)
    patches = {number: looks.patch(number) for number in matter.compared}
    for number, patch in patches.items():
        off = float(ciede2000(patch, looks.main(number, looks.lights[0])))
        if off > ALIKE:
            raise Rejected("open", f"what shows is {off:.1f} from the whole thing's main colour")
    model = matter.marked[right] if matter.reference is None else matter.reference
    a, b = (patches[number] for number in matter.marked)
    lead = looks.lead(matter.form, matter.marked, matter.subject, right)
    try:
        tells = which_fits(matter.form, a, b, patches[model]) == PAIR[right]
    except ValueError as error:
        raise Rejected("open", f"what shows: {error}") from error
    if not tells or lead < least_lead(matter.form):
        raise Rejected("open", f"by what shows, the right one leads by {lead:.1f}")
    return {"patch_lead": lead, **apart_by_light}


def _check_lights(matter: CompareQuestion, looks: ColourViews, right: int) -> dict[str, float]:
    measures = dict[str, float]()
    for light in looks.lights:
        model = matter.marked[right] if matter.reference is None else matter.reference
        a, b, like = (looks.main(number, light) for number in (*matter.marked, model))
        try:
            found = which_fits(matter.form, a, b, like)
        except ValueError as error:
            raise Rejected("light", f"{light}: {error}") from error
        if found != PAIR[right]:
            raise Rejected("light", f"the other one fits in {light}")
        measures[f"apart_{light}"] = float(ciede2000(a, b))
    return measures
