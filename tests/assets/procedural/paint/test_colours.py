import numpy as np
import pytest

from probe.assets.procedural.paint.colours import NAMED, rgb
from probe.errors import UnknownName


def test_hexadecimal() -> None:
    np.testing.assert_allclose(rgb("#ff8000"), [1, 128 / 255, 0], atol=1e-6)


@pytest.mark.parametrize("name", NAMED)
def test_shades_are_ordered(name: str) -> None:
    dark, plain, light = (float(rgb(f"{s} {name}".strip()).mean()) for s in ("dark", "", "light"))
    assert dark < plain < light + 0.01


def test_an_unknown_colour_is_refused() -> None:
    with pytest.raises(UnknownName, match="mauve"):
        rgb("pale mauve")
