"""`probe film` with options that would do nothing: refused before anything is read."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from probe.cli.film import film
from probe.errors import BadData


@pytest.mark.parametrize(
    ("said", "words"),
    [
        ({"clips": True, "out": Path("films")}, "--out: does nothing with --clips"),
        ({"clips": True, "format": "gif"}, "--format: does nothing with --clips"),
        ({"clips": True, "speed": 1.0}, "--speed: does nothing with --clips"),
        ({"format": "rrd", "speed": 2.0}, "--speed: does nothing with --format rrd"),
        ({"format": "rrd", "renderer": "blender"}, "--renderer: does nothing with --format rrd"),
    ],
)
def test_what_would_do_nothing_is_refused(tmp_path: Path, said: dict[str, Any], words: str):
    with pytest.raises(BadData, match=rf"{words}.*`probe film --help`"):
        film(tmp_path / "nowhere", **said)
    assert list(tmp_path.iterdir()) == []
