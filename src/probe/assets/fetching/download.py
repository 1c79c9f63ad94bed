"""Download one file: resumed where it stopped, checked, whole or not there. Knows no formats."""

from __future__ import annotations

import contextlib
import hashlib
import http.client
import time
import urllib.error
import urllib.request
from collections.abc import Callable
from pathlib import Path

from pydantic import BaseModel, ValidationError

from probe.errors import DownloadFailed, OutputFailed
from probe.files import write_text

TIMEOUT = 60.0
TRIES = 4
PAUSE = 1.0
CHUNK = 1 << 18
# Some sites turn away Python's own name.
AGENT = "probe-vqa (+https://pypi.org/project/probe-vqa)"

Progress = Callable[[int, int | None], None]
BROKEN = (urllib.error.URLError, http.client.HTTPException, TimeoutError, ConnectionError)


class _Begun(BaseModel):
    """What a partial file is part of."""

    url: str
    validator: str


def download(
    url: str, path: Path, sha256: str | None, progress: Progress, pause: float = PAUSE
) -> str:
    """Fetch a file, or the rest of it; nothing is fetched if it is there and right.

    Args:
        url: http or https.
        path: Where it goes; what has come so far lies beside it as ``<name>.part``.
        sha256: What it has to hash to; None if that isn't known.
        progress: Told bytes there and, if known, bytes in all.
        pause: Seconds before the first new try; each further one waits twice as long.

    Returns:
        Its SHA-256 in hex.

    Raises:
        DownloadFailed: The server can't be reached or says no, the connection breaks again and
            again, or the checksum is wrong.
        OutputFailed: The disk is full, or the folder can't be written.
    """
    if path.is_file() and (sha256 is None or _hash(path) == sha256):
        return _hash(path)
    part, begun = _beside(path, ".part"), _beside(path, ".part.json")
    for attempt in range(TRIES):
        try:
            _fetch(url, part, begun, progress)
            break
        except urllib.error.HTTPError as error:
            if error.code != 416 and error.code < 500:
                raise DownloadFailed(url, f"the server says {error.code} {error.reason}") from error
            _forget(part, begun)
            reason = f"the server says {error.code} {error.reason}"
        except BROKEN as error:
            reason = str(getattr(error, "reason", None) or error or type(error).__name__)
        except OSError as error:
            _forget(part, begun)
            raise OutputFailed(path, error) from error
        if attempt == TRIES - 1:
            raise DownloadFailed(url, reason)
        time.sleep(pause * 2**attempt)
    return _kept(url, part, begun, path, sha256)


def _kept(url: str, part: Path, begun: Path, path: Path, sha256: str | None) -> str:
    """Give the complete file its name, if it is right."""
    found = _hash(part)
    if sha256 is not None and found != sha256:
        _forget(part, begun)
        raise DownloadFailed(url, f"its SHA-256 is {found}, expected {sha256}; it was thrown away")
    part.replace(path)
    _forget(begun)
    return found


def _fetch(url: str, part: Path, begun: Path, progress: Progress) -> None:
    """Append what is missing to a partial file; complete when it returns."""
    part.parent.mkdir(parents=True, exist_ok=True)
    validator = _validator(begun, url)
    there = part.stat().st_size if validator and part.is_file() else 0
    headers = {"User-Agent": AGENT}
    if there:
        headers |= {"Range": f"bytes={there}-", "If-Range": validator}
    request = urllib.request.Request(url, headers=headers)
    with urllib.request.urlopen(request, timeout=TIMEOUT) as answer:
        if answer.status != 206:
            there = 0
        stamp = answer.headers.get("ETag") or answer.headers.get("Last-Modified") or ""
        # Weak tags don't promise the same bytes; such a file is begun again.
        usable = "" if stamp.startswith("W/") else stamp
        length = answer.headers.get("Content-Length")
        total = None if length is None else there + int(length)
        if not there:
            part.unlink(missing_ok=True)
            write_text(begun, _Begun(url=url, validator=usable).model_dump_json())
        with part.open("ab") as file:
            while chunk := answer.read(CHUNK):
                file.write(chunk)
                there += len(chunk)
                progress(there, total)
        if total is not None and there < total:
            raise http.client.IncompleteRead(b"", total - there)


def _validator(begun: Path, url: str) -> str:
    """What the server called the version that was begun; empty if it can't be gone on with."""
    try:
        known = _Begun.model_validate_json(begun.read_bytes())
    except (OSError, ValidationError):
        return ""
    return known.validator if known.url == url else ""


def _hash(path: Path) -> str:
    with path.open("rb") as file:
        return hashlib.file_digest(file, "sha256").hexdigest()


def _beside(path: Path, ending: str) -> Path:
    return path.with_name(path.name + ending)


def _forget(*paths: Path) -> None:
    for path in paths:
        with contextlib.suppress(OSError):
            path.unlink(missing_ok=True)
