from __future__ import annotations

from dataclasses import replace

from hypothesis import given
from hypothesis import strategies as st

from probe.assets.library import Library
from probe.generation.cover_shape import CoverShape, packed, shape_of, shape_recipe, unpacked

numbers = st.tuples(*[st.floats(allow_nan=False)] * 11)


@given(st.builds(CoverShape, numbers, st.booleans()) | st.none())
def test_every_digit_of_a_shape_is_kept(shape):
    assert unpacked(packed(shape)) == shape


def test_what_is_of_no_use_as_a_cover_has_no_shape(library: Library):
    banana, book = (library[f"proc_{name}"] for name in ("banana", "blue_paperback"))
    assert shape_of(banana, library.body(banana.id).mesh) is None
    assert shape_of(book, library.body(book.id).mesh) is not None


def test_whether_a_thing_is_hollow_decides_its_shape_and_so_its_recipe(library: Library):
    mug = library["proc_red_mug"]
    mesh, solid = library.body(mug.id).mesh, replace(mug, hollow=False)
    assert shape_recipe(mug) != shape_recipe(solid)
    assert shape_of(mug, mesh) != shape_of(solid, mesh)
    assert shape_recipe(mug) == shape_recipe(replace(mug, description="Another."))
