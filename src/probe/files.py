"""Writes files so that none is ever found half-written."""

from __future__ import annotations

import contextlib
import fcntl
import io
import os
import shutil
import tempfile
from collections.abc import Generator
from pathlib import Path
from typing import TypeVar

from PIL import Image
from pydantic import BaseModel, ValidationError

from probe import reading
from probe.checksum import without_sum
from probe.errors import BadData, OutputFailed
from probe.types import Array

Document = TypeVar("Document", bound=BaseModel)


def write_bytes(path: Path, content: bytes, *, private: bool = False) -> None:
    """Write a whole file or none: a temporary file beside it takes its place when complete.

    Args:
        path: The file; its folder is made if need be.
        content: All of it.
        private: Only its owner can read it (mode 0600).

    Raises:
        OutputFailed: The disk is full, or the folder can't be written.
    """
    temporary = ""
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        handle, temporary = tempfile.mkstemp(dir=path.parent, prefix=f".{path.name}.")
        with os.fdopen(handle, "wb") as file:
            file.write(content)
        # Born with mode 0600.
        if not private:
            os.chmod(temporary, 0o644)
        os.replace(temporary, path)
    except OSError as error:
        if temporary:
            with contextlib.suppress(OSError):
                os.unlink(temporary)
        raise OutputFailed(path, error) from error


def write_secret(path: Path, text: str) -> None:
    """Write a UTF-8 file that its owner alone can read; whole, and only if there is none yet.

    So is its folder, if that is made for it.
    Of several who do so at once, one succeeds, and the others leave its file as it is.

    Raises:
        OutputFailed: As write_bytes().
    """
    temporary = ""
    try:
        path.parent.mkdir(mode=0o700, parents=True, exist_ok=True)
        # Born with mode 0600.
        handle, temporary = tempfile.mkstemp(dir=path.parent, prefix=f".{path.name}.")
        with os.fdopen(handle, "wb") as file:
            file.write(text.encode())
        with contextlib.suppress(FileExistsError):
            os.link(temporary, path)
    except OSError as error:
        raise OutputFailed(path, error) from error
    finally:
        if temporary:
            with contextlib.suppress(OSError):
                os.unlink(temporary)


def check_new(out: Path) -> None:
    """Refuse a folder that is there.

    Raises:
        BadData: It is.
    """
    if out.exists():
        raise BadData(out, "is there already", "Choose a new folder")


def check_writable(folder: Path) -> None:
    """See that files can be written into a folder, or into one made there; nothing is left.

    Raises:
        OutputFailed: They can't.
    """
    new = [it for it in (folder, *folder.parents) if not os.path.lexists(it)]
    try:
        try:
            folder.mkdir(parents=True, exist_ok=True)
            with tempfile.TemporaryFile(dir=folder):
                pass
        finally:
            for made in new:
                with contextlib.suppress(OSError):
                    made.rmdir()
    except OSError as error:
        raise OutputFailed(folder, error) from error


def claim_folder(path: Path, settings: BaseModel, remedy: str, *, private: bool = False) -> None:
    """Write down how the work in a folder is done, or see that it was begun in the same way.

    Args:
        path: File for that, in the folder.
        settings: How.
        remedy: What to do if the file can't be read.
        private: Only its owner can read the file.

    Raises:
        BadData: It was begun otherwise, or the file is broken.
        OutputFailed: It can't be written.
    """
    if not path.exists():
        write_text(path, settings.model_dump_json(indent=1) + "\n", private=private)
        return
    before = read_document(path, type(settings), remedy)
    for name in type(settings).model_fields:
        was, now = getattr(before, name), getattr(settings, name)
        if was != now:
            short = not isinstance(now, BaseModel)
            reason = f"{name} {was}, not {now}" if short else f"another {name}"
            raise BadData(
                path, f"was begun with {reason}", "Say the same again, or choose another folder"
            )


@contextlib.contextmanager
def alone(folder: Path) -> Generator[None]:
    """Keep other processes out of such a block; the lock leaves no file and dies with us.

    Args:
        folder: What is worked on; it is made if need be.

    Raises:
        OutputFailed: It can't be made.
    """
    try:
        folder.mkdir(parents=True, exist_ok=True)
        handle = os.open(folder, os.O_RDONLY)
    except OSError as error:
        raise OutputFailed(folder, error) from error
    try:
        fcntl.flock(handle, fcntl.LOCK_EX)
        yield
    finally:
        os.close(handle)


@contextlib.contextmanager
def whole_folder(folder: Path) -> Generator[Path]:
    """A hidden folder beside it that takes its place when the block ends well, else goes.

    Raises:
        OutputFailed: The disk is full, it can't be written, or the place is taken.
    """
    building: Path | None = None
    try:
        folder.parent.mkdir(parents=True, exist_ok=True)
        building = Path(tempfile.mkdtemp(dir=folder.parent, prefix=f".{folder.name}."))
        yield building
        building.chmod(0o755)
        building.rename(folder)
    except OSError as error:
        raise OutputFailed(folder, error) from error
    finally:
        if building is not None:
            with contextlib.suppress(OSError):
                shutil.rmtree(building)


def write_text(path: Path, text: str, *, private: bool = False) -> None:
    """Write a whole UTF-8 text file or none; see write_bytes."""
    write_bytes(path, text.encode(), private=private)


def make_private(folder: Path) -> None:
    """Let its owner alone into a folder (mode 0700).

    Raises:
        OutputFailed: It is somebody else's.
    """
    try:
        folder.chmod(0o700)
    except OSError as error:
        raise OutputFailed(folder, error) from error


def write_picture(path: Path, pixels: Array) -> None:
    """Write an array as PNG: uint8 (h, w, 3) in colour, uint8 or uint16 (h, w) in grey."""
    write_bytes(path, encode(Image.fromarray(pixels), "PNG"))


def encode(image: Image.Image, layout: str, *, quality: int = 75) -> bytes:
    """An image as the bytes of a file in that format ("PNG", "WEBP"…); PNG knows no quality."""
    buffer = io.BytesIO()
    image.save(buffer, layout, quality=quality)
    return buffer.getvalue()


def read_document(
    path: Path,
    model: type[Document],
    remedy: str,
    missing: str = "Check the path",
    most: int = reading.DOCUMENT,
) -> Document:
    """Read a JSON file that holds one document, with a checksum at its end or without.

    Args:
        path: The file.
        model: Its schema.
        remedy: What to do about a file that breaks it.
        missing: What to do about a file that can't be read.
        most: Bytes that it may have.

    Raises:
        BadData: It can't be read, is too large, has changed since its checksum was made, or breaks
            the schema; the first broken field is named.
    """
    try:
        return model.model_validate_json(without_sum(reading.json_contents(path, most)))
    except OSError as error:
        raise BadData(path, unread(path, error), missing) from error
    except ValidationError as error:
        raise BadData(path, fault(error, "the file"), remedy) from error
    except ValueError as error:
        raise BadData(path, str(error), remedy) from error


def unread(path: Path, error: OSError) -> str:
    """Why a file can't be read; of a link to nothing, the system names what it would lead to."""
    if isinstance(error, FileNotFoundError) and path.is_symlink():
        return f"is a link to {os.readlink(path)}, which isn't there"
    return error.strerror or str(error)


def fault(error: ValidationError, whole: str) -> str:
    """The first thing that breaks a schema: where, and in which way.

    Args:
        error: What the schema raised.
        whole: What to call the place where it is no single field.
    """
    first = error.errors(include_input=False)[0]
    place = ".".join(str(part) for part in first["loc"]) or whole
    return f"{place}: {first['msg']}"
