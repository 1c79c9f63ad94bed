"""What the harness leaves open is collected within the test that it belongs to."""

from __future__ import annotations

import gc
from collections.abc import Generator

import pytest


@pytest.fixture(autouse=True)
def collected() -> Generator[None]:
    """Otherwise it is collected when pytest ends, where each warning is an error."""
    yield
    gc.collect()
