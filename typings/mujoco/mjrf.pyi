"""MuJoCo's binding of Filament; its names are left unchecked."""

from typing import Any

def __getattr__(name: str) -> Any: ...
