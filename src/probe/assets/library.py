"""The objects one can put on a table: their specs, and their bodies on demand."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Literal

import numpy as np

from probe.assets.cache import Cache, content_key
from probe.assets.looks import Looks
from probe.assets.mesh.fingerprint import Fingerprint, fingerprint
from probe.assets.mesh.kept_fingerprint import key_of_file, pack_fingerprint, unpack_fingerprint
from probe.assets.mesh.mesh import Body
from probe.assets.mesh.packing import LAYOUT, pack_body, unpack_body
from probe.assets.pools import scans
from probe.assets.pools.division import PARTS, part_of_object
from probe.assets.pools.own import own_body, own_key, own_specs
from probe.assets.pools.procedural import (
    procedural_body,
    procedural_form,
    procedural_key,
    procedural_specs,
)
from probe.assets.procedural.tables import NEWEST_EDITION, Edition
from probe.assets.recent import Recent
from probe.assets.spec import ObjectSpec, Origin
from probe.assets.tables import TableMaterial, load_table
from probe.errors import BadData, UnknownName
from probe.types import Array

Pool = Literal[
    "train", "evaluation", "procedural", "procedural-2", "scans", "own", "own+procedural", "all"
]
"""Where objects come from. What is made by formula is divided into train and evaluation, which are
procedural-2 together; procedural is its first edition, all of it for evaluation."""

TRAINING_POOL: Pool = "train"
EVALUATION_POOL: Pool = "evaluation"
"""What training tasks and suites are made of if nobody says otherwise."""

_EDITIONS: dict[Pool, Edition] = {
    "train": NEWEST_EDITION,
    "evaluation": NEWEST_EDITION,
    "procedural": 1,
    "procedural-2": 2,
    "own+procedural": 1,
    "all": NEWEST_EDITION,
}

KEPT = 64
"""Bodies kept in memory; one with a 1024-pixel texture takes about 4 MB."""

FORMS_KEPT = 512
"""Shapes kept in memory; one of the built-in objects takes 0.1 to 0.5 MB."""


@dataclass(frozen=True, eq=False)
class Library:
    """Objects by id.

    Attributes:
        specs: All objects, in a fixed order.
        assets: Folder of extra assets; None if only procedural objects are wanted.
        cache: Folder for computed bodies.
        own: Folder of the user's own library; None if its objects aren't wanted.
        leading: Where those come from that play the parts in tasks, wherever they can; None if all
            are alike.
        pool: What it was opened as; None of a library that was put together otherwise.
    """

    specs: tuple[ObjectSpec, ...]
    assets: Path | None
    cache: Path
    own: Path | None = None
    leading: Origin | None = None
    pool: Pool | None = None
    _bodies: Recent[tuple[str, Looks], Body] = field(
        default_factory=lambda: Recent[tuple[str, Looks], Body](KEPT), init=False, repr=False
    )
    _forms: Recent[str, Body] = field(
        default_factory=lambda: Recent[str, Body](FORMS_KEPT), init=False, repr=False
    )
    _prints: dict[tuple[str, Looks], Fingerprint] = field(
        default_factory=dict[tuple[str, Looks], Fingerprint], init=False, repr=False
    )

    def __getitem__(self, object_id: str) -> ObjectSpec:
        """The spec of an object.

        Raises:
            UnknownName: No object has this id.
        """
        for spec in self.specs:
            if spec.id == object_id:
                return spec
        remedy = "`probe assets list` shows them."
        raise UnknownName("object", object_id, [spec.id for spec in self.specs], remedy)

    @property
    def light_cache(self) -> Path:
        """Folder in which renderers keep the light that they prepared."""
        return self.cache / "light"

    def leads(self, spec: ObjectSpec) -> bool:
        """Whether an object is of those that are to play the parts in tasks."""
        return spec.origin == self.leading

    def body(self, object_id: str, looks: Looks = 1) -> Body:
        """Mesh and convex pieces of an object; computed once, then read from the cache.

        Args:
            object_id: Which.
            looks: How its surface looks, if it is made by formula; its shape is the same in all.

        Raises:
            UnknownName: No object has this id.
            BadMesh: Its file can't be used.
            OutputFailed: The cache can't be written.
        """
        spec = self[object_id]
        its = looks if spec.origin == "procedural" else 1
        return self._bodies.get((object_id, its), lambda: self._read_body(object_id, looks))

    def _read_body(self, object_id: str, looks: Looks) -> Body:
        """From the cache or the files, as they are now."""
        origin, cache = self[object_id].origin, Cache(self.cache / "bodies")
        if origin == "procedural":
            return procedural_body(object_id, cache, Cache(self.cache / "specs"), looks)
        if origin == "own":
            return own_body(object_id, own_folder(self.own), cache)
        return scans.scan_body(object_id, scans_folder(self.assets), cache)

    def form(self, object_id: str) -> Body:
        """The shape of an object, the same as body() gives, but unpainted.

        Made by formula, it takes a third of the time that its body takes; to read it, a sixth.

        Raises:
            UnknownName, BadMesh, OutputFailed: As body().
        """
        return self._forms.get(object_id, lambda: self._read_form(object_id))

    def _read_form(self, object_id: str) -> Body:
        """From the cache, the body or the shape generator."""
        packed = self.measured(
            object_id, "forms", LAYOUT, lambda: pack_body(self._new_form(object_id))
        )
        return unpack_body(packed)

    def _new_form(self, object_id: str) -> Body:
        painted = self._body_file(object_id, 1).is_file()
        if self[object_id].origin == "procedural" and not painted:
            return procedural_form(object_id, Cache(self.cache / "specs"))
        return self._read_body(object_id, 1).unpainted()

    def measured(
        self, object_id: str, what: str, recipe: str, measure: Callable[[], Mapping[str, Array]]
    ) -> Mapping[str, Array]:
        """What is measured on an object's body; computed once, then read from the cache.

        Args:
            object_id: Which object.
            what: Folder of the cache.
            recipe: Has to be another one whenever the same body would give other numbers.
            measure: Computes the numbers.

        Raises:
            UnknownName, BadMesh, OutputFailed: As body().
        """
        kept, key = Cache(self.cache / what), self._measured_key(object_id, what, recipe)
        found = kept.load(key)
        if found is None:
            found = measure()
            kept.store(key, found)
        return found

    def _measured_key(self, object_id: str, what: str, recipe: str) -> str:
        return content_key(what, recipe, self._body_file(object_id, 1).stem)

    def fingerprint(self, object_id: str, looks: Looks = 1) -> Fingerprint:
        """What tells whether an object is still the same; computed once.

        Raises:
            UnknownName, BadMesh, OutputFailed: As body().
        """
        key = (object_id, looks)
        if key not in self._prints:
            self._prints[key] = self._fingerprint(object_id, looks)
        return self._prints[key]

    def _fingerprint(self, object_id: str, looks: Looks) -> Fingerprint:
        """From the cache, if it is of the body that lies there now, byte for byte."""
        prints, file = Cache(self.cache / "fingerprints"), self._body_file(object_id, looks)
        stored = prints.load(key_of_file(file)) if file.is_file() else None
        if stored is not None:
            return unpack_fingerprint(stored)
        body = self.body(object_id, looks)
        found = fingerprint(body)
        self._forget_other_form(object_id, body)
        # A body may be in memory alone, if somebody has cleared the cache.
        if file.is_file():
            prints.store(key_of_file(file), pack_fingerprint(found))
        return found

    def _forget_other_form(self, object_id: str, body: Body) -> None:
        """Forget a form that isn't the body's, which is what suites are compared with."""
        kept, key = Cache(self.cache / "forms"), self._measured_key(object_id, "forms", LAYOUT)
        stored, own = kept.load(key), pack_body(body.unpainted())
        if stored and not all(np.array_equal(stored[name], own[name]) for name in own):
            kept.path(key).unlink(missing_ok=True)
            self._forms.drop(object_id)

    def _body_file(self, object_id: str, looks: Looks) -> Path:
        """Where the cache keeps an object's body."""
        spec, cache = self[object_id], Cache(self.cache / "bodies")
        if spec.origin == "procedural":
            return cache.path(procedural_key(object_id, looks))
        if spec.origin == "own":
            return cache.path(own_key(object_id, own_folder(self.own)))
        return cache.path(scans.scan_key(object_id, scans_folder(self.assets)))

    def table(self, table_id: str, looks: Looks = 1) -> TableMaterial:
        """What a table is made of; see load_table()."""
        return load_table(table_id, self.assets, Cache(self.cache / "tables"), looks)


def open_library(pool: Pool, assets: Path | None, cache: Path, own: Path | None = None) -> Library:
    """The objects of a pool: made by formula, real scans fit for use, a user's own, or several.

    "all" are those that are here: scans if there is a folder of extra assets, the user's own if
    there are any. Among others, the user's own lead.

    Raises:
        BadData: Scans or own objects are wanted but their folder isn't there, or a catalogue is
            broken.
        BadMesh: A scan's file can't be used.
    """
    kept = Cache(cache / "specs")
    specs: tuple[ObjectSpec, ...] = ()
    if pool in _EDITIONS:
        specs += _divided(procedural_specs(kept, _EDITIONS[pool]), pool)
    if pool == "scans" or (pool == "all" and assets is not None):
        specs += scans.scan_specs(scans_folder(assets), kept)
    mine: tuple[ObjectSpec, ...] = ()
    if pool in ("own", "own+procedural"):
        mine = own_specs(own_folder(own))
    elif pool == "all" and own is not None:
        mine = own_specs(own)
    leading: Origin | None = "own" if mine and pool != "own" else None
    return Library(specs + mine, assets, cache, own, leading, pool)


def _divided(specs: tuple[ObjectSpec, ...], pool: Pool) -> tuple[ObjectSpec, ...]:
    """Those of a pool, where it is one part of what there is."""
    if pool not in PARTS:
        return specs
    return tuple(spec for spec in specs if part_of_object(spec.id) == pool)


def open_all(assets: Path | None, cache: Path, own: Path | None = None) -> Library:
    """All objects that suites are made of: scans and the user's own where their folders are.

    Raises:
        BadData: A catalogue is broken.
        BadMesh: A scan's file can't be used.
    """
    return open_library("all", assets, cache, own)


def own_folder(own: Path | None) -> Path:
    """The folder of a user's own library.

    Raises:
        BadData: There is none.
    """
    if own is None or not own.is_dir():
        remedy = "Add some objects (probe assets add), or set PROBE_LIBRARY to their folder."
        raise BadData(own or "PROBE_LIBRARY", "holds no objects of your own", remedy)
    return own


def scans_folder(assets: Path | None) -> Path:
    """The folder of scans within the extra assets.

    Raises:
        BadData: There is none.
    """
    others = "Or set PROBE_ASSETS to a folder that holds scans/, or use the procedural objects."
    remedy = f"{scans.FETCH_THEM} {others}"
    if assets is None:
        raise BadData("PROBE_ASSETS", "is not set, so there are no scans", remedy)
    folder = assets / "scans"
    if not folder.is_dir():
        raise BadData(folder, "is not a folder", remedy)
    return folder
