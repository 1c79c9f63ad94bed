"""Pictures as files that models are sent."""

from __future__ import annotations

import io

from PIL import Image

from probe.types import Array

QUALITY = 90
"""A table as PNG has 1.8 MB, as JPEG 0.35 (in base64); many servers limit a whole request,
and some clients of the tools refuse results over 1 MB."""


def jpeg(picture: Array) -> bytes:
    """A picture, uint8 (h, w, 3), as a JPEG file with colours at full resolution."""
    buffer = io.BytesIO()
    Image.fromarray(picture).save(buffer, "JPEG", quality=QUALITY, subsampling=0)
    return buffer.getvalue()
