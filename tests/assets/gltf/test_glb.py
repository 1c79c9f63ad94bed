from __future__ import annotations

import io
import re
from pathlib import Path

import numpy as np
import pytest
import trimesh
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from PIL import Image

from glb_files import box_glb, raw_glb, textured, triangle_tree, write_glb
from probe.assets.gltf.glb import load_glb, measure_glb
from probe.errors import BadMesh

EDGE = st.floats(0.01, 0.5)
SHIFT = st.floats(-1.0, 1.0)


def _triangle(
    positions: object = ((0, 0, 0), (0.1, 0, 0), (0, 0.1, 0)),
    uvs: object = ((0, 0), (1, 0), (0, 1)),
) -> bytes:
    png = io.BytesIO()
    Image.new("RGB", (4, 4), (10, 200, 30)).save(png, "PNG")
    floats = np.asarray(positions, "<f4").tobytes() + np.asarray(uvs, "<f4").tobytes()
    return floats + png.getvalue()


def _write(path: Path, content: bytes) -> Path:
    path.write_bytes(content)
    return path


@given(edges=st.tuples(EDGE, EDGE, EDGE), shift=st.tuples(SHIFT, SHIFT, SHIFT))
@settings(max_examples=20, suppress_health_check=[HealthCheck.function_scoped_fixture])
def test_a_mesh_rests_on_the_table_over_the_origin(tmp_path, edges, shift):
    box = trimesh.creation.box(edges).apply_translation(shift)
    mesh = load_glb(write_glb(tmp_path / "box.glb", textured(box)))
    low, high = mesh.vertices.min(axis=0), mesh.vertices.max(axis=0)
    assert low[2] == pytest.approx(0, abs=1e-6)
    assert (low + high)[:2] == pytest.approx([0, 0], abs=1e-6)
    assert mesh.extent == pytest.approx(edges, abs=1e-5)


@pytest.mark.parametrize(
    ("up", "extent"),
    [
        ((0, 0, 0), (0.1, 0.06, 0.04)),
        ((90, 0, 0), (0.1, 0.04, 0.06)),
        ((0, 90, 0), (0.04, 0.06, 0.1)),
        ((0, 0, 90), (0.06, 0.1, 0.04)),
        # About x first, then about the fixed z.
        ((90, 0, 90), (0.04, 0.1, 0.06)),
    ],
)
def test_up_turns_about_fixed_axes(tmp_path, up, extent):
    path = box_glb(tmp_path / "box.glb")
    assert load_glb(path, up).extent == pytest.approx(extent, abs=1e-6)
    assert measure_glb(path, up) == pytest.approx(extent, abs=1e-6)


def test_turning_keeps_handedness(tmp_path):
    cone = textured(trimesh.creation.cone(0.03, 0.1))
    mesh = load_glb(write_glb(tmp_path / "cone.glb", cone), (90, 0, 0))
    # The tip points up along z; a right-handed quarter turn about x takes +z to -y.
    tip = mesh.vertices[np.argmin(mesh.vertices[:, 1])]
    assert np.ptp(mesh.vertices[:, 1]) == pytest.approx(0.1, abs=1e-6)
    assert tip[0] == pytest.approx(0, abs=1e-6)


def test_uvs_count_from_the_top_left_as_in_the_file(tmp_path):
    blob = _triangle(uvs=((0.1, 0.2), (0.9, 0.2), (0.1, 0.7)))
    mesh = load_glb(_write(tmp_path / "t.glb", raw_glb(triangle_tree(blob), blob)))
    # glTF, too, has (0, 0) at the top left: "Meshes", figure "Texture Coordinates".
    ordered = np.array(sorted(mesh.uvs.tolist()))
    assert ordered == pytest.approx(np.array([(0.1, 0.2), (0.1, 0.7), (0.9, 0.2)]), abs=1e-6)
    # x stays, the file's y is our z.
    lowest = mesh.vertices[np.argmin(mesh.uvs.sum(axis=1))]
    highest = mesh.vertices[np.argmax(mesh.uvs[:, 1])]
    assert highest - lowest == pytest.approx([0, 0, 0.1], abs=1e-6)
    assert mesh.surface.texture[0, 0].tolist() == [10, 200, 30]


def test_two_materials_become_one_atlas(tmp_path):
    red = textured(trimesh.creation.box((0.05, 0.05, 0.05)), (200, 30, 30))
    blue = textured(trimesh.creation.box((0.05, 0.05, 0.05)), (20, 40, 210))
    mesh = load_glb(
        write_glb(tmp_path / "two.glb", red, blue.apply_translation([0.2, 0, 0])),
    )
    height, width = mesh.surface.texture.shape[:2]
    pixel = np.clip((mesh.uvs % 1.0) * [width, height], 0, [width - 1, height - 1]).astype(int)
    colour = mesh.surface.texture[pixel[:, 1], pixel[:, 0]]
    assert (np.abs(colour[mesh.vertices[:, 0] < 0].astype(int) - [200, 30, 30]) < 12).all()
    assert (np.abs(colour[mesh.vertices[:, 0] > 0].astype(int) - [20, 40, 210]) < 12).all()


def _bad_files() -> dict[str, tuple[bytes, str]]:
    blob = _triangle()
    whole = raw_glb(triangle_tree(blob), blob)
    nan = _triangle(positions=((0, 0, 0), (np.nan, 0, 0), (0, 0.1, 0)))
    flat = _triangle(positions=((0, 0, 0), (0.1, 0, 0), (0.2, 0, 0)))
    huge = _triangle(positions=((0, 0, 0), (100, 0, 0), (0, 60, 0)))
    tiny = _triangle(positions=((0, 0, 0), (1e-4, 0, 0), (0, 1e-4, 0)))
    bare = {"primitives": [{"attributes": {"POSITION": 0}}]}
    plain = {"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1}}]}
    many = [{"bufferView": 0, "componentType": 5126, "count": 9_000_000, "type": "VEC3"}]
    broken_png = blob[:70] + b"\0" * (len(blob) - 70)
    outside = [{"byteLength": 60, "uri": "../../../etc/passwd"}]
    web = [{"uri": "https://example.org/a.png"}]
    return {
        "empty": (b"", "is empty"),
        "text": (b"solid cube\nfacet normal 0 0 0\n", "no GLB"),
        "short": (b"glTF\x02\0\0\0", "no GLB"),
        "truncated": (whole[: len(whole) - 40], "truncated"),
        "version": (whole[:4] + b"\x01" + whole[5:], "version 1"),
        "garbled": (whole[:22] + b"\xff\xfe" + whole[24:], "damaged"),
        "list": (raw_glb([1, 2]), "no glTF tree"),
        "no mesh": (raw_glb({"asset": {"version": "2.0"}}), "parsed|no triangles"),
        "nan": (raw_glb(triangle_tree(nan), nan), "NaN"),
        "flat": (raw_glb(triangle_tree(flat), flat), "no area"),
        "huge": (raw_glb(triangle_tree(huge), huge), r"100 m.*scale it by 0\.001"),
        "tiny": (raw_glb(triangle_tree(tiny), tiny), "0.1 mm.*scale"),
        "no uvs": (raw_glb(triangle_tree(blob, meshes=[bare]), blob), "texture"),
        "no texture": (raw_glb(triangle_tree(blob, meshes=[plain]), blob), "texture"),
        "many": (raw_glb(triangle_tree(blob, accessors=many * 2), blob), "9,000,000.*Decimate"),
        "negative": (raw_glb(triangle_tree(blob, accessors=[]), blob), "malformed"),
        "bad png": (raw_glb(triangle_tree(broken_png), broken_png), "texture|parsed"),
        "outside": (raw_glb(triangle_tree(blob, buffers=outside), blob), "outside its own"),
        "web": (raw_glb(triangle_tree(blob, images=web), blob), "outside its own"),
        "draco": (
            raw_glb(triangle_tree(blob, extensionsRequired=["KHR_draco_mesh_compression"]), blob),
            "KHR_draco_mesh_compression",
        ),
    }


@pytest.mark.parametrize("kind", sorted(_bad_files()))
def test_a_bad_file_is_refused_with_its_name_and_a_remedy(tmp_path, kind):
    content, pattern = _bad_files()[kind]
    path = _write(tmp_path / "thing.glb", content)
    with pytest.raises(BadMesh) as refusal:
        load_glb(path)
    message = str(refusal.value)
    assert message.startswith(str(path))
    assert re.search(pattern, message)


def test_a_missing_file_is_refused(tmp_path):
    with pytest.raises(BadMesh, match="No such file"):
        load_glb(tmp_path / "none.glb")


@given(place=st.integers(0, 400), value=st.integers(0, 255))
@settings(max_examples=60, suppress_health_check=[HealthCheck.function_scoped_fixture])
def test_one_wrong_byte_never_ends_in_another_error(tmp_path, place, value):
    blob = _triangle()
    content = bytearray(raw_glb(triangle_tree(blob), blob))
    content[place] = value
    path = _write(tmp_path / "noisy.glb", bytes(content))
    try:
        load_glb(path)
    except BadMesh as refusal:
        assert str(path) in str(refusal)  # noqa: PT017


def test_all_scans_have_the_size_that_their_index_states(assets):
    import csv

    folder = assets / "scans"
    with (folder / "index.csv").open() as file:
        rows = list(csv.DictReader(file))[::12]
    for row in rows:
        size = [float(row[f"size_{axis}_m"]) for axis in "xyz"]
        assert measure_glb(folder / f"{row['id']}.glb") == pytest.approx(size, abs=3e-4)
