from __future__ import annotations

import shutil
import time
from pathlib import Path

import numpy as np
import pytest

from probe.assets import library as library_module
from probe.assets.cache import Cache
from probe.assets.library import Library, open_library
from probe.assets.mesh.fingerprint import Fingerprint, fingerprint
from probe.assets.mesh.mesh import Body
from probe.assets.mesh.packing import pack_body, unpack_body
from probe.assets.pools.procedural import procedural_key
from probe.assets.procedural import catalogue
from probe.assets.recipes import recipe
from probe.assets.spec import ObjectSpec
from probe.errors import BadData, BadMesh, UnknownName

CRATE = """{
"version": 1, "id": "own_crate", "name": "green crate", "category": "crate", "colours": ["green"],
"description": "A crate.", "mass": 0.2, "friction": 0.5, "size": [0.1, 0.1, 0.05], "hollow": true,
"licence": "CC0-1.0", "source": "a test", "provenance": {"name": "human"}, "format": "gltf",
"file": "crate.glb", "content": "0123456789abcdef0123456789abcdef", "unit": 1.0,
"turn_wxyz": [1, 0, 0, 0], "shift": [0, 0, 0]
}
"""


@pytest.fixture
def library(cache) -> Library:
    return open_library("procedural", None, cache)


def _few(library: Library, count: int, cache: Path) -> Library:
    return Library(library.specs[:count], library.assets, cache)


def test_a_spec_is_found_by_id(library):
    spec = library.specs[3]
    assert library[spec.id] is spec
    assert len({spec.id for spec in library.specs}) == len(library.specs)


def test_an_unknown_id_is_refused(library):
    for look_up in (library.__getitem__, library.body):
        with pytest.raises(UnknownName, match="no_such_thing"):
            look_up("no_such_thing")


def test_a_body_is_the_same_from_the_cache(library, tmp_path):
    id = library.specs[0].id
    fresh = _few(library, 1, tmp_path).body(id)
    again = _few(library, 1, tmp_path).body(id)
    assert again.mesh.digest() == fresh.mesh.digest()
    assert len(again.pieces) == len(fresh.pieces) > 0
    for a, b in zip(again.pieces, fresh.pieces, strict=True):
        assert (a.vertices == b.vertices).all()


def _same_shape(one: Body, other: Body) -> bool:
    pairs = [
        (getattr(one.mesh, k), getattr(other.mesh, k)) for k in ("vertices", "normals", "faces")
    ]
    pairs += [(a.vertices, b.vertices) for a, b in zip(one.pieces, other.pieces, strict=False)]
    same = len(one.pieces) == len(other.pieces)
    return same and all(a.dtype == b.dtype and np.array_equal(a, b) for a, b in pairs)


def test_a_form_has_the_shape_of_the_body_and_needs_no_paint(library, tmp_path, monkeypatch):
    some = _few(library, 3, tmp_path)
    with monkeypatch.context() as patch:
        patch.setattr(catalogue, "paint", None)
        forms = [some.form(spec.id) for spec in some.specs]
        patch.setattr(library_module, "procedural_form", None)
        again = [_few(library, 3, tmp_path).form(spec.id) for spec in some.specs]
    for spec, form, kept in zip(some.specs, forms, again, strict=True):
        body = some.body(spec.id)
        assert _same_shape(form, body) and _same_shape(kept, body)
        assert _same_shape(body.unpainted(), body)
        assert form.mesh.surface.texture.shape == (1, 1, 3) != body.mesh.surface.texture.shape
        assert len(form.mesh.uvs) == len(form.mesh.vertices)


def test_a_form_is_taken_from_a_body_that_is_there(library, tmp_path, monkeypatch):
    some = _few(library, 1, tmp_path)
    (spec,) = some.specs
    body = some.body(spec.id)
    monkeypatch.setattr(library_module, "procedural_form", None)
    assert _same_shape(some.form(spec.id), body)


def test_a_form_that_isnt_the_bodys_is_forgotten_where_suites_are_compared(library, tmp_path):
    one, other = (spec.id for spec in library.specs[:2])
    few = _few(library, 2, tmp_path)
    strange = few.form(other)
    Cache(tmp_path / "forms").store(procedural_key(one, 1), pack_body(strange))
    assert _same_shape(few.form(one), strange)
    few.fingerprint(one)
    for each in (few, _few(library, 2, tmp_path)):
        assert _same_shape(each.form(one), each.body(one))


def test_what_is_measured_on_a_body_is_measured_once_and_again_by_another_recipe(library, tmp_path):
    some, bodies = library.specs[:2], []

    def measured(id: str, recipe: str) -> float:
        fresh = _few(library, 2, tmp_path)  # another process, as far as memory goes

        def heights() -> dict[str, np.ndarray]:
            body = fresh.form(id)
            bodies.append(id)
            return {"height": body.mesh.vertices[:, 2].max(), "none": np.array([])}

        return float(fresh.measured(id, "heights", recipe, heights)["height"])

    for spec in some:
        assert measured(spec.id, "a") == measured(spec.id, "a")
        assert measured(spec.id, "a") == pytest.approx(spec.size[2], abs=1e-3)
    assert len(set(bodies)) == len(bodies) == 2
    measured(some[0].id, "b")
    assert bodies[2:] == bodies[:1]


def test_a_fingerprint_is_kept_and_found_without_the_body(library, tmp_path, monkeypatch):
    id = library.specs[0].id
    fresh = _few(library, 1, tmp_path).fingerprint(id)
    assert fresh == fingerprint_of(library, id)
    monkeypatch.setattr(Library, "body", None)
    assert _few(library, 1, tmp_path).fingerprint(id) == fresh


def test_a_fingerprint_is_of_the_body_that_lies_there(library, tmp_path):
    """Another body under an object's key is seen, as if no fingerprint had been kept."""
    one, other = (spec.id for spec in library.specs[:2])
    few = _few(library, 2, tmp_path)
    few.fingerprint(one)
    stored = Cache(tmp_path / "bodies")
    stored.store(procedural_key(one, 1), pack_body(few.body(other)))
    assert _few(library, 2, tmp_path).fingerprint(one) == few.fingerprint(other)


def test_a_body_in_memory_alone_has_a_fingerprint(library, tmp_path):
    id = library.specs[0].id
    few = _few(library, 1, tmp_path / "cache")
    few.body(id)
    shutil.rmtree(tmp_path / "cache")
    assert few.fingerprint(id) == fingerprint_of(library, id)


def fingerprint_of(library: Library, id: str) -> Fingerprint:
    return fingerprint(library.body(id))


def test_a_body_in_memory_is_kept(library):
    id = library.specs[0].id
    assert library.body(id) is library.body(id)


def test_a_damaged_body_is_made_again(library, tmp_path):
    id = library.specs[0].id
    fresh = _few(library, 1, tmp_path).body(id)
    (entry,) = (tmp_path / "bodies").rglob("*.npz")
    entry.write_bytes(entry.read_bytes()[:1000])
    assert _few(library, 1, tmp_path).body(id).mesh.digest() == fresh.mesh.digest()


def test_scans_without_assets_say_what_to_set(cache, tmp_path):
    with pytest.raises(BadData, match="PROBE_ASSETS"):
        open_library("scans", None, cache)


@pytest.mark.parametrize("pool", ["scans", "all"])
def test_assets_without_scans_are_named(cache, tmp_path, pool):
    with pytest.raises(BadData, match=r"scans.*not a folder"):
        open_library(pool, tmp_path, cache)


def test_all_are_those_that_are_here(cache, tmp_path):
    alone = open_library("all", None, cache, tmp_path / "nobody's")
    assert {spec.origin for spec in alone.specs} == {"procedural"}
    assert not any(map(alone.leads, alone.specs))


@pytest.mark.parametrize("pool", ["own+procedural", "all"])
def test_ones_own_lead_among_others_without_extra_assets(cache, tmp_path, pool):
    home = tmp_path / "own_crate"
    home.mkdir()
    (home / "entry.json").write_text(CRATE)
    mixed = open_library(pool, None, cache, tmp_path)
    assert {spec.origin for spec in mixed.specs} == {"procedural", "own"}
    assert [spec.id for spec in mixed.specs if mixed.leads(spec)] == ["own_crate"]
    assert not any(map(open_library("own", None, cache, tmp_path).leads, mixed.specs))


def test_ones_own_beside_procedural_ones_have_to_be_there(cache, tmp_path):
    with pytest.raises(BadData, match="PROBE_LIBRARY"):
        open_library("own+procedural", None, cache, tmp_path / "nobody's")


def test_an_incomplete_folder_of_scans_is_named(cache, tmp_path):
    folder = tmp_path / "scans"
    folder.mkdir()
    (folder / "index.csv").write_text("id,licence,source_dataset\n")
    with pytest.raises(BadMesh, match=r"\.glb"):
        open_library("scans", tmp_path, cache)


def test_packing_loses_nothing(library):
    body = library.body(library.specs[1].id)
    back = unpack_body(pack_body(body))
    assert back.mesh.digest() == body.mesh.digest()
    assert [len(piece.vertices) for piece in back.pieces] == [len(p.vertices) for p in body.pieces]


def test_the_recipe_is_stable_within_a_version():
    assert recipe("probe.assets.procedural") == recipe("probe.assets.procedural")


def test_scans_are_confirmed_ones_with_sizes(assets, cache):
    library = open_library("scans", assets, cache)
    assert all(isinstance(spec, ObjectSpec) and spec.origin == "scan" for spec in library.specs)
    assert all(0.005 < max(spec.size) < 0.5 for spec in library.specs)
    assert all(spec.licence and spec.source for spec in library.specs)
    both = open_library("all", assets, cache)
    assert {spec.origin for spec in both.specs} == {"scan", "procedural"}


@pytest.mark.slow
def test_warm_scans_load_fast_and_fit_their_specs(assets, cache):
    library = open_library("scans", assets, cache)
    ids = [spec.id for spec in library.specs][::9][:15]
    for id in ids:
        library.body(id)
    fresh = open_library("scans", assets, cache)
    start = time.perf_counter()
    bodies = [fresh.body(id) for id in ids]
    assert time.perf_counter() - start < 2.0  # 0.1 to 0.2 s on an idle machine
    for id, body in zip(ids, bodies, strict=True):
        assert body.mesh.extent == pytest.approx(np.array(fresh[id].size), abs=1e-4)
