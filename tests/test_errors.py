"""What can't be written is told with what helps."""

from __future__ import annotations

import errno
import os

import pytest

from probe.errors import OutputFailed
from probe.files import write_bytes


@pytest.mark.parametrize(
    ("code", "words"),
    [
        (errno.ENOSPC, "Free some space"),
        (errno.EACCES, "Choose a folder that you may write to"),
        (errno.EROFS, "Choose a folder that you may write to"),
        (errno.ENOTDIR, "Something else of that name is in the way"),
        (errno.ENAMETOOLONG, "Choose a shorter name"),
        (errno.EIO, "Choose another folder"),
    ],
)
def test_the_remedy_depends_on_the_reason(code, words):
    told = str(OutputFailed("x", OSError(code, os.strerror(code))))
    assert os.strerror(code) in told and words in told
    assert ("Free" in told) == (code == errno.ENOSPC)


def test_files_and_long_names_in_the_way(tmp_path):
    (tmp_path / "file").touch()
    with pytest.raises(OutputFailed, match="in the way"):
        write_bytes(tmp_path / "file" / "x", b"")
    with pytest.raises(OutputFailed, match="shorter name"):
        write_bytes(tmp_path / ("x" * 300) / "y", b"")
    (tmp_path / "folder" / "x").mkdir(parents=True)
    with pytest.raises(OutputFailed, match="in the way"):
        write_bytes(tmp_path / "folder", b"")
