"""Words that models and people found reach the library's entries, and nothing else does."""

import pytest
import trimesh

from data_sets import box, obj_folder
from glb_files import textured, write_glb
from probe.assets.annotation.applying import apply_notes
from probe.assets.annotation.notes import changed_by_hand, from_entry, from_source, said
from probe.assets.annotation.words import Described
from probe.assets.gltf.glb import glb_bytes, load_glb
from probe.assets.importers.adding import find_sources
from probe.assets.importers.normalised import normalised
from probe.assets.importers.options import ImportOptions
from probe.assets.pools.own import MESH, own_entries, store_object

WORDS = Described(name="tea tin", category="tin", colours=("green",), description="A green tin.")


@pytest.fixture
def library(tmp_path):
    write_glb(tmp_path / "x.glb", textured(box()))
    (source,) = find_sources(tmp_path / "x.glb", ImportOptions("gltf"))
    mesh, entry = normalised(source, ImportOptions("gltf"))
    store_object(tmp_path / "own", entry, glb_bytes(mesh))
    return tmp_path / "own"


def test_a_models_words_go_in_with_who_said_them(library):
    (before,) = own_entries(library)
    note = said(from_source(before.spec), WORDS, "model")
    assert apply_notes(library, [note]) == 1
    (after,) = own_entries(library)
    assert (after.name, after.category, after.colours) == ("tea tin", "tin", ("green",))
    assert {after.provenance[field] for field in ("name", "description")} == {"model"}
    same = {"name", "category", "colours", "description", "provenance"}
    assert after.model_dump(exclude=same) == before.model_dump(exclude=same)
    assert apply_notes(library, [note]) == 0


def test_what_nobody_said_and_other_objects_are_left(library):
    (before,) = own_entries(library)
    note = from_source(before.spec)
    other = said(note, WORDS, "human").model_copy(update={"id": "own_elsewhere"})
    assert apply_notes(library, [note, other]) == 0
    assert own_entries(library) == (before,)


def test_a_mass_and_an_axis_said_by_hand_change_the_object(tmp_path):
    obj_folder(tmp_path / "tin", trimesh.creation.box((0.1, 0.06, 0.04)))
    (source,) = find_sources(tmp_path / "tin", ImportOptions("obj"))
    mesh, entry = normalised(source, ImportOptions("obj"))
    store_object(tmp_path / "own", entry, glb_bytes(mesh))
    note = from_entry(entry)
    assert (note.up, note.other_up) == ("y", "z")
    said_so = changed_by_hand(note, {"up": "z", "mass": 0.2})
    assert apply_notes(tmp_path / "own", [said_so]) == 1
    (after,) = own_entries(tmp_path / "own")
    assert (after.up, after.up_sure, after.mass) == ("z", True, 0.2)
    assert after.size == pytest.approx((0.1, 0.06, 0.04))
    assert load_glb(tmp_path / "own" / after.id / MESH).extent == pytest.approx(
        after.size, abs=1e-5
    )
    assert (after.provenance["up"], after.provenance["mass"]) == ("human", "human")
    assert apply_notes(tmp_path / "own", [said_so]) == 0
    assert [home.name for home in (tmp_path / "own").iterdir()] == [after.id]
