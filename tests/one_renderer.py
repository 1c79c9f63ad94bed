"""One render worker and one library for all tests of a module."""

import pytest

from probe.assets.library import Library, open_library
from probe.render.renderer import Renderer


@pytest.fixture(scope="module")
def renderer():
    with Renderer() as it:
        yield it


@pytest.fixture(scope="module")
def library(cache) -> Library:
    return open_library("procedural", None, cache)
