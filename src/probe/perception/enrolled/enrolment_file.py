"""An Enrolment on disk: the operator's list, which people write, and signatures beside it."""

from __future__ import annotations

import hashlib
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Annotated, Literal

import pydantic

from probe.errors import BadData
from probe.files import read_document, write_text
from probe.perception.enrolled.enrolment import EnrolledObject, EnrolledWords, Enrolment
from probe.perception.enrolled.signature import Signature
from probe.perception.enrolled.signature_document import SignatureDocument
from probe.yaml_file import read_yaml

SIGNATURES = ".signatures.json"
"""What replaces the suffix of the operator's file in the name of the one beside it."""

_REMEDY = "See docs/reference/perception.md"

_Name = Annotated[
    str, pydantic.StringConstraints(strip_whitespace=True, min_length=1, max_length=80)
]


class _Document(pydantic.BaseModel, extra="forbid", allow_inf_nan=False):
    pass


class ObjectEntry(_Document):
    """One object in the operator's list."""

    name: _Name
    synonyms: tuple[_Name, ...] = ()
    description: Annotated[str, pydantic.StringConstraints(max_length=400)] = ""


class ObjectList(_Document):
    """The operator's list."""

    version: Literal[1] = 1
    objects: tuple[ObjectEntry, ...] = pydantic.Field(min_length=1, max_length=500)

    @pydantic.model_validator(mode="after")
    def _names_differ(self) -> ObjectList:
        names = [entry.name.casefold() for entry in self.objects]
        twice = sorted({name for name in names if names.count(name) > 1})
        if twice:
            raise ValueError(f"{twice[0]} is the name of two objects")
        return self


class SignaturesDocument(_Document):
    """What the objects of a list look like, by name; one signature for each pose."""

    version: Literal[1] = 1
    signatures: dict[str, tuple[SignatureDocument, ...]]


def read_list(path: Path) -> tuple[EnrolledWords, ...]:
    """Read an operator's list of objects, YAML or JSON, in its order.

    Raises:
        BadData: It is missing, or a field is invalid; the message names the field.
    """
    listed = read_yaml(path, ObjectList, _REMEDY)
    return tuple(
        EnrolledWords(entry.name, entry.synonyms, entry.description) for entry in listed.objects
    )


def write_signatures(path: Path, signatures: Mapping[str, Sequence[Signature]]) -> None:
    """Write down beside an operator's list what its objects look like.

    Args:
        path: Of the list.
        signatures: By name.

    Raises:
        OutputFailed: It can't be written.
    """
    documents = {
        name: tuple(map(SignatureDocument.of, views)) for name, views in signatures.items()
    }
    text = SignaturesDocument(signatures=documents).model_dump_json()
    write_text(path.with_suffix(SIGNATURES), text + "\n")


def read_enrolment(path: Path) -> Enrolment:
    """Read an operator's list and the signatures beside it.

    Args:
        path: Of the list.

    Raises:
        BadData: One of the two can't be read, or an object of the list was never shown.
    """
    listed, beside = read_list(path), path.with_suffix(SIGNATURES)
    known = read_document(beside, SignaturesDocument, _REMEDY, "Enrol its objects first").signatures
    lacking = [words.name for words in listed if not known.get(words.name)]
    if lacking:
        raise BadData(beside, f"has no signature of {lacking[0]}", "Enrol it first")
    return _of({words: known[words.name] for words in listed})


def enrolment_of(signatures: Mapping[EnrolledWords, Sequence[Signature]]) -> Enrolment:
    """An enrolment that was never written: the same as if it had been, and read again."""
    return _of(
        {words: tuple(map(SignatureDocument.of, views)) for words, views in signatures.items()}
    )


def _of(documents: Mapping[EnrolledWords, Sequence[SignatureDocument]]) -> Enrolment:
    objects = tuple(
        EnrolledObject(words, tuple(view.signature() for view in views))
        for words, views in documents.items()
    )
    said = [f"{words!r} {[view.model_dump() for view in v]}" for words, v in documents.items()]
    return Enrolment(objects, hashlib.sha256("\n".join(said).encode()).hexdigest()[:12])
