"""Refuse a picture by its header. Knows no meshes."""

from __future__ import annotations

import io
import warnings
from pathlib import Path

from PIL import Image

from probe.assets.mesh.shaping import MAX_TEXTURE_PX
from probe.errors import BadMesh

QUESTION_TYPES = ("PNG", "JPEG", "WEBP", "BMP", "TGA", "TIFF")


def check_picture(path: Path, content: io.BytesIO | Path) -> None:
    """Refuse a picture larger than 8192 pixels a side, or none at all, without decoding it.

    Args:
        path: Who uses it; for messages.
        content: The picture.

    Raises:
        BadMesh: It can't be used.
    """
    name = f"its texture {content.name}" if isinstance(content, Path) else "its texture"
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", Image.DecompressionBombWarning)
            with Image.open(content, formats=QUESTION_TYPES) as image:
                width, height = image.size
    except Image.DecompressionBombError as error:
        reason = f"{name} is far too large ({error})"
        raise BadMesh(path, reason, f"Reduce it to at most {MAX_TEXTURE_PX} pixels.") from error
    except (OSError, ValueError, SyntaxError) as error:
        reason = f"{name} is damaged or of an unknown kind ({error})"
        raise BadMesh(path, reason, "Save it again as PNG or JPEG.") from error
    if max(width, height) > MAX_TEXTURE_PX:
        reason = f"{name} is {width} x {height} pixels"
        raise BadMesh(path, reason, f"Reduce it to at most {MAX_TEXTURE_PX} (1024 is plenty).")
