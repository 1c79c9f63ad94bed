"""One render worker for all tests of a module: starting one costs a second."""

import pytest

from probe.render.renderer import Renderer


@pytest.fixture(scope="module")
def renderer():
    with Renderer() as it:
        yield it
