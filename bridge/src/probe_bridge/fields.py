"""Reads a dictionary from outside field by field, and says which field is wrong."""

from __future__ import annotations

import math
from typing import Any, Dict, List, Tuple, cast

from probe_bridge.errors import BridgeError

Vector = Tuple[float, float, float]


class Fields:
    """The fields of a dictionary from a file or the wire.

    Every method raises BridgeError "refused" that names the field.

    Args:
        raw: What came in; a dictionary with text keys is accepted.
        where: Its name in error messages.
    """

    def __init__(self, raw: object, where: str) -> None:
        self._where = where
        if not isinstance(raw, dict):
            raise self.wrong("", "is not a table of named fields")
        table = cast("Dict[object, object]", raw)
        if not all(isinstance(key, str) for key in table):
            raise self.wrong("", "has a name that is not text")
        self._left = cast("Dict[str, object]", dict(table))

    def wrong(self, name: str, problem: str) -> BridgeError:
        """The error that says what is wrong with a field."""
        where = f"{self._where}.{name}" if name else self._where
        return BridgeError("refused", f"{where} {problem}.")

    def take(self, name: str) -> Any:
        """A field of any type."""
        if name not in self._left:
            raise self.wrong(name, "is missing")
        return self._left.pop(name)

    def text(self, name: str) -> str:
        value = self.take(name)
        if not isinstance(value, str):
            raise self.wrong(name, "is not text")
        return value

    def flag(self, name: str) -> bool:
        value = self.take(name)
        if not isinstance(value, bool):
            raise self.wrong(name, "is neither true nor false")
        return value

    def whole(self, name: str, least: int, most: int) -> int:
        value = self.take(name)
        if isinstance(value, bool) or not isinstance(value, int) or not least <= value <= most:
            raise self.wrong(name, f"is not a whole number from {least} to {most}")
        return value

    def number(self, name: str, least: float = -1e6, most: float = 1e6) -> float:
        """A finite number within bounds."""
        return self._number(name, self.take(name), least, most)

    def numbers(self, name: str, count: int) -> Tuple[float, ...]:
        """So many finite numbers, at most 1e6 in size."""
        return self._numbers(name, self.take(name), count)

    def vector(self, name: str) -> Vector:
        x, y, z = self.numbers(name, 3)
        return x, y, z

    def rows(self, name: str, count: int, most: int) -> List[Tuple[float, ...]]:
        """Between 1 and `most` rows of so many numbers each."""
        value = self.take(name)
        if not isinstance(value, list) or not value:
            raise self.wrong(name, "is not a list of rows")
        rows = cast("List[object]", value)
        if len(rows) > most:
            raise self.wrong(name, f"has {len(rows)} rows, more than {most}")
        return [self._numbers(f"{name}[{i}]", row, count) for i, row in enumerate(rows)]

    def each(self, name: str) -> List[Fields]:
        """A list of tables, perhaps empty."""
        value = self.take(name)
        if not isinstance(value, list):
            raise self.wrong(name, "is not a list")
        items = cast("List[object]", value)
        return [Fields(item, f"{self._where}.{name}[{i}]") for i, item in enumerate(items)]

    def inner(self, name: str) -> Fields:
        return Fields(self.take(name), f"{self._where}.{name}")

    def end(self) -> None:
        """Refuse what nobody has taken."""
        if self._left:
            raise self.wrong(repr(sorted(self._left)[0])[:60], "is not a field that exists here")

    def _numbers(self, name: str, value: object, count: int) -> Tuple[float, ...]:
        row = cast("List[object]", value)
        if not isinstance(value, list) or len(row) != count:
            raise self.wrong(name, f"is not a list of {count} numbers")
        return tuple(self._number(f"{name}[{i}]", v, -1e6, 1e6) for i, v in enumerate(row))

    def _number(self, name: str, value: object, least: float, most: float) -> float:
        if isinstance(value, bool) or not isinstance(value, (int, float)):
            raise self.wrong(name, "is not a number")
        # An int may be too large for a float; so it is compared before it is converted.
        if not least <= value <= most or not math.isfinite(value):
            raise self.wrong(name, f"is not from {least:g} to {most:g}")
        return float(value)
