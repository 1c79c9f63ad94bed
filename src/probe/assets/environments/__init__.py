"""Surroundings that light a table: panoramas from disk, and rooms painted by formula."""

from __future__ import annotations

from functools import lru_cache
from pathlib import Path

from probe.assets.environments.hdr_file import read_panorama
from probe.assets.environments.painter import paint_room
from probe.assets.environments.room import rooms
from probe.errors import UnknownName
from probe.types import Array

_FORMATS = (".hdr", ".exr")


def environment_names(assets: Path | None) -> tuple[str, ...]:
    """Surroundings to draw from: painted rooms, then the panoramas in the assets' folder hdris/.

    The rooms that new scenes stand in anyway aren't among them.
    """
    return (*rooms(), *sorted(_panoramas(assets)))


@lru_cache(maxsize=2)
def load_environment(name: str, assets: Path | None) -> Array:
    """Linear radiance, float32, shape (h, 2 h, 3): the top row overhead, the middle to the front.

    Painting a room takes about two seconds.

    Raises:
        UnknownName: Nothing has this name.
        BadData: Its file can't be read.
    """
    if name in rooms():
        return paint_room(rooms()[name])
    files = _panoramas(assets)
    if name not in files:
        raise UnknownName("environment", name, [*rooms(), *files])
    return read_panorama(files[name])


def _panoramas(assets: Path | None) -> dict[str, Path]:
    """Files by name: "venice_sunset_1k.hdr" is venice_sunset_1k."""
    folder = None if assets is None else assets / "hdris"
    if folder is None or not folder.is_dir():
        return {}
    return {path.stem: path for path in folder.iterdir() if path.suffix in _FORMATS}
