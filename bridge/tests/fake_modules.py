"""Puts stand-ins for robots' libraries where drivers import them from."""

from __future__ import annotations

import sys
from types import ModuleType
from typing import Any, Dict

import pytest


def install(monkeypatch: pytest.MonkeyPatch, modules: Dict[str, Dict[str, Any]]) -> None:
    """Make modules importable, with what they hold; packages above them too."""
    for name, content in modules.items():
        parts = name.split(".")
        for depth in range(1, len(parts)):
            above = ".".join(parts[:depth])
            if above not in modules:
                monkeypatch.setitem(sys.modules, above, ModuleType(above))
        module = ModuleType(name)
        vars(module).update(content)
        monkeypatch.setitem(sys.modules, name, module)


def until(done: Any, seconds: float = 10.0) -> None:
    """Wait until something is true."""
    import time

    deadline = time.monotonic() + seconds
    while not done():
        assert time.monotonic() < deadline, "it never came"
        time.sleep(0.005)
