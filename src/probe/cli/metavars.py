"""How positional arguments are called in help and in messages about them."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

from tyro.conf import Positional, arg

SuiteName = Annotated[str, Positional, arg(metavar="SUITE")]
SuiteNames = Annotated[tuple[str, ...], Positional, arg(metavar="SUITE")]
SuiteFile = Annotated[Path, Positional, arg(metavar="SUITE")]
RunFolder = Annotated[Path, Positional, arg(metavar="RUN")]
RunFolders = Annotated[tuple[Path, ...], Positional, arg(metavar="RUN")]
Seed = Annotated[int, Positional, arg(metavar="SEED")]
ObjectId = Annotated[str, Positional, arg(metavar="OBJECT")]
Address = Annotated[str, Positional, arg(metavar="ADDRESS")]
File = Annotated[Path, Positional, arg(metavar="FILE")]
Folder = Annotated[Path, Positional, arg(metavar="FOLDER")]
