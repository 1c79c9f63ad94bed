"""Writes files so that none is ever found half-written."""

from __future__ import annotations

import contextlib
import io
import os
import tempfile
from pathlib import Path
from typing import TypeVar

from PIL import Image
from pydantic import BaseModel, ValidationError

from probe.errors import BadData, OutputFailed
from probe.types import Array

Document = TypeVar("Document", bound=BaseModel)


def write_bytes(path: Path, content: bytes) -> None:
    """Write a whole file or none: a temporary file beside it takes its place when complete.

    Raises:
        OutputFailed: The disk is full, or the folder can't be written.
    """
    temporary = ""
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        handle, temporary = tempfile.mkstemp(dir=path.parent, prefix=f".{path.name}.")
        with os.fdopen(handle, "wb") as file:
            file.write(content)
        os.chmod(temporary, 0o644)
        os.replace(temporary, path)
    except OSError as error:
        if temporary:
            with contextlib.suppress(OSError):
                os.unlink(temporary)
        raise OutputFailed(path, error.strerror or str(error)) from error


def write_text(path: Path, text: str) -> None:
    """Write a whole UTF-8 text file or none; see write_bytes."""
    write_bytes(path, text.encode())


def write_picture(path: Path, pixels: Array) -> None:
    """Write an array as PNG: uint8 (h, w, 3) in colour, uint8 or uint16 (h, w) in grey."""
    write_bytes(path, encode(Image.fromarray(pixels), "PNG"))


def encode(image: Image.Image, layout: str, *, quality: int = 75) -> bytes:
    """An image as the bytes of a file in that format ("PNG", "JPEG"); PNG knows no quality."""
    buffer = io.BytesIO()
    image.save(buffer, layout, quality=quality)
    return buffer.getvalue()


def read_document(
    path: Path, model: type[Document], remedy: str, missing: str = "Check the path"
) -> Document:
    """Read a JSON file that holds one document.

    Args:
        path: The file.
        model: Its schema.
        remedy: What to do about a file that breaks it.
        missing: What to do about a file that can't be read.

    Raises:
        BadData: It can't be read, or it breaks the schema; the first broken field is named.
    """
    try:
        return model.model_validate_json(path.read_bytes())
    except OSError as error:
        raise BadData(path, error.strerror or str(error), missing) from error
    except ValidationError as error:
        raise BadData(path, fault(error, "the file"), remedy) from error


def fault(error: ValidationError, whole: str) -> str:
    """The first thing that breaks a schema: where, and in which way.

    Args:
        error: What the schema raised.
        whole: What to call the place where it is no single field.
    """
    first = error.errors(include_input=False)[0]
    place = ".".join(str(part) for part in first["loc"]) or whole
    return f"{place}: {first['msg']}"
