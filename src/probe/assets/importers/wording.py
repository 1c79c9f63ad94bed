"""Words for an object from the names of its file and folders. Knows no meshes."""

from __future__ import annotations

import os
import re
from collections.abc import Callable
from pathlib import Path
from typing import get_args

from probe.assets.colour.names import Colour

_COLOURS = {*get_args(Colour), "grey", "turquoise"}
_BINDING = {"and", "in", "of", "or", "with"}
_MANY = re.compile(r"[^su]s$")
"""What ends so is several things, or a pair ("cups", "scissors"), and takes no article."""

LONGEST_NAME = 40
"""Letters of a draft name; what a person may put in its place is no longer either."""

SILENT = re.compile(
    "base|clouds|decimated|final|glb|gltf|google|high|highres|hires|low|lowres|lod|main|materials?|"
    "mesh|meshes|model|mtl|nontextured|obj|object|output|poisson|raw|scan|scene|simplified|sole|"
    "source|textured?|textures|tsdf|untextured|untitled|urdf|visuals?"
)
"""Words that say of a file how it was made or what it is for, but not what it shows."""

COLLECTIONS = re.compile(
    "aloha|assets|bop|data|datasets?|downloads|google_scanned_objects|gso|objects|models|"
    "scalingup|scans|set|things|ycb|ycbv"
)
"""Folders that hold many objects; they name none of them."""

_NUMBER = re.compile(r"(?:v?\d+[a-z]?|\d+k|lod\d+)$")
_PADDED = re.compile(r"0\d")
_CODE = re.compile(r"(?=\w*\d)(?=\w*[A-Za-z])\w{9,}$")
_BOUNDARY = re.compile(r"(?<=[a-z])(?=[A-Z])")
_YCB_NUMBER = re.compile(r"^\d{3}(?:[-_][a-z])?[-_ ]+(?=[A-Za-z])")


def place_of(file: Path, root: Path) -> tuple[str, Path]:
    """What an object is called by its place, and the folder that holds all of it.

    The file's own name counts if it says something ("apple.obj"); else that of the nearest
    folder that does: ``ycb/003_apple/google_16k/textured.obj`` is "003_apple". Folders that hold
    many objects name none, nor does the one that was asked for if numbered ones lie between.

    Args:
        file: Its mesh.
        root: What was asked for; folders above it count for nothing.

    Returns:
        The name as it stands there, and the object's folder.
    """
    file, root = _whole(file), _whole(root)
    home = file.parent
    while home != root and root in home.parents and _is_technical(home.name):
        home = home.parent
    named = _spoken_part(file.stem)
    if named:
        return named, home
    numbered = any(piece.isdigit() for piece in re.split(r"[-_. ]+", file.stem))
    for folder in (file.parent, *file.parent.parents):
        words = folder.name
        numbered |= words.isdigit()
        speaks = _spoken_part(words) and not COLLECTIONS.fullmatch(words.lower())
        if speaks and not (folder == root and numbered):
            return words, home
        if folder == root:
            break
    return file.stem, home


def speaking_root(path: Path) -> Path:
    """The nearest folder of a file, or the folder itself, whose name isn't only technical."""
    folder = _whole(path).parent if path.is_file() else _whole(path)
    while _is_technical(folder.name) and folder != folder.parent:
        folder = folder.parent
    return folder


def _whole(path: Path) -> Path:
    """From the root of the disk, without ``..``; links stay as they are."""
    return Path(os.path.abspath(path))


def says_nothing(stem: str) -> bool:
    """Whether a file's name tells only how it was made ("textured", "model_2")."""
    return not _spoken_part(stem)


def variant_of(stem: str) -> str:
    """What is left of a file's name once the words that tell how it was made are gone.

    Files of one folder with the same left are one object: "textured" and "nontextured",
    "apple_low" and "apple_high"; not "model_1" and "model_2".
    """
    left = _spoken_part(stem)
    return left or (stem if any(sign.isdigit() for sign in stem) else "")


def draft_name(raw: str) -> str:
    """A name as a person would say it: "003_apple" is "apple", "RedMug_2" "red mug"."""
    words = _words(raw)
    words = [word for word in words if not _PADDED.fullmatch(word)] or words
    while len(words) > 1 and words[-1].isdigit() and len(words[-1]) < 3:
        words.pop()
    if len(" ".join(words)) > LONGEST_NAME:
        words = [word for word in words if not _is_mixed(word)] or words
    name = shortened(" ".join(words), " ")
    return name if len(name) > 1 and not name.isdigit() else f"object {name}".strip()


def colour_first(name: str, is_noun: Callable[[str], bool]) -> str:
    """A name whose colours don't stand at its end: "hammer black" is "black hammer".

    Args:
        name: The name.
        is_noun: Whether words say what a thing is; if those before the colours don't, the last
            word may be no colour ("mandarin orange").
    """
    words = name.split()
    end = len(words)
    while end and words[end - 1] in _COLOURS:
        end -= 1
    head, colours = words[:end], words[end:]
    if not head or not colours or head[-1] in _BINDING or not is_noun(" ".join(head)):
        return name
    told = " ".join([" and ".join(colours), *head])
    return told if len(told) <= LONGEST_NAME else " ".join([*colours, *head])


def described(name: str) -> str:
    """A sentence on an object of which nothing but the name is known: "A red mug."."""
    if _MANY.search(name):
        return f"{name[:1].upper()}{name[1:]}."
    return f"{'An' if name[:1] in 'aeiou' else 'A'} {name}."


def all_words(raw: str) -> str:
    """A name in lower-case words, however long."""
    return " ".join(_words(raw))


def id_words(raw: str) -> str:
    """The part of an id after its prefix: as `draft_name`, but a number at the end stays."""
    return shortened("_".join(_words(raw)), "_") or "object"


def shortened(text: str, gap: str) -> str:
    """A text of at most 40 letters, cut between words where it can be."""
    if len(text) <= LONGEST_NAME:
        return text
    return text[: LONGEST_NAME + 1].rpartition(gap)[0] or text[:LONGEST_NAME]


def _words(raw: str) -> list[str]:
    """Lower-case words without catalogue numbers and codes."""
    raw = _YCB_NUMBER.sub("", raw)
    pieces = [piece for piece in re.split(r"[^A-Za-z0-9]+", raw) if piece]
    while _is_code(pieces[-1:]) and not all(_is_silent(piece) for piece in pieces[:-1]):
        pieces.pop()
    split = [word for piece in pieces for word in _BOUNDARY.split(piece)]
    return [word.lower() for word in split]


def _is_mixed(word: str) -> bool:
    return any(sign.isdigit() for sign in word)


def _is_code(last: list[str]) -> bool:
    """Whether the last piece is a catalogue's number or code, no word."""
    return any(_CODE.match(piece) or (piece.isdigit() and len(piece) > 3) for piece in last)


def _spoken_part(name: str) -> str:
    """A name without the words at its ends that say nothing; empty if nothing is left."""
    pieces = [piece for piece in re.split(r"[-_. ]+", name) if piece]
    while pieces and _is_silent(pieces[-1]) and not pieces[-1].isdigit():
        pieces.pop()
    while len(pieces) > 1 and _is_silent(pieces[0]) and not pieces[0].isdigit():
        pieces.pop(0)
    return "_".join(pieces) if any(not _is_silent(piece) for piece in pieces) else ""


def _is_technical(name: str) -> bool:
    return not _spoken_part(name) and not name.isdigit()


def _is_silent(word: str) -> bool:
    return bool(SILENT.fullmatch(word.lower())) or _is_number(word)


def _is_number(name: str) -> bool:
    return bool(_NUMBER.match(name.lower()))
