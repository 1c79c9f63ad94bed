"""Whether a file's numbers make sense in a unit of length, and which unit would."""

from __future__ import annotations

from pathlib import Path

from probe.assets.mesh.shaping import LARGEST, SMALLEST
from probe.errors import BadMesh

UNITS = {"m": (1.0, "metres"), "cm": (0.01, "centimetres"), "mm": (0.001, "millimetres")}
SHORT, LONG = 0.015, 0.45
"""Longest sides, metres, of what is at home on a table."""


def check_unit(path: Path, longest: float, unit: float) -> None:
    """Refuse what is absurdly large or small in its unit if another one would fit.

    Args:
        path: For the message.
        longest: Of the sides along the file's axes, in the file's numbers.
        unit: Metres per unit, as the file is read.

    Raises:
        BadMesh: It is over 2 m or under 5 mm long, and would be 1.5 to 45 cm in another unit.
    """
    if SMALLEST <= longest * unit <= LARGEST:
        return
    fitting = {
        name: (metres * longest, word)
        for name, (metres, word) in UNITS.items()
        if SHORT <= metres * longest <= LONG
    }
    if not fitting:
        return
    size = longest * unit
    told = f"{size:.3g} m" if size >= 1 else f"{1000 * size:.3g} mm"
    taken = next((word for metres, word in UNITS.values() if metres == unit), f"units of {unit} m")
    meant = " or ".join(word for _, word in fitting.values())
    reason = f"its longest side is {told}. It looks like {meant} taken for {taken}"
    ways = " or ".join(
        f"--unit {name} ({100 * side:.3g} cm)" for name, (side, _) in fitting.items()
    )
    raise BadMesh(path, reason, f"Say {ways}.")
