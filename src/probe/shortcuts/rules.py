"""Fixed rules that look for a shortcut each. They learn nothing and know no answers."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

from probe.assets.spec import ObjectSpec
from probe.generation.first_look import VisibleThing
from probe.generation.observer import (
    half_hidden,
    marked,
    misfit,
    observe,
    observer_of,
    visible_count,
)
from probe.shortcuts.by_depth import cover_of, height_gaps
from probe.shortcuts.comparing import is_none, number
from probe.shortcuts.sample import CatalogueFacts, Sample
from probe.tasks.task import LETTERS, PAIR

Rule = Callable[[Sample, CatalogueFacts], Sequence[int]]
"""Places of the options between which it can't choose."""

OBSERVER = "observer"


def rules_for(sample: Sample) -> Mapping[str, Rule]:
    """The rules that say something about questions like this one."""
    letters = {
        f"always {letter}": _always(place)
        for place, letter in enumerate(LETTERS[: len(sample.options)])
    }
    special = _PAIRED if sample.paired else _NUMBERS if sample.numbered else _OBJECTS
    return {**letters, **special, OBSERVER: _observer}


def _always(place: int) -> Rule:
    return lambda sample, catalogue: (place,)


def _observer(sample: Sample, catalogue: CatalogueFacts) -> Sequence[int]:
    letter = observe(
        sample.question_type, sample.form, sample.question, sample.options, sample.look
    )
    return (LETTERS.index(letter),)


def _object(best: Callable[[ObjectSpec, CatalogueFacts], float]) -> Rule:
    """The option whose object has the largest value."""

    def rule(sample: Sample, catalogue: CatalogueFacts) -> Sequence[int]:
        specs = [catalogue.by_name.get(text) for text in sample.options]
        return _most([None if spec is None else best(spec, catalogue) for spec in specs])

    return rule


def _patch(sample: Sample, catalogue: CatalogueFacts) -> Sequence[int]:
    """The option whose colour is nearest to something half hidden."""
    patches = half_hidden(sample.question, sample.look)
    return _most([None if is_none(o) else -misfit(o, patches) for o in sample.options])


def _number(best: Callable[[int, Sequence[int]], float]) -> Rule:
    """The number with the largest value among those offered."""

    def rule(sample: Sample, catalogue: CatalogueFacts) -> Sequence[int]:
        values = [number(text) for text in sample.options]
        told = sorted(value for value in values if value is not None)
        return _most([None if value is None else best(value, told) for value in values])

    return rule


def _seen(more: int) -> Rule:
    """What is seen and so many more; "none of the above" where that isn't offered."""

    def rule(sample: Sample, catalogue: CatalogueFacts) -> Sequence[int]:
        wanted = visible_count(sample.question, sample.look) + more
        last = len(sample.options) - 1
        return [n for n, text in enumerate(sample.options) if number(text) == wanted] or [last]

    return rule


def _pair(a_less_b: Callable[[Sample], float]) -> Rule:
    """A where a number is positive, B where it is negative; the other way round for "smaller"."""

    def rule(sample: Sample, catalogue: CatalogueFacts) -> Sequence[int]:
        lead = a_less_b(sample) * (-1 if sample.form == "smaller" else 1)
        return (0,) if lead > 0 else (1,) if lead < 0 else range(len(PAIR))

    return rule


def _area(sample: Sample) -> float:
    a, b = marked(sample.look)
    return a.area_px - b.area_px


def _bare(sample: Sample) -> float:
    a, b = marked(sample.look)
    return b.overlapped - a.overlapped


def _higher(sample: Sample) -> float:
    a, b = marked(sample.look)
    return a.top_m - b.top_m


def _of_covers(number: Callable[[VisibleThing], float]) -> Callable[[Sample], float]:
    """By how much more of something the cover of A has than that of B; 0 if one has none."""

    def lead(sample: Sample) -> float:
        look = sample.look
        a, b = (cover_of(look, look.marked[letter]) for letter in PAIR)
        return number(a) - number(b) if a and b else 0.0

    return lead


_cover_height = _of_covers(lambda cover: cover.top_m)
_cover_tilt = _of_covers(lambda cover: cover.tilt)


def _fits_room(sample: Sample, catalogue: CatalogueFacts) -> Sequence[int]:
    """The option whose object is as high as the room beneath what the question names."""
    gaps = height_gaps(sample, catalogue).get("height", [None] * len(sample.options))
    return _most([None if gap is None else -gap for gap in gaps])


def _tells_a(sample: Sample) -> float:
    """Positive where the observer says A, if it goes by patches; else by which is darker."""
    if observer_of(sample.question_type).by_colour:
        told = observe(
            sample.question_type, sample.form, sample.question, sample.options, sample.look
        )
        return 1.0 if told == "A" else -1.0
    a, b = marked(sample.look)
    return b.lab[0] - a.lab[0]


def _most(values: Sequence[float | None]) -> Sequence[int]:
    """Places of the largest value; all where there is none."""
    told = [value for value in values if value is not None]
    best = max(told, default=None)
    return [n for n, value in enumerate(values) if value == best or best is None]


def _middle(value: int, told: Sequence[int]) -> float:
    return -abs(value - (told[(len(told) - 1) // 2] + told[len(told) // 2]) / 2)


_OBJECTS: Mapping[str, Rule] = {
    "smallest": _object(lambda spec, catalogue: -max(spec.size)),
    "largest": _object(lambda spec, catalogue: max(spec.size)),
    "commonest": _object(lambda spec, catalogue: catalogue.common[spec.category]),
    "rarest": _object(lambda spec, catalogue: -catalogue.common[spec.category]),
    "patch colour": _patch,
    "fits by height": _fits_room,
}
_NUMBERS: Mapping[str, Rule] = {
    "smallest number": _number(lambda value, told: -value),
    "largest number": _number(lambda value, told: value),
    "middle number": _number(_middle),
    **{f"seen + {more}": _seen(more) for more in range(3)},
}
_PAIRED: Mapping[str, Rule] = {
    "larger area": _pair(_area),
    "smaller area": _pair(lambda sample: -_area(sample)),
    "less occluded": _pair(_bare),
    "more occluded": _pair(lambda sample: -_bare(sample)),
    "higher thing": _pair(_higher),
    "lower thing": _pair(lambda sample: -_higher(sample)),
    "higher cover": _pair(_cover_height),
    "lower cover": _pair(lambda sample: -_cover_height(sample)),
    "steeper cover": _pair(_cover_tilt),
    "flatter cover": _pair(lambda sample: -_cover_tilt(sample)),
    "patch colour": _pair(_tells_a),
    "not patch colour": _pair(lambda sample: -_tells_a(sample)),
}
