"""One render worker for all tests of a module; one library, whose palettes are kept, for all."""

import pytest

from probe.assets.library import Library, open_library
from probe.render.renderer import Renderer


@pytest.fixture(scope="module")
def renderer():
    with Renderer() as it:
        yield it


@pytest.fixture(scope="session")
def library(cache) -> Library:
    return open_library("procedural", None, cache)
