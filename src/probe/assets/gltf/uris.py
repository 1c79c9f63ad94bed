"""What a glTF tree refers to: files beside it and pictures, checked before they are read."""

from __future__ import annotations

import base64
import binascii
import io
from pathlib import Path
from typing import Any
from urllib.parse import unquote

from probe.assets.confined import confined
from probe.assets.mesh.shaping import EXPORT_AGAIN
from probe.assets.pictures import check_picture
from probe.errors import BadMesh
from probe.reading import opened


def check_uris(path: Path, tree: dict[str, Any]) -> None:
    """Refuse URIs that lead out of the file's folder, or to nothing.

    Raises:
        BadMesh: One does, or the tree is malformed.
    """
    outside_files(path, tree)


def outside_files(path: Path, tree: dict[str, Any]) -> tuple[Path, ...]:
    """The files beside a glTF that it refers to.

    Raises:
        BadMesh: One lies outside its folder or isn't there, or the tree is malformed.
    """
    try:
        entries = [*tree.get("buffers", []), *tree.get("images", [])]
        uris = [str(entry["uri"]) for entry in entries if "uri" in entry]
    except (TypeError, KeyError) as error:
        raise BadMesh(path, "its buffers or images are malformed", f"{EXPORT_AGAIN}.") from error
    named = [unquote(uri) for uri in uris if not uri.startswith("data:")]
    return tuple(confined(path, name, path.parent) for name in named)


def check_images(path: Path, tree: dict[str, Any], data_start: int) -> None:
    """Refuse pictures that would fill the memory, or are none; reads their headers alone.

    Raises:
        BadMesh: One is too large, damaged, or neither PNG, JPEG nor WebP.
    """
    for image in tree.get("images", []):
        try:
            content = _picture(path, tree, image, data_start)
        except (TypeError, KeyError, IndexError, ValueError, AttributeError, OSError) as error:
            raise BadMesh(path, "its images are malformed", f"{EXPORT_AGAIN}.") from error
        check_picture(path, content)


def _picture(
    path: Path, tree: dict[str, Any], image: dict[str, Any], data_start: int
) -> io.BytesIO | Path:
    """A picture's bytes or file."""
    if "uri" in image:
        return _named(path, image["uri"])
    view = tree["bufferViews"][image["bufferView"]]
    start, length = int(view.get("byteOffset", 0)), int(view["byteLength"])
    uri = tree["buffers"][view["buffer"]].get("uri")
    source = path if uri is None else _named(path, uri)
    if isinstance(source, io.BytesIO):
        return io.BytesIO(source.getvalue()[start : start + length])
    with opened(source) as file:
        file.seek(start + (data_start if uri is None else 0))
        return io.BytesIO(file.read(max(0, length)))


def _named(path: Path, uri: str) -> io.BytesIO | Path:
    """What a URI holds itself, or the file that it names."""
    if not uri.startswith("data:"):
        return path.parent / unquote(uri)
    try:
        return io.BytesIO(base64.b64decode(uri.partition(",")[2]))
    except binascii.Error as error:
        raise ValueError(str(error)) from error
