"""Which of the meshes found are objects: not collision meshes, nor one object a second time."""

from __future__ import annotations

import re
from collections import defaultdict
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path

from probe.assets.importers import IMPORTERS
from probe.assets.importers.normalised import content_of
from probe.assets.importers.options import ImportOptions
from probe.assets.importers.source import Source
from probe.assets.importers.wording import place_of, variant_of
from probe.errors import BadData, BadMesh

COLLISION = re.compile(
    r"(?:^|[^a-z])(?:coacd|coll|collider|collisions?|convex|decomp(?:osed|osition)?|physics|vhacd)"
    r"(?:[^a-z]|$)"
)
"""Words in the name of a file or folder that say that a mesh is for physics alone."""

PREFERRED = ("google_16k", "google_64k", "google_512k")
"""YCB's reconstructions, the best first; "poisson" and "tsdf" come after all others."""
_LAST = ("poisson", "tsdf", "clouds")

UNWIELDY = 20 * 2**20
"""Bytes of a mesh file above which a smaller one of the same object is better."""

Found = tuple[Source, ImportOptions]


@dataclass(frozen=True)
class Passed:
    """A mesh that is no object of its own, and why."""

    label: str
    reason: str


def sift(found: Sequence[Found]) -> tuple[list[Found], list[Passed]]:
    """Split what was found into objects and what is passed over; both in order.

    Passed over are collision meshes, further meshes of an object (without texture, in another
    resolution, by another reconstruction), and files with the same content. Sets that list their
    objects one by one are left alone.
    """
    passed: dict[str, Passed] = {}
    loose = [one for one in found if one[1].format in ("obj", "gltf")]
    for source, _ in loose:
        if _is_collision(source):
            passed[source.label] = Passed(source.label, "a collision mesh, by its name")
    left = [one for one in loose if one[0].label not in passed]
    sizes = _groups(left, lambda one: _size(one[0].mesh))
    alike = [one for group in sizes if len(group) > 1 for one in group]
    _pass_over(passed, alike, _content, lambda kept: f"the same files as {kept}")
    left = [one for one in left if one[0].label not in passed]
    _pass_over(passed, left, _object_key, lambda kept: f"the same object as {kept}")
    return [one for one in found if one[0].label not in passed], list(passed.values())


def _pass_over(
    passed: dict[str, Passed],
    found: Iterable[Found],
    key: Callable[[Found], object],
    reason: Callable[[str], str],
) -> None:
    """Keep the best of each group, and pass the others over."""
    for group in _groups(found, key):
        if len(group) > 1:
            best, *others = sorted(group, key=_rank)
            for source, _ in others:
                passed[source.label] = Passed(source.label, reason(best[0].label))


def _groups(found: Iterable[Found], key: Callable[[Found], object]) -> list[list[Found]]:
    groups: dict[object, list[Found]] = defaultdict(list)
    for one in found:
        groups[key(one)].append(one)
    return list(groups.values())


def _object_key(one: Found) -> object:
    source = one[0]
    return place_of(source.mesh, source.root)[1], variant_of(source.mesh.stem)


def _content(one: Found) -> object:
    try:
        return content_of(*one)
    except (BadMesh, BadData):
        return one[0].label


def _rank(one: Found) -> tuple[bool, int, bool, int, str]:
    """The lower the better: usable, a good reconstruction, of a size that can be handled, fine."""
    source, order = one
    size = _size(source.mesh)
    heavy = size > UNWIELDY
    fine = size if heavy else -size
    return not _is_usable(source, order), _preference(source), heavy, fine, source.label


def _preference(source: Source) -> int:
    parts = source.mesh.parts
    for number, name in enumerate(PREFERRED):
        if name in parts:
            return number
    return len(PREFERRED) + any(name in parts for name in _LAST)


def _is_usable(source: Source, order: ImportOptions) -> bool:
    try:
        IMPORTERS[order.format].files(source)
    except (BadMesh, BadData):
        return False
    return True


def _is_collision(source: Source) -> bool:
    names = [*Path(source.label).parts[:-1], source.mesh.stem]
    return any(COLLISION.search(name.lower()) for name in names)


def _size(path: Path) -> int:
    return path.stat().st_size if path.is_file() else -1
