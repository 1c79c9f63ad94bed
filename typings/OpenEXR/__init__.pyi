"""OpenEXR ships no types; its names are left unchecked."""

from typing import Any

def __getattr__(name: str) -> Any: ...
