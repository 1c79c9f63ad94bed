"""The version of the tools: of all that they say and do. Knows no record."""

from __future__ import annotations

from collections.abc import Iterable

TOOLS_VERSION = 3
"""To be raised when a tool's texts, or what a skill does, change so that results may, once the
version before has been released: records of one that hasn't may differ from its release.

1: The texts and skills of release 0.1.
2: Outcomes are told by what the camera sees, lists give object_ids, grasps may take an edge, and an
   answer that lacks something is refused.
3: A grasp may push the thing first, makes up to five tries, and takes what may be thicker than a
   slab across before it takes it by an edge. The hand keeps off its own arm on the way.
"""

ANSWERS_CHECKED = 2
"""The first version that refuses an answer that lacks something."""

_MADE_BY = {1: "0.1"}
"""Releases by the version of their tools, apart from this one."""


def release_words(version: int) -> str:
    """Which release has the tools of another version: "probe-vqa 0.1"."""
    known = _MADE_BY.get(version)
    return f"probe-vqa {known}" if known else f"the release of probe-vqa with tools {version}"


def tools_words(versions: Iterable[int]) -> str:
    """What to say where results of several versions stand side by side; empty if it is but one."""
    found = sorted(set(versions))
    if len(found) < 2:
        return ""
    several = f"{', '.join(map(str, found[:-1]))} and {found[-1]}"
    return (
        f"These results come from different versions of the tools ({several}). The tools' texts "
        "and skills changed in between, so a difference may come from the tools"
    )
