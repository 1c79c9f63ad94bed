"""What the catalogue tells of the options, without any picture."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping

from probe.agents.text_features import Features
from probe.assets.spec import ObjectSpec
from probe.shortcuts.comparing import joined, log, number, relative, with_context
from probe.shortcuts.sample import CatalogueFacts, Sample

SIZES: Mapping[str, Callable[[ObjectSpec], float]] = {
    "longest": lambda spec: log(max(spec.size)),
    "shortest": lambda spec: log(min(spec.size)),
    "footprint": lambda spec: log(spec.size[0] * spec.size[1]),
    "height": lambda spec: log(spec.size[2]),
    "volume": lambda spec: log(math.prod(spec.size)),
    "mass": lambda spec: log(spec.mass),
    "colours": lambda spec: len(spec.colours),
    "hollow": lambda spec: float(spec.hollow),
    "scan": lambda spec: float(spec.origin == "scan"),
}


def by_catalogue(sample: Sample, catalogue: CatalogueFacts) -> tuple[Features, ...]:
    """Size, category and frequency of each option's object; of Count, of what is counted."""
    if sample.numbered:
        return _counted(sample, catalogue)
    specs = [catalogue.by_name.get(text) for text in sample.options]
    if not any(specs):
        return tuple({} for _ in specs)
    sizes = [
        relative(name, [spec and size(spec) for spec in specs]) for name, size in SIZES.items()
    ]
    frequency = [spec and log(catalogue.common[spec.category]) for spec in specs]
    kin = [
        spec and float(sum(o is not None and o.category == spec.category for o in specs) - 1)
        for spec in specs
    ]
    hues = [
        spec and float(sum(o is not None and o.colours[:1] == spec.colours[:1] for o in specs) - 1)
        for spec in specs
    ]
    return joined(
        with_context(sample.options, {}),
        *sizes,
        relative("frequency", frequency),
        relative("same category", kin),
        relative("same colour", hues),
    )


def _counted(sample: Sample, catalogue: CatalogueFacts) -> tuple[Features, ...]:
    spec = catalogue.counted(sample.question)
    values = [number(text) for text in sample.options]
    context: dict[str, float] = {}
    if spec is not None:
        context = {name: size(spec) for name, size in SIZES.items()}
        context["frequency"] = log(catalogue.common[spec.category])
    by_number = [
        {f"number {value} {name}": x for name, x in context.items()} | {f"number {value}": 1.0}
        for value in values
    ]
    floats = [None if value is None else float(value) for value in values]
    return joined(with_context(sample.options, context), by_number, relative("number", floats))
