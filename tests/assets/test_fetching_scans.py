"""Scans from a server of our own that has them in the layouts of their public sources."""

from __future__ import annotations

import functools
import http.server
import io
import threading
import zipfile
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any, cast

import numpy as np
import pytest
import trimesh
from PIL import Image

from probe.assets.cache import Cache
from probe.assets.fetching.scan_manifest import ScanFile, ScanSource, scan_collections, scan_files
from probe.assets.fetching.suite_scans import ScanFetching, fetch_all, write_index
from probe.assets.folders import assets_folder
from probe.assets.gltf.glb import read_gltf
from probe.assets.library import Library, open_library
from probe.assets.mesh.fingerprint import Fingerprint
from probe.assets.pools.scan_catalogue import scan_rows, scan_sources
from probe.errors import BadData, ProbeError
from probe.tasks.suite import check_objects, part
from probe.tasks.suite_file import packaged_suite

SUITE = packaged_suite("v1-scans")
Z_UP_FROM_Y_UP = np.array([[1.0, 0, 0], [0, 0, -1.0], [0, 1.0, 0]])
BY_ID = {scan.id: scan for scan in scan_files()}


class _Quiet(http.server.SimpleHTTPRequestHandler):
    def log_message(self, format: str, *args: object) -> None:
        pass


@pytest.fixture
def site(tmp_path: Path) -> Iterator[tuple[Path, str]]:
    """A folder, and the address at which it is served."""
    folder = tmp_path / "site"
    folder.mkdir()
    handler = functools.partial(_Quiet, directory=str(folder))
    server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), handler)
    thread = threading.Thread(target=server.serve_forever, daemon=True)
    thread.start()
    yield folder, f"http://127.0.0.1:{server.server_address[1]}"
    server.shutdown()
    server.server_close()
    thread.join()


def _moved(address: str) -> dict[str, ScanSource]:
    """The public sources at a server of our own; hosts become folders, paths stay as they are."""
    return {
        name: source.model_copy(
            update={
                "files": {
                    file: url.replace("https:/", address, 1) for file, url in source.files.items()
                }
            }
        )
        for name, source in scan_collections().items()
    }


def _serve(folder: Path, scan: ScanFile, contents: Mapping[str, bytes]) -> None:
    for name, url in scan_collections()[scan.source].urls_of(scan.item).items():
        path = folder / url.removeprefix("https://")
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(contents[name])


def _fuel_zip(folder: Path) -> bytes:
    """A model as the server of Gazebo Fuel packs it: its files at the archive's root."""
    content = io.BytesIO()
    with zipfile.ZipFile(content, "w") as archive:
        for path in sorted(folder.rglob("*")):
            if path.is_file():
                archive.write(path, path.relative_to(folder))
    return content.getvalue()


def _obj(mesh: trimesh.Trimesh) -> bytes:
    """Triangles as OBJ text, z up, that names a material file which isn't there."""
    uv = np.asarray(cast(Any, mesh.visual).uv)
    lines = ["mtllib model.mtl", "usemtl material_0"]
    lines += ["v {:.6f} {:.6f} {:.6f}".format(*row) for row in mesh.vertices @ Z_UP_FROM_Y_UP.T]
    lines += ["vt {:.6f} {:.6f}".format(*row) for row in uv]
    lines += ["f " + " ".join(f"{i}/{i}" for i in face) for face in mesh.faces + 1]
    return "\n".join(lines).encode()


def _picture(mesh: trimesh.Trimesh, kind: str) -> bytes:
    content = io.BytesIO()
    image = cast(Image.Image, cast(Any, mesh.visual).material.baseColorTexture)
    image.convert("RGB").save(content, kind, **({"quality": 95} if kind == "JPEG" else {}))
    return content.getvalue()


def _gltf(mesh: trimesh.Trimesh, item: str) -> dict[str, bytes]:
    """A set of things as Poly Haven lays it out: nodes with names, textures in a folder."""
    other = trimesh.creation.box()
    other.visual = cast(Any, mesh.visual).copy()
    other.visual.uv = np.zeros((len(other.vertices), 2))
    scene = trimesh.Scene()
    scene.add_geometry(other, node_name="another_thing", geom_name="mesh_a")
    place = trimesh.transformations.translation_matrix((0.4, 0, -0.2))
    scene.add_geometry(mesh, node_name=item, geom_name="mesh_b", transform=place)
    files = cast(dict[str, bytes], scene.export(file_type="gltf", merge_buffers=True))
    text = next(it for name, it in files.items() if name.endswith(".gltf"))
    (buffer,) = [name for name in files if name.endswith(".bin")]
    pictures = [name for name in files if name.endswith((".png", ".jpg", ".jpeg"))]
    text = text.replace(buffer.encode(), b"tea_set_01.bin")
    for name in pictures:
        text = text.replace(name.encode(), b"textures/tea_set_01_diff_1k.jpg")
    look = _picture(mesh, "JPEG")
    return {
        "tea_set_01_1k.gltf": text,
        "tea_set_01.bin": files[buffer],
        **{f"textures/tea_set_01_{kind}_1k.jpg": look for kind in ("diff", "nor_gl", "arm")},
    }


def _served(assets: Path, id: str) -> dict[str, bytes]:
    """The files of a scan in the layout of its source."""
    scan = BY_ID[id]
    if scan.source == "gso":
        return {"model.zip": _fuel_zip(assets / "gso_layout" / scan.item)}
    mesh = read_gltf(assets / "scans" / f"{id}.glb")
    if scan.source == "tea_set":
        return _gltf(mesh, scan.item)
    return {
        "model.obj": _obj(mesh),
        "textured.obj": _obj(mesh),
        "texture_map.png": _picture(mesh, "PNG"),
        "texture_map.jpg": _picture(mesh, "JPEG"),
    }


def _fetch(
    folder: Path,
    scans: list[ScanFile],
    sources: Mapping[str, ScanSource],
    prints: Mapping[str, Fingerprint],
    cache: Path,
    mirror: str | None = None,
) -> list[str]:
    """Fetch them; what was told of those that failed."""
    told: list[str] = []

    def failed(scan: ScanFile, error: ProbeError) -> None:
        told.append(f"{scan.id}: {error}")

    fetching = ScanFetching(folder, sources, prints, Cache(cache / "bodies"), mirror)
    try:
        fetch_all(scans, fetching, lambda scan: lambda there, total: None, failed)
    except BadData as error:
        told.append(str(error))
    return told


def test_the_manifest_has_every_confirmed_scan_once_and_a_source_for_each():
    confirmed = [row.id for row in scan_rows() if row.confirmed]
    assert [scan.id for scan in scan_files()] == confirmed
    assert set(SUITE.objects) <= set(confirmed)
    assert {scan.source for scan in scan_files()} == set(scan_collections())
    assert {scan.id for scan in scan_files() if scan.colour} == {
        id for id in confirmed if id.startswith("gsof_")
    }
    assert {scan.licence for scan in scan_files()} == {"CC-BY-4.0", "MIT", "CC0-1.0"}


def test_a_manifest_says_where_a_file_lies():
    (url,) = scan_collections()["gso"].urls_of("Dino_4").values()
    assert url == "https://fuel.gazebosim.org/1.0/GoogleResearch/models/Dino_4.zip"


def test_licences_are_written_and_lines_that_are_there_stay(tmp_path):
    (tmp_path / "index.csv").write_text("id,more,licence,source_dataset\nmy_mug,1,MIT,mine\n")
    write_index([BY_ID["gso_lion"], BY_ID["ph_teapot"]], tmp_path)
    write_index([BY_ID["gso_lion"]], tmp_path)
    assert (tmp_path / "index.csv").read_text().splitlines() == [
        "id,more,licence,source_dataset",
        "my_mug,1,MIT,mine",
        "gso_lion,,CC-BY-4.0,Google Scanned Objects",
        "ph_teapot,,CC0-1.0,Poly Haven tea_set_01",
    ]
    write_index([BY_ID["gso_lion"]], tmp_path / "new")
    assert scan_sources(tmp_path / "new")["gso_lion"].licence == "CC-BY-4.0"


def test_what_a_mirror_has_is_checked_by_its_hash(site, tmp_path, assets):
    folder, address = site
    good, bad = BY_ID["ph_teapot_lid"], BY_ID["gsof_dog_statue"]
    (folder / f"{good.id}.glb").write_bytes((assets / "scans" / f"{good.id}.glb").read_bytes())
    (folder / f"{bad.id}.glb").write_bytes(b"glTF, but another")
    out = tmp_path / "scans"
    told = _fetch(out, [good, bad], scan_collections(), {}, tmp_path / "cache", f"{address}/")
    assert "gsof_dog_statue" in told[0] and bad.sha256 in told[0]
    assert "1 of 2 scans are missing: gsof_dog_statue. Run it again" in told[1]
    assert sorted(path.name for path in out.glob("*.glb")) == ["ph_teapot_lid.glb"]


def test_a_source_that_fails_is_named_and_the_others_go_on(site, tmp_path, assets):
    folder, address = site
    lost, found = BY_ID["gso_lion"], BY_ID["ph_teapot_lid"]
    _serve(folder, found, _served(assets, found.id))
    told = _fetch(tmp_path / "scans", [lost, found], _moved(address), {}, tmp_path / "cache")
    assert "gso_lion" in told[0] and "404" in told[0]
    assert "1 of 2 scans are missing: gso_lion." in told[1]
    assert (tmp_path / "scans" / ".fetching").is_dir()
    assert (tmp_path / "scans" / "ph_teapot_lid.glb").is_file()


def test_a_suite_without_its_scans_says_what_gets_them(tmp_path):
    with pytest.raises(BadData, match=r"there is no \w+ here. `probe assets fetch v1-scans` gets"):
        check_objects(SUITE, Library((), None, tmp_path))
    with pytest.raises(BadData, match="`probe assets fetch v1-scans` gets"):
        open_library("scans", None, tmp_path)
    with pytest.raises(BadData, match="`probe assets fetch v1-scans` gets"):
        open_library("scans", tmp_path, tmp_path)


def test_what_was_fetched_is_found_unless_a_folder_is_named(tmp_path, monkeypatch):
    monkeypatch.setenv("XDG_DATA_HOME", str(tmp_path))
    monkeypatch.delenv("PROBE_ASSETS", raising=False)
    assert assets_folder() is None
    (tmp_path / "probe" / "assets").mkdir(parents=True)
    assert assets_folder() == tmp_path / "probe" / "assets"
    (tmp_path / "probe" / "assets" / "scans" / ".fetching").mkdir(parents=True)
    assert assets_folder() is None
    monkeypatch.setenv("PROBE_ASSETS", "elsewhere")
    assert assets_folder() == Path("elsewhere")


@pytest.mark.slow
def test_another_object_is_refused_and_leaves_nothing(site, tmp_path, assets, cache):
    folder, address = site
    scan = BY_ID["ph_teapot_lid"]
    mesh = read_gltf(assets / "scans" / f"{scan.id}.glb")
    mesh.vertices[:] *= 1.01
    _serve(folder, scan, _gltf(mesh, scan.item))
    out = tmp_path / "scans"
    told = _fetch(out, [scan], _moved(address), SUITE.objects, cache)
    assert "ph_teapot_lid: what Poly Haven tea_set_01" in told[0]
    assert "is another object than the one in v1-scans" in told[0] and "--mirror" in told[0]
    assert sorted(path.name for path in out.glob("*.glb")) == []
    assert list((out / ".fetching").iterdir()) == []


FROM_EACH_LAYOUT = (
    "gso_usb_stick_kingston",
    "gsof_dog_statue",
    "ph_teapot_lid",
    "pum_soap",
    "ycb_061_foam_brick",
)


@pytest.mark.slow
def test_a_suite_opens_with_scans_from_the_layouts_of_their_sources(site, tmp_path, assets, cache):
    folder, address = site
    home = tmp_path / "home"
    (home / "scans").mkdir(parents=True)
    for id in BY_ID:
        if id in FROM_EACH_LAYOUT:
            _serve(folder, BY_ID[id], _served(assets, id))
        else:
            (home / "scans" / f"{id}.glb").symlink_to(assets / "scans" / f"{id}.glb")
    told = _fetch(home / "scans", list(scan_files()), _moved(address), SUITE.objects, cache)
    assert told == []
    made = [home / "scans" / f"{id}.glb" for id in FROM_EACH_LAYOUT]
    assert all(path.is_file() and not path.is_symlink() for path in made)
    assert not (home / "scans" / ".fetching").exists()
    library = open_library("scans", home, cache)
    with_one = [
        task
        for task in SUITE.tasks
        if {placed.object_id for placed in task.scene.objects} & set(FROM_EACH_LAYOUT)
    ]
    check_objects(part(SUITE, with_one[0]), library)
