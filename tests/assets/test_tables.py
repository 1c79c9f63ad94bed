from __future__ import annotations

import numpy as np
import pytest
from PIL import Image

from probe.assets.cache import Cache
from probe.assets.tables import load_table, table_ids
from probe.assets.tabletops import tops
from probe.assets.tabletops.cloth import THREADS, Striped
from probe.assets.tabletops.noise import SIZE, normals_of
from probe.errors import BadData, UnknownName

PAINTED = tuple(tops())
ONE_OF_EACH = sorted({type(top): id for id, top in tops().items()}.values())
A_SHARE = [
    id if n % 4 == 0 else pytest.param(id, marks=pytest.mark.every_object)
    for n, id in enumerate(ONE_OF_EACH)
]
"""`every_object`: see tests/deciding.py."""


def _material(folder, name="Wood001", **maps):
    place = folder / "textures" / f"{name}_1K-JPG"
    place.mkdir(parents=True)
    for kind, colour in maps.items():
        Image.new("RGB", (16, 16), colour).save(place / f"{name}_1K-JPG_{kind}.jpg", quality=100)
    return place


def test_there_are_tables_without_assets():
    assert len(PAINTED) >= 108
    assert table_ids(None) == PAINTED


def test_bands_of_stripes_fill_a_repeat():
    for top in tops().values():
        if isinstance(top, Striped):
            assert sum(count for _, count in top.bands) == THREADS, top.id


@pytest.mark.slow
@pytest.mark.parametrize("id", A_SHARE)
def test_a_painted_table_repeats_without_a_seam(id):
    table = load_table(id, None)
    texture = table.texture.astype(int)
    assert texture.shape == (SIZE, SIZE, 3) and table.texture.dtype == np.uint8
    assert 0.05 <= table.tile_size <= 2 and 0 <= table.roughness <= 1
    for axis in (0, 1):
        step = np.abs(np.diff(texture, axis=axis)).mean(axis=(1 - axis, 2))
        seam = np.abs(texture.take(0, axis) - texture.take(-1, axis)).mean()
        # Joints between planks are as sharp as it gets.
        assert seam <= step.max() * 1.1 + 0.5
    assert 0.01 < np.percentile(texture, 99) / 255 <= 1


@pytest.mark.slow
@pytest.mark.parametrize("id", A_SHARE)
def test_a_table_in_use_repeats_without_a_seam(id):
    table = load_table(id, None, looks=2)
    texture = table.texture.astype(int)
    assert texture.shape[0] == texture.shape[1] >= SIZE
    assert table.normal is not None and table.normal.shape == texture.shape
    for axis in (0, 1):
        step = np.abs(np.diff(texture, axis=axis)).mean(axis=(1 - axis, 2))
        seam = np.abs(texture.take(0, axis) - texture.take(-1, axis)).mean()
        assert seam <= step.max() * 1.1 + 0.5


@pytest.mark.slow
@pytest.mark.parametrize("id", ["linen", "red_gingham", "green_tartan"])
def test_cloth_in_use_repeats_far_apart_and_has_the_same_threads(id):
    old, new = load_table(id, None), load_table(id, None, looks=2)
    assert old.tile_size < 0.3 <= 0.5 < new.tile_size
    assert new.tile_size / old.tile_size == pytest.approx(round(new.tile_size / old.tile_size))
    apart = new.texture.mean(axis=(0, 1)) - old.texture.mean(axis=(0, 1))
    assert np.abs(apart).max() < 16


def test_a_painted_table_is_the_same_each_time():
    first = load_table("slate", None)
    load_table.cache_clear()
    assert (load_table("slate", None).texture == first.texture).all()


def test_a_painted_table_comes_out_of_the_cache_as_it_was_painted(tmp_path):
    cache = Cache(tmp_path)
    painted = load_table("oak_planks", None)
    assert painted.normal is not None
    for _ in range(2):
        load_table.cache_clear()
        kept = load_table("oak_planks", None, cache)
        assert np.array_equal(kept.texture, painted.texture)
        assert kept.normal is not None and np.array_equal(kept.normal, painted.normal)
        numbers = (kept.id, kept.tile_size, kept.roughness, kept.metallic)
        assert numbers == (painted.id, painted.tile_size, painted.roughness, painted.metallic)
    (entry,) = tmp_path.rglob("*.npz")
    entry.write_bytes(entry.read_bytes()[:1000])
    load_table.cache_clear()
    again = load_table("oak_planks", None, cache)
    assert np.array_equal(again.texture, painted.texture)


def test_a_table_in_use_is_another_picture_of_the_same_table(tmp_path):
    cache = Cache(tmp_path)
    new, used = (load_table("oak_planks", None, cache, looks) for looks in (1, 2))
    assert new.roughness_map is None and used.roughness_map is not None
    assert np.ptp(used.roughness_map) > 20
    assert (used.texture != new.texture).any()
    apart = used.texture.mean(axis=(0, 1)) - new.texture.mean(axis=(0, 1))
    assert np.abs(apart).max() < 16
    load_table.cache_clear()
    kept = load_table("oak_planks", None, cache, 2)
    assert np.array_equal(kept.texture, used.texture)
    assert kept.roughness_map is not None
    assert np.array_equal(kept.roughness_map, used.roughness_map)


def test_a_slope_up_the_picture_is_green():
    rows = np.arange(SIZE)[:, None] * np.ones((1, SIZE))
    rising = normals_of(-0.001 * rows, texel=0.001)[500, 500].astype(int)
    # Height grows upwards in the picture, so the normal leans down: less green than flat.
    assert rising[0] == pytest.approx(128, abs=1)
    assert rising[1] < 64 and rising[2] > 190


def test_a_material_from_disk(tmp_path):
    _material(tmp_path, Color=(120, 80, 40), NormalGL=(128, 128, 255), Roughness=(102, 102, 102))
    assert table_ids(tmp_path) == (*PAINTED, "Wood001")
    table = load_table("Wood001", tmp_path)
    assert table.texture[3, 3] == pytest.approx([120, 80, 40], abs=3)
    assert table.roughness == pytest.approx(0.4, abs=0.01)
    assert table.normal is not None and table.tile_size == 0.8
    assert table.surface.texture is table.texture


def test_every_map_goes_to_the_surface(tmp_path):
    _material(
        tmp_path,
        "Metal9",
        Color=(90, 90, 90),
        NormalDX=(128, 100, 250),
        Roughness=(51, 51, 51),
        Metalness=(255, 255, 255),
    )
    surface = load_table("Metal9", tmp_path).surface
    assert surface.metallic == 1 and surface.roughness == pytest.approx(0.2, abs=0.01)
    assert surface.roughness_map is not None and surface.roughness_map.ndim == 2
    # DirectX's green points down: turned over it is OpenGL's.
    assert surface.normal is not None
    assert surface.normal[3, 3].astype(int) == pytest.approx([128, 155, 250], abs=3)


def test_maps_may_be_missing_but_not_the_colour(tmp_path):
    _material(tmp_path, "Odd01", Color=(1, 2, 3))
    bare = load_table("Odd01", tmp_path)
    assert bare.normal is None and bare.roughness_map is None
    assert bare.roughness == 0.6 and bare.metallic == 0
    _material(tmp_path, "Odd02", Roughness=(1, 2, 3))
    with pytest.raises(BadData, match="Odd02.*no colour map"):
        load_table("Odd02", tmp_path)


def test_a_broken_picture_is_named(tmp_path):
    place = _material(tmp_path, "Odd03")
    (place / "Odd03_1K-JPG_Color.jpg").write_bytes(b"\xff\xd8 no picture")
    with pytest.raises(BadData, match=r"Odd03_1K-JPG_Color\.jpg"):
        load_table("Odd03", tmp_path)


def test_an_unknown_table_is_refused(tmp_path):
    with pytest.raises(UnknownName, match="lava.*PROBE_ASSETS names"):
        load_table("lava", None)
    with pytest.raises(UnknownName, match=f"lava.*textures of {tmp_path}"):
        load_table("lava", tmp_path)


def test_all_materials_of_the_assets_load(assets):
    for id in table_ids(assets)[len(PAINTED) :]:
        table = load_table(id, assets)
        assert table.texture.ndim == 3 and table.normal is not None
