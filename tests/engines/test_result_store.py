"""Results on their way: whole or not there, and nothing left behind."""

from __future__ import annotations

import pytest

from probe.engines.asset_bundle import AssetBundle, publish
from probe.engines.result_store import ResultStore
from probe.errors import BadData


def test_what_is_written_is_there_under_its_key(tmp_path):
    store = ResultStore(str(tmp_path / "units"))
    assert store.names() == set()
    store.write("find-1.0", b"a record")
    assert store.has("find-1.0") and store.read("find-1.0") == b"a record"
    store.remove_all(["find-1.0"])
    store.remove_all(["find-1.0"])
    assert not store.has("find-1.0")


def test_a_sweep_leaves_what_is_kept_and_no_half_written_file(tmp_path):
    store = ResultStore(str(tmp_path / "units"))
    store.write("driver", b"me")
    store.write("old", b"result")
    (tmp_path / "units" / ".new.x7").write_bytes(b"half of a res")
    assert store.names() == {"driver", "old"}
    store.sweep({"driver"})
    assert [file.name for file in (tmp_path / "units").iterdir()] == ["driver"]
    store.sweep()
    assert not (tmp_path / "units").exists()


def test_a_file_address_is_a_folder(tmp_path):
    store = ResultStore(f"file://{tmp_path}/shared").under("units-w")
    store.write("find-1.0", b"a record")
    assert (tmp_path / "shared" / "units-w" / "find-1.0").read_bytes() == b"a record"
    assert store.names() == {"find-1.0"}
    assert store.read_all(["find-1.0"]) == {"find-1.0": b"a record"}
    store.sweep()
    assert not (tmp_path / "shared" / "units-w").exists()


def test_an_address_that_nobody_knows_is_named():
    with pytest.raises(BadData, match="nowhere://x"):
        ResultStore("nowhere://x").names()


def bundle(tmp_path) -> AssetBundle:
    assets = tmp_path / "assets"
    (assets / "scans").mkdir(parents=True)
    (assets / "scans" / "bowl.obj").write_bytes(b"v 0 0 0")
    (assets / "same.obj").write_bytes(b"v 0 0 0")
    return publish(assets, ResultStore(str(tmp_path / "store")))


def test_assets_are_fetched_once_and_are_what_they_were(tmp_path):
    made = bundle(tmp_path)
    assert len(made.store.names()) == 1  # the same content is kept once
    folder = made.fetch(tmp_path / "cache")
    assert (folder / "scans" / "bowl.obj").read_bytes() == b"v 0 0 0"
    for key in made.store.names():
        made.store.remove_all([key])
    assert made.fetch(tmp_path / "cache") == folder


def test_an_asset_that_was_changed_on_the_way_is_refused(tmp_path):
    made = bundle(tmp_path)
    for key in made.store.names():
        made.store.write(key, b"v 9 9 9")
    with pytest.raises(BadData, match="has been changed"):
        made.fetch(tmp_path / "cache")
    assert not any((tmp_path / "cache" / "nodes").glob("*/*"))
