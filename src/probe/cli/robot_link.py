"""How the commands of `probe robot` get to a robot's bridge."""

from __future__ import annotations

from pathlib import Path

from probe.errors import BadData
from probe.reading import words

TOKEN_FILE = Path("outputs/twin/token")


def token_in(path: Path) -> str:
    """The token that a bridge asks for.

    Raises:
        BadData: The file can't be read.
    """
    try:
        return words(path).strip()
    except (OSError, ValueError) as error:
        raise BadData(path, str(error), "Name the bridge's token with --token-file") from error
