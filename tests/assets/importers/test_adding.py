"""Many objects into a library: in parallel, resumed, whole or not there."""

from __future__ import annotations

import time

import pytest

from data_sets import box, gso_folder, obj_folder
from glb_files import textured, write_glb
from probe.assets.cache import Cache
from probe.assets.gltf.glb import glb_bytes, load_glb
from probe.assets.importers.adding import ImportTarget, add, find_sources
from probe.assets.importers.normalised import normalised
from probe.assets.importers.options import ImportOptions
from probe.assets.library import open_library
from probe.assets.pools.own import MESH, own_body, own_entries, store_object
from probe.errors import BadData, BadMesh, OutputFailed, UnknownName

ORDER = ImportOptions("gltf")


def _three(folder):
    """Two good objects and a broken one."""
    folder.mkdir()
    write_glb(folder / "red box.glb", textured(box()))
    write_glb(folder / "blue_box.glb", textured(box((0.08, 0.05, 0.03)), (20, 40, 210)))
    (folder / "broken.glb").write_bytes(b"glTF")
    return folder


def _add(folder, target, workers=1, order=ORDER):
    outcomes = add(find_sources(folder, order), order, target, workers)
    return {outcome.label: outcome for outcome in outcomes}


@pytest.fixture
def target(tmp_path):
    return ImportTarget(tmp_path / "library", tmp_path / "cache")


def test_good_ones_are_added_others_refused_and_a_second_run_skips(tmp_path, target):
    folder = _three(tmp_path / "set")
    first = _add(folder, target)
    assert {label: outcome.status for label, outcome in first.items()} == {
        "red box.glb": "added",
        "blue_box.glb": "added",
        "broken.glb": "refused",
    }
    assert "no GLB" in first["broken.glb"].detail
    assert first["red box.glb"].detail == "own_red_box"
    (folder / "green.glb").write_bytes(b"glTF")
    second = _add(folder, target)
    assert [second[label].status for label in ("red box.glb", "blue_box.glb")] == ["skipped"] * 2
    library = open_library("own", None, target.cache, target.library)
    assert [spec.id for spec in library.specs] == ["own_blue_box", "own_red_box"]
    body = library.body("own_red_box")
    assert body.pieces
    assert body.mesh.extent == pytest.approx(library["own_red_box"].size, abs=1e-4)
    assert {spec.origin for spec in library.specs} == {"own"}


@pytest.mark.slow
def test_several_workers_give_the_same_bytes(tmp_path, target):
    folder = _three(tmp_path / "set")
    _add(folder, target)
    other = ImportTarget(tmp_path / "other", tmp_path / "cache 2")
    _add(folder, other, workers=2)
    for path in sorted(target.library.rglob("*.*")):
        twin = other.library / path.relative_to(target.library)
        assert path.read_bytes() == twin.read_bytes()


def test_two_of_one_name_get_two_ids(tmp_path, target):
    for number, edge in enumerate((0.03, 0.05)):
        obj_folder(tmp_path / "set" / str(number), box((0.1, 0.06, edge)))
    outcomes = _add(tmp_path / "set", target, order=ImportOptions("obj"))
    ids = sorted(outcome.detail for outcome in outcomes.values())
    assert ids[0] == "own_model"
    assert ids[1].startswith("own_model_")


def test_the_same_files_twice_are_one_object(tmp_path, target):
    for name in ("One", "Two"):
        gso_folder(tmp_path / "set" / name)
    outcomes = _add(tmp_path / "set", target, order=ImportOptions("gso"))
    assert sorted(outcome.status for outcome in outcomes.values()) == ["added", "skipped"]


def test_a_mesh_survives_being_written(tmp_path):
    path = write_glb(tmp_path / "x.glb", textured(box()))
    mesh = load_glb(path)
    (tmp_path / "y.glb").write_bytes(glb_bytes(mesh, "MIT"))
    back = load_glb(tmp_path / "y.glb")
    assert back.digest() == mesh.digest()


def test_a_library_that_cant_be_written_stays_as_it_was(tmp_path, target):
    write_glb(tmp_path / "x.glb", textured(box()))
    (source,) = find_sources(tmp_path / "x.glb", ORDER)
    mesh, entry = normalised(source, ORDER)
    target.library.write_text("a file, no folder")
    with pytest.raises(OutputFailed, match="library"):
        store_object(target.library, entry, glb_bytes(mesh))
    assert target.library.read_text() == "a file, no folder"


def test_a_taken_id_is_not_overwritten(tmp_path, target):
    write_glb(tmp_path / "x.glb", textured(box()))
    (source,) = find_sources(tmp_path / "x.glb", ORDER)
    mesh, entry = normalised(source, ORDER)
    store_object(target.library, entry, glb_bytes(mesh))
    with pytest.raises(OutputFailed):
        store_object(target.library, entry, b"other")
    assert [home.name for home in target.library.iterdir()] == [entry.id]
    assert (target.library / entry.id / MESH).read_bytes() != b"other"


def test_a_broken_library_says_what_to_do(tmp_path, target):
    _add(_three(tmp_path / "set"), target)
    cache = Cache(tmp_path / "fresh")
    (target.library / "own_red_box" / MESH).unlink()
    with pytest.raises(BadMesh, match="own_red_box.*add it again"):
        own_body("own_red_box", target.library, cache)
    with pytest.raises(UnknownName, match="own_none"):
        own_body("own_none", target.library, cache)
    (target.library / "own_red_box" / "entry.json").write_text("{")
    with pytest.raises(BadData, match=r"own_red_box/entry\.json"):
        own_entries(target.library)


def test_no_library_is_told(tmp_path):
    with pytest.raises(BadData, match="PROBE_LIBRARY"):
        open_library("own", None, tmp_path, None)
    with pytest.raises(BadData, match="probe assets add"):
        open_library("own", None, tmp_path, tmp_path / "none")


def test_a_thousand_entries_load_in_a_second(tmp_path, target):
    write_glb(tmp_path / "x.glb", textured(box()))
    (source,) = find_sources(tmp_path / "x.glb", ORDER)
    entry = normalised(source, ORDER)[1]
    for number in range(1000):
        home = target.library / f"own_{number}"
        home.mkdir(parents=True)
        named = entry.model_copy(update={"id": home.name})
        (home / "entry.json").write_text(named.model_dump_json())
    start = time.perf_counter()
    assert len(open_library("own", None, target.cache, target.library).specs) == 1000
    assert time.perf_counter() - start < 1.0
