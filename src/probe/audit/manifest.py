"""Hashes of every file of a folder, in the form that `sha256sum -c` reads."""

from __future__ import annotations

import re
from pathlib import Path

from probe.audit.audit_file import hash_of
from probe.errors import BadData
from probe.files import write_text

MANIFEST, SIGNATURE = "SHA256SUMS", "SHA256SUMS.sig"

_LINE = re.compile(r"([0-9a-f]{64})  (.+)")
_REMEDY = "Fetch the folder again, or ask who signed it"


def write_manifest(out: Path) -> int:
    """Write down the hash of each file of a folder, in order of names; returns how many.

    Raises:
        BadData: Something in it is no plain file, or has a name with a line break.
        OutputFailed: It can't be written.
    """
    files = _files(out)
    lines = [f"{hash_of(out / name)}  {name}\n" for name in files]
    write_text(out / MANIFEST, "".join(lines))
    return len(files)


def check_manifest(out: Path) -> int:
    """See that a folder holds exactly the files of its manifest; returns how many.

    Raises:
        BadData: A file is missing, has changed, or isn't in the manifest; or there is none.
    """
    known, found = _read(out / MANIFEST), _files(out)
    for name in found:
        if name not in known:
            raise BadData(out / name, f"isn't in {MANIFEST}", _REMEDY)
    for name, hash in known.items():
        if name not in found:
            raise BadData(out / name, f"is in {MANIFEST} and missing here", _REMEDY)
        if hash_of(out / name) != hash:
            raise BadData(out / name, f"has changed since {MANIFEST} was written", _REMEDY)
    return len(known)


def _files(out: Path) -> list[str]:
    names = list[str]()
    for path in sorted(out.rglob("*")):
        name = path.relative_to(out).as_posix()
        if path.is_symlink() or not (path.is_file() or path.is_dir()):
            raise BadData(path, "is no plain file", "Take it out of the folder")
        if "\n" in name or "\\" in name:
            raise BadData(ascii(name), "has a line break or a backslash", "Give it another name")
        if path.is_file() and name not in (MANIFEST, SIGNATURE):
            names.append(name)
    return names


def _read(path: Path) -> dict[str, str]:
    try:
        lines = path.read_text("utf-8").splitlines()
    except (OSError, UnicodeDecodeError) as error:
        remedy = "Write one: probe audit FOLDER --sign KEY"
        raise BadData(path, str(error), remedy) from error
    matches = [_LINE.fullmatch(line) for line in lines]
    if None in matches:
        raise BadData(f"{path}, line {matches.index(None) + 1}", "is no hash of a file", _REMEDY)
    return {match[2]: match[1] for match in matches if match}
