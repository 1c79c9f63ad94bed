"""Near-duplicates among objects of one's own, and when they are looked for anew."""

from __future__ import annotations

import pytest

from data_sets import box
from glb_files import textured, write_glb
from probe.api.resources import everything
from probe.assets.gltf.glb import glb_bytes
from probe.assets.importers.adding import find_sources
from probe.assets.importers.normalised import normalised
from probe.assets.importers.options import ImportOptions
from probe.assets.library import Library, open_library
from probe.assets.mesh.fingerprint import fingerprint
from probe.assets.pools.own import remove_object, store_object
from probe.cli.near_duplicates import near_groups, those_here
from probe.errors import BadData
from probe.tasks.suite import Suite

BRICK, TRAY = (0.1, 0.06, 0.04), (0.2, 0.05, 0.02)


def put(home, name, size):
    """Make a box one of the user's own objects, in the place of another of its name."""
    path = home / f"{name}.glb"
    write_glb(path, textured(box(size)))
    (source,) = find_sources(path, ImportOptions("gltf"))
    mesh, entry = normalised(source, ImportOptions("gltf"))
    remove_object(home / "own", entry.id)
    store_object(home / "own", entry, glb_bytes(mesh))
    return entry.id


def opened(home):
    return open_library("own", None, home / "cache", home / "own")


def looks(home, *ids):
    return {id: fingerprint(opened(home).body(id)) for id in ids}


def groups(home, *shown):
    return near_groups(shown, opened(home), home / "near", 1)


@pytest.fixture
def three(tmp_path):
    """A brick, its copy and a tray."""
    sizes = {"brick": BRICK, "copy": BRICK, "tray": TRAY}
    return [put(tmp_path, name, size) for name, size in sizes.items()]


def test_they_are_found_between_what_is_collected_and_what_is_evaluated(tmp_path, three):
    brick, copy, tray = three
    assert groups(tmp_path, looks(tmp_path, brick), looks(tmp_path, tray)) == []
    assert groups(tmp_path, looks(tmp_path, brick, tray), looks(tmp_path, copy)) == [[brick, copy]]


@pytest.mark.parametrize("place", ["first", "last"])
def test_an_object_that_changed_under_its_id_is_compared_again(tmp_path, three, place):
    brick, _, tray = three
    apart = looks(tmp_path, brick), looks(tmp_path, tray)
    assert groups(tmp_path, *apart) == []
    put(tmp_path, "tray", BRICK)
    changed = looks(tmp_path, tray)
    shown = (changed, apart[0]) if place == "first" else (apart[0], changed)
    assert groups(tmp_path, *shown) == [[brick, tray]]
    # What was found before is known still, without any object.
    assert near_groups(apart, Library((), None, tmp_path), tmp_path / "near", 1) == []


def test_one_that_is_not_here_is_told(tmp_path, three):
    shown = {**looks(tmp_path, three[0]), "gso_gone": (1.0,), "own_gone": (1.0,)}
    words = r"gso_gone: appears \(and 1 more\), but isn't here .*PROBE_ASSETS .*PROBE_LIBRARY"
    with pytest.raises(BadData, match=words):
        groups(tmp_path, shown)


def test_everything_that_is_there_is_opened_for_suites_too(tmp_path, three, monkeypatch):
    monkeypatch.setenv("PROBE_LIBRARY", str(tmp_path / "own"))
    things = everything()
    known = {spec.id for spec in things.specs}
    assert set(three) < known and "proc_white_egg_cup" in known
    assert len(things.body(three[0]).pieces) > 0
    monkeypatch.setenv("PROBE_LIBRARY", str(tmp_path / "nowhere"))
    assert {spec.id for spec in everything().specs} == known - set(three)


def test_suites_whose_objects_are_elsewhere_are_named(tmp_path, three, capsys):
    brick, copy, _ = three
    marks = looks(tmp_path, brick, copy)
    here = Suite("here", (), marks)
    away = Suite("away", (), {**marks, "scan_of_a_bowl": marks[brick]})
    assert those_here([here, away], opened(tmp_path)) == [here]
    assert "1 objects of away aren't here" in capsys.readouterr().out
