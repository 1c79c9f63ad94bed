"""How a named thing lies or stands, in words. Knows the poses of what shows; no pixels."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from functools import lru_cache
from importlib.resources import files
from typing import Literal

import numpy as np
import yaml

from probe.assets.spec import ObjectSpec
from probe.types import Pose

Poses = Callable[[], Mapping[int, Pose]]
"""Where each object is right now, by instance."""

Posture = Literal["as told", "rolled", "upside down", "lying on its side", "standing on end",
                  "standing on edge", "tilted"]  # fmt: skip
"""As told: as the catalogue describes it. Rolled: lying as before, with another side up. Tilted:
half over, of which nothing is said."""

_STEEP, _LEVEL = float(np.cos(np.radians(25))), float(np.sin(np.radians(25)))
_LONG, _TALL, _FLAT = 1.5, 1.15, 0.4

_UPRIGHT_ONLY = re.compile(
    r",? (?:open at the top|standing (?:upright|on its [a-z ]+)|lying upside up|lying brim down)"
)
_LYING = re.compile(r",? lying (?:down|flat|on its side)")
_VACANT = re.compile(r"\b(?:empty|open) ")
_ARTICLE = re.compile(r"^An? (?=(\w))")


def posture(spec: ObjectSpec, pose: Pose) -> Posture:
    """How a thing lies, compared with the catalogue's pose, in which it is described."""
    upright = float(pose.rotation[2, 2])
    if upright >= _STEEP:
        return "as told"
    topped = has_top(spec)
    if upright <= -_STEEP:
        return "upside down" if topped else "rolled"
    x, y, z = spec.size
    long_axis = 0 if x >= y else 1
    if max(x, y) >= _LONG * max(min(x, y), z):
        along = abs(float(pose.rotation[2, long_axis]))
        if along >= _STEEP:
            return "standing on end"
        return "rolled" if along <= _LEVEL and not topped else "tilted"
    if abs(upright) > _LEVEL:
        return "tilted"
    if topped or z >= _TALL * max(x, y):
        return "lying on its side"
    return "standing on edge" if z <= _FLAT * min(x, y) else "rolled"


def described(spec: ObjectSpec, how: Posture) -> str:
    """The catalogue's description without what doesn't hold, and with the posture where it tells.

    "Open at the top" and the like are said of a thing that stands as it is described, "lying down"
    of one that lies.
    """
    if how == "as told":
        return spec.description
    text = _UPRIGHT_ONLY.sub("", spec.description).replace(" upright ", " ")
    if spec.hollow:
        text = _ARTICLE.sub(_article, _VACANT.sub("", text))
    if how != "rolled":
        text = _LYING.sub("", text)
    if how in ("rolled", "tilted"):
        return text
    return f"{text.removesuffix('.')}, {how}."


def has_top(spec: ObjectSpec) -> bool:
    """Whether one can see that it stands on its head: a vessel, or of a kind with a clear top."""
    return spec.hollow or spec.category in _topped()


@lru_cache(1)
def _topped() -> frozenset[str]:
    source = files("probe.perception") / "data/topped.yaml"
    return frozenset(yaml.safe_load(source.read_text("utf-8")))


def _article(before: re.Match[str]) -> str:
    return "An " if before[1] in "aeiou" else "A "
