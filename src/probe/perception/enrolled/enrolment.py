"""The objects that perception knows by their looks: an operator's words and what they look like."""

from __future__ import annotations

from dataclasses import dataclass

from probe.perception.enrolled.signature import Signature


@dataclass(frozen=True)
class EnrolledWords:
    """What an operator says of an object.

    Attributes:
        name: Short, and no other object's.
        synonyms: Other names that it goes by.
        description: One sentence of what one sees; empty if nothing was said.
    """

    name: str
    synonyms: tuple[str, ...] = ()
    description: str = ""


@dataclass(frozen=True, eq=False)
class EnrolledObject:
    """One object.

    Attributes:
        words: The operator's.
        views: One signature for each pose that it was shown in; at least one.
    """

    words: EnrolledWords
    views: tuple[Signature, ...]


@dataclass(frozen=True, eq=False)
class Enrolment:
    """All objects that were shown.

    Attributes:
        objects: In the operator's order.
        digest: Of all words and signatures, 12 hex digits.
    """

    objects: tuple[EnrolledObject, ...]
    digest: str
