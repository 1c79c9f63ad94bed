"""Words that models and people found reach the library's entries, and nothing else does."""

import pytest

from data_sets import box
from glb_files import textured, write_glb
from probe.assets.annotation.applying import apply_notes
from probe.assets.annotation.notes import from_source, said
from probe.assets.annotation.words import Described
from probe.assets.glb_writer import glb_bytes
from probe.assets.importers.adding import find_sources
from probe.assets.importers.normalised import normalised
from probe.assets.importers.order import Order
from probe.assets.own_pool import own_entries, store_object

WORDS = Described(name="tea tin", category="tin", colours=("green",), description="A green tin.")


@pytest.fixture
def library(tmp_path):
    write_glb(tmp_path / "x.glb", textured(box()))
    (source,) = find_sources(tmp_path / "x.glb", Order("gltf"))
    mesh, entry = normalised(source, Order("gltf"))
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
