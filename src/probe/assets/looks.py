"""Versions of how what is made by formula looks. Shapes are the same in all of them."""

from __future__ import annotations

from typing import Literal

Looks = Literal[1, 2]
"""1 is clean and even, as in the suites v1, v1.1, v1-scans, behind and demo; 2 looks used."""

NEWEST_LOOKS: Looks = 2
