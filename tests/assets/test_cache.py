from __future__ import annotations

import logging
from pathlib import Path

import numpy as np
import pytest

from probe.assets.cache import Cache, content_key
from probe.errors import OutputFailed

ARRAYS = {"a": np.arange(12, dtype=np.float32).reshape(3, 4), "b": np.zeros((0, 3))}
KEY = content_key("something")


def test_what_is_stored_comes_back(tmp_path):
    cache = Cache(tmp_path)
    assert cache.load(KEY) is None
    cache.store(KEY, ARRAYS)
    back = cache.load(KEY)
    assert back is not None and back.keys() == ARRAYS.keys()
    for name, array in ARRAYS.items():
        assert back[name].dtype == array.dtype
        assert (back[name] == array).all() and back[name].shape == array.shape
    assert [path.suffix for path in tmp_path.rglob("*") if path.is_file()] == [".npz"]


def test_what_was_kept_before_sums_were_told_apart_is_not_read(tmp_path):
    cache = Cache(tmp_path)
    cache.store(KEY, ARRAYS)
    path = cache.path(KEY)
    (tmp_path / KEY[:2]).mkdir()
    path.rename(tmp_path / KEY[:2] / path.name)
    assert cache.load(KEY) is None


def _cut(content: bytes) -> bytes:
    return content[: len(content) // 2]


def _flip(content: bytes) -> bytes:
    place = content.index(b"a.npy") + 60  # within that array's compressed bytes
    return content[:place] + bytes([content[place] ^ 255]) + content[place + 1 :]


@pytest.mark.parametrize("harm", [_cut, _flip, lambda _: b"", lambda _: b"not an archive"])
def test_a_damaged_entry_is_removed_and_said_so(tmp_path, caplog, harm):
    cache = Cache(tmp_path)
    cache.store(KEY, ARRAYS)
    path = cache.path(KEY)
    path.write_bytes(harm(path.read_bytes()))
    with caplog.at_level(logging.WARNING):
        assert cache.load(KEY) is None
    assert str(path) in caplog.text
    assert not path.exists()
    cache.store(KEY, ARRAYS)
    assert cache.load(KEY) is not None


def test_a_cache_that_cannot_be_written_says_so(tmp_path):
    blocked = tmp_path / "file"
    blocked.write_text("in the way")
    with pytest.raises(OutputFailed, match="file"):
        Cache(blocked).store(KEY, ARRAYS)


def test_a_full_disk_leaves_nothing(tmp_path):
    if not Path("/dev/full").exists():
        pytest.skip("no /dev/full here")

    class Full(Cache):
        def path(self, key: str) -> Path:
            return Path("/dev/full") / key

    with pytest.raises(OutputFailed):
        Full(tmp_path).store(KEY, ARRAYS)


def test_keys_tell_parts_apart():
    assert content_key("ab", "c") != content_key("a", "bc")
    assert content_key("ab") == content_key(b"ab")
