"""Spoiled files of every kind are refused: file and reason named, in little time and memory."""

from __future__ import annotations

import io
import json
import re
import struct
import time
import zlib

import numpy as np
import psutil
import pytest
import trimesh
from PIL import Image

from data_sets import MTL, bop_set, box, gso_folder, obj_folder, obj_text, picture, ply_bytes
from glb_files import raw_glb, textured, triangle_tree, write_glb
from probe.assets.importers.adding import find_sources
from probe.assets.importers.normalised import content_of, normalised
from probe.assets.importers.options import ImportOptions
from probe.errors import BadData, BadMesh

SECONDS = 5.0
MEGABYTES = 400


def _png(width: int, height: int) -> bytes:
    """A PNG whose header claims a size that its few bytes don't hold."""
    head = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    chunks = b""
    for kind, content in ((b"IHDR", head), (b"IDAT", zlib.compress(b"\0" * 64)), (b"IEND", b"")):
        check = struct.pack(">I", zlib.crc32(kind + content))
        chunks += struct.pack(">I", len(content)) + kind + content + check
    return b"\x89PNG\r\n\x1a\n" + chunks


def _triangle(png: bytes | None = None) -> bytes:
    if png is None:
        buffer = io.BytesIO()
        Image.new("RGB", (4, 4)).save(buffer, "PNG")
        png = buffer.getvalue()
    positions = np.array([(0, 0, 0), (0.1, 0, 0), (0, 0.1, 0)], "<f4").tobytes()
    return positions + np.array([(0, 0), (1, 0), (0, 1)], "<f4").tobytes() + png


def _glb(**changes: object) -> bytes:
    blob = _triangle()
    return raw_glb(triangle_tree(blob, **changes), blob)


def _pictured(png: bytes) -> bytes:
    blob = _triangle(png)
    return raw_glb(triangle_tree(blob), blob)


def _whole(folder) -> bytes:
    return write_glb(folder / "x.glb", textured(box())).read_bytes()


def _scaled(scale: list[float]) -> bytes:
    return _glb(nodes=[{"mesh": 0, "scale": scale}])


GLB = {
    "empty": (lambda _: b"", "is empty"),
    "truncated": (lambda folder: _whole(folder)[:-200], "truncated"),
    "no glb": (lambda _: b"solid cube\nfacet normal 0 0 0\n", "no GLB"),
    "millimetres": (
        lambda folder: write_glb(folder / "x.glb", textured(box().apply_scale(1000))).read_bytes(),
        "100 m.*millimetres",
    ),
    "no uv": (
        lambda _: _glb(meshes=[{"primitives": [{"attributes": {"POSITION": 0}, "material": 0}]}]),
        "no texture coordinates|no base colour",
    ),
    "no texture": (lambda _: _glb(materials=[{}]), "no base colour texture"),
    "40 million": (
        lambda _: _glb(
            accessors=[
                {"bufferView": 0, "componentType": 5126, "count": 120_000_000, "type": "VEC3"}
            ]
            * 2
        ),
        "40,000,000 triangles",
    ),
    "values": (
        lambda _: _glb(
            accessors=[
                {"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"},
                {"bufferView": 1, "componentType": 5126, "count": 3, "type": "VEC2"},
                {"componentType": 5126, "count": 10**12, "type": "MAT4"},
            ]
        ),
        "claim 1,000,000,000,006 values",
    ),
    "cycle": (
        lambda _: _glb(nodes=[{"mesh": 0, "children": [1]}, {"children": [0]}]),
        "run in a circle",
    ),
    "own child": (lambda _: _glb(nodes=[{"mesh": 0, "children": [0]}]), "run in a circle"),
    "two parents": (
        lambda _: _glb(nodes=[{"children": [2]}, {"children": [2]}, {"mesh": 0}]),
        "node 2 has two parents",
    ),
    "no such child": (lambda _: _glb(nodes=[{"mesh": 0, "children": [7]}]), "malformed"),
    "negative child": (lambda _: _glb(nodes=[{"mesh": 0, "children": [-1]}]), "malformed"),
    "absurd scale": (lambda _: _scaled([1e30, 1e30, 1e30]), "A scale in it is wrong"),
    "infinite scale": (lambda _: _scaled([1e300, 1e300, 1e300]), "NaN or infinite|overflow"),
    "no scale": (lambda _: _scaled([0, 0, 0]), "no area"),
    "texture bomb": (
        lambda _: raw_glb(
            triangle_tree(_triangle(_png(60_000, 60_000))), _triangle(_png(60_000, 60_000))
        ),
        "too large|60000 x 60000",
    ),
    "wide texture": (
        lambda _: _pictured(_png(9_000, 16)),
        "9000 x 16",
    ),
    "no picture": (
        lambda _: _pictured(b"GIF89a"),
        "damaged or of an unknown kind",
    ),
    "outside": (lambda _: _glb(buffers=[{"byteLength": 60, "uri": "../x.bin"}]), "outside its own"),
    "absolute": (lambda _: _glb(images=[{"uri": "/etc/passwd"}]), "outside its own"),
    "escaped": (lambda _: _glb(images=[{"uri": "%2e%2e/x.png"}]), "outside its own"),
    "missing": (lambda _: _glb(images=[{"uri": "none.png"}]), "isn't there"),
    "flat": (lambda _: _glb(), "is flat"),
    "a picture before the first": (
        lambda _: _glb(textures=[{"source": -1}]),
        r"textures.0.source is -1, but it has 1 images",
    ),
    "a mesh after the last": (lambda _: _glb(nodes=[{"mesh": 1}]), "nodes.0.mesh is 1, but"),
    "a texture before the first": (
        lambda _: _glb(materials=[{"pbrMetallicRoughness": {"baseColorTexture": {"index": -1}}}]),
        "materials.0.baseColorTexture is -1, but it has 1 textures",
    ),
    "a scene before the first": (lambda _: _glb(scene=-1), "scene is -1, but it has 1 scenes"),
    "a length below nothing": (
        lambda _: _glb(buffers=[{"byteLength": -5}]),
        "buffers.0.byteLength is -5",
    ),
    "no rotation": (
        lambda _: _glb(nodes=[{"mesh": 0, "rotation": [0, 0, 0, 0]}]),
        "nodes.0.rotation is no rotation",
    ),
    "non-manifold crumbs": (
        lambda folder: write_glb(
            folder / "x.glb", textured(trimesh.creation.box((1e-9, 1e-9, 1e-9)))
        ).read_bytes(),
        "metres taken for millimetres|no area",
    ),
}


def _refused(path, order, reason) -> None:
    """One object, refused by name with a reason, within bounds."""
    memory = psutil.Process().memory_info
    before, start = memory().rss, time.perf_counter()
    (source,) = find_sources(path, order)
    with pytest.raises((BadMesh, BadData)) as refusal:
        content_of(source, order)
        normalised(source, order)
    assert time.perf_counter() - start < SECONDS
    assert memory().rss - before < MEGABYTES * 2**20
    message = str(refusal.value)
    assert str(path) in message
    assert re.search(reason, message), message


@pytest.mark.parametrize("kind", sorted(GLB))
def test_a_spoiled_glb(tmp_path, kind):
    make, reason = GLB[kind]
    content = make(tmp_path)
    (tmp_path / "x.glb").write_bytes(content)
    _refused(tmp_path, ImportOptions("gltf"), reason)


def test_a_gltf_beside_its_files_is_read_and_a_link_out_of_its_folder_refused(tmp_path):
    blob = _triangle()
    tree = triangle_tree(blob, buffers=[{"byteLength": len(blob), "uri": "x.bin"}])
    home = tmp_path / "set"
    home.mkdir()
    (home / "x.gltf").write_text(json.dumps(tree))
    (home / "x.bin").write_bytes(blob)
    _refused(home, ImportOptions("gltf"), "is flat")
    (home / "x.bin").rename(tmp_path / "x.bin")
    (home / "x.bin").symlink_to(tmp_path / "x.bin")
    _refused(home, ImportOptions("gltf"), "outside its own")


def _obj(text: str | None = None, mtl: str = MTL):
    def write(folder):
        path = obj_folder(folder, mtl=mtl)
        if text is not None:
            path.write_text(text)

    return write


def _bare(text: str | None = None, mtl: str = MTL):
    """As `_obj`, with no picture beside it that might stand in."""

    def write(folder):
        _obj(text, mtl)(folder)
        (folder / "texture.png").unlink()

    return write


def _lines(change) -> str:
    return change(obj_text(box()))


OBJ = {
    "empty": (_obj(""), "is empty"),
    "binary": (_obj("v 0 0 0\0"), "is no text"),
    "points": (_obj("mtllib model.mtl\nv 0 0 0\nv 1 0 0\n"), "no triangles"),
    "cut in a face": (_obj(_lines(lambda t: t[: t.rfind(" ")])), "truncated"),
    "fewer than stated": (_obj("# Vertices: 9\n" + obj_text(box())), "truncated: 8 of 9 vertices"),
    "nan": (_obj(_lines(lambda t: t.replace("v 0.35", "v nan", 1))), "NaN|parsed"),
    "no such vertex": (
        _obj(obj_text(box()) + "f 1/1 2/2 900/3\n"),
        r"line \d+ names vertex 900 of 8",
    ),
    "vertex 0": (_obj(obj_text(box()) + "f 1/1 0/2 3/3\n"), r"line \d+ names vertex 0 of 8"),
    "uv 0": (
        _obj(obj_text(box()) + "f 1/1 2/0 3/3\n"),
        r"line \d+ names texture coordinate 0 of",
    ),
    "a vertex too far back": (_obj(obj_text(box()) + "f -9 -1 -2\n"), "names vertex -9 of 8"),
    "no uv": (_obj(re.sub(r"/\d", "", obj_text(box()))), "no texture coordinates|no base"),
    "no library": (
        _bare(_lines(lambda t: t.replace("mtllib model.mtl\n", ""))),
        "names no material",
    ),
    "missing library": (_bare(obj_text(box(), "none.mtl")), "'none.mtl', which isn't there"),
    "library outside": (_obj(obj_text(box(), "../../model.mtl")), "outside its own folder"),
    "wrong material": (
        _obj(obj_text(box(), material="hide")),
        "'hide', but model.mtl defines skin",
    ),
    "texture outside": (_obj(mtl=MTL.replace("texture", "../../x")), "outside its own folder"),
    "texture elsewhere": (_obj(mtl=MTL.replace("texture", "/etc/x")), "outside its own folder"),
    "windows path": (_obj(mtl=MTL.replace("texture", "C:\\x")), "outside its own folder"),
    "missing texture": (_bare(mtl=MTL.replace("texture", "none")), "'none.png', which isn't there"),
    "no texture": (_obj(mtl="newmtl skin\nKd 1 0 0\n"), "no base colour texture"),
    "millimetres": (_obj(obj_text(box().apply_scale(1000))), "100 m.*millimetres"),
}


@pytest.mark.parametrize("kind", sorted(OBJ))
def test_a_spoiled_obj(tmp_path, kind):
    write, reason = OBJ[kind]
    write(tmp_path / "set")
    _refused(tmp_path / "set", ImportOptions("obj"), reason)


def test_an_obj_of_too_many_faces_is_refused_before_it_is_parsed(tmp_path):
    path = obj_folder(tmp_path / "set")
    path.write_text(obj_text(box()) + "f 1/1 2/2 3/3\n" * 2_000_001)
    _refused(tmp_path / "set", ImportOptions("obj"), "2,000,013 faces")


def test_a_texture_bomb_in_an_obj(tmp_path):
    obj_folder(tmp_path / "set")
    (tmp_path / "set" / "texture.png").write_bytes(_png(60_000, 60_000))
    _refused(tmp_path / "set", ImportOptions("obj"), r"texture\.png.*(too large|60000)")


def test_a_texture_that_links_out_of_its_folder(tmp_path):
    gso_folder(tmp_path / "Box")
    texture = tmp_path / "Box" / "materials" / "textures" / "texture.png"
    texture.rename(tmp_path / "texture.png")
    texture.symlink_to(tmp_path / "texture.png")
    _refused(tmp_path / "Box", ImportOptions("gso"), "outside its own folder")


@pytest.mark.parametrize(
    ("before", "after", "reason"),
    [
        ("<sdf", "<sd", "is no XML"),
        ("model://Box/meshes/model.obj", "../../x.obj", "outside its own folder"),
        ("model://Box/meshes/model.obj", "model://Box/meshes/none.obj", "isn't there"),
        ("0.25", "heavy", "mass is no number"),
        ("0.25", "nan", "mass is nan"),
        ("0.25", "9", "weighs 9.00 kg"),
        ('<?xml version="1.0"?>', '<!DOCTYPE a [<!ENTITY b "c">]>', "defines entities"),
    ],
)
def test_a_spoiled_gazebo_folder(tmp_path, before, after, reason):
    path = gso_folder(tmp_path / "Box") / "model.sdf"
    text = path.read_text()
    assert before in text
    path.write_text(text.replace(before, after))
    _refused(tmp_path / "Box", ImportOptions("gso"), reason)


@pytest.mark.parametrize(
    ("change", "reason"),
    [
        (lambda ply: b"", "is empty"),
        (lambda ply: ply[: len(ply) // 2], "truncated"),
        (lambda ply: b"glTF" + ply, "no PLY file"),
        (lambda ply: ply.replace(b"face 12", b"face 40000000"), "40,000,000 triangles"),
        (lambda ply: ply.replace(b"vertex 8", b"vertex 900000000"), "900,000,000 vertices"),
        (lambda ply: ply.replace(b"comment Tex", b"comment Nex"), "names no texture"),
        (lambda ply: ply.replace(b"obj_000001.png", b"../x.png"), "outside its own folder"),
        (lambda ply: ply.replace(b"texture_u", b"quality_u"), "no texture coordinates"),
        (lambda ply: ply.replace(b"350.00000", b"nan", 1), "NaN"),
        (lambda ply: ply_bytes(box()), "metres taken for millimetres|data set says"),
    ],
)
def test_a_spoiled_model_of_a_set(tmp_path, change, reason):
    folder = bop_set(tmp_path / "set")
    path = folder / "toy" / "models" / "obj_000001.ply"
    path.write_bytes(change(path.read_bytes()))
    _refused(folder, ImportOptions("bop"), reason)


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ("{}", "says nothing of it"),
        ("[", "models_info.json: the file"),
        ('{"1": {"size_x": -1, "size_y": 1, "size_z": 1}}', "size_x"),
        ('{"1": {"size_x": 100, "size_y": 60, "size_z": 400}}', "data set says 10.0 x 6.0 x 40.0"),
        (
            '{"1": {"size_x": 100, "size_y": 60, "size_z": 40, "symmetries_discrete": [[1, 2]]}}',
            "symmetries_discrete",
        ),
    ],
)
def test_a_spoiled_list_of_models(tmp_path, text, reason):
    folder = bop_set(tmp_path / "set")
    (folder / "toy" / "models" / "models_info.json").write_text(text)
    _refused(folder, ImportOptions("bop"), reason)


def test_non_manifold_meshes_are_fine(tmp_path):
    torn = box()
    torn.update_faces(np.arange(len(torn.faces)) > 2)
    doubled = torn + box((0.08, 0.02, 0.02))
    obj_folder(tmp_path / "set", doubled)
    (source,) = find_sources(tmp_path / "set", ImportOptions("obj"))
    mesh, _ = normalised(source, ImportOptions("obj", up="z"))
    assert len(mesh.faces) == 21


def test_a_picture_of_the_right_size_passes(tmp_path):
    obj_folder(tmp_path / "set")
    picture(tmp_path / "set" / "texture.png", (10, 200, 30))
    (source,) = find_sources(tmp_path / "set", ImportOptions("obj"))
    assert normalised(source, ImportOptions("obj"))[1].colours[0] == "green"
