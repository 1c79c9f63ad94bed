import sys
from dataclasses import replace

import numpy as np
import pytest

from probe.errors import MissingExtra, ModelFailed
from probe.perception.sam3 import NoWeights, Sam3
from tabletops import Block, paint

FRAME = paint([Block(1, (200, 200, 500, 500))])


@pytest.mark.slow
def test_a_point_gives_a_mask_of_the_pictures_size(tiny_sam3):
    model = Sam3(str(tiny_sam3), device="cpu")
    masks = [model.mask_at(FRAME, point) for point in ((300, 300), (300, 300), (900, 100))]
    for mask in masks:
        assert mask is None or (mask.dtype == bool and mask.shape == (1024, 1024))
    assert any(mask is not None for mask in masks)
    assert masks[0] is not None and masks[1] is not None and (masks[0] == masks[1]).all()


@pytest.mark.slow
def test_only_colours_are_read(tiny_sam3):
    model = Sam3(str(tiny_sam3), device="cpu")
    bare = replace(FRAME, depth=np.full_like(FRAME.depth, np.nan), labels=None, shares=None)
    seen, blind = model.mask_at(FRAME, (300, 300)), model.mask_at(bare, (300, 300))
    assert seen is not None and blind is not None and (seen == blind).all()


@pytest.mark.slow
def test_the_point_reaches_the_model_in_its_own_pixels(tiny_sam3):
    model = Sam3(str(tiny_sam3), device="cpu")
    given = []
    forward = model._model.forward

    def overhear(*args, **kwargs):
        given.append(kwargs["input_points"])
        return forward(*args, **kwargs)

    model._model.forward = overhear
    model.mask_at(FRAME, (767, 255))
    assert given[0].flatten().tolist() == pytest.approx([767.5 * 56 / 1024, 255.5 * 56 / 1024])


@pytest.mark.slow
def test_missing_weights_are_named_with_the_remedy(torchvision, tmp_path):
    with pytest.raises(NoWeights, match="accept the licence") as raised:
        Sam3(str(tmp_path))
    assert str(tmp_path) in str(raised.value)


@pytest.mark.slow
def test_a_device_that_is_not_there(tiny_sam3):
    with pytest.raises(ModelFailed, match="'elsewhere'"):
        Sam3(str(tiny_sam3), device="elsewhere")


def test_without_torch_the_extra_is_named(monkeypatch):
    monkeypatch.setitem(sys.modules, "torch", None)
    with pytest.raises(MissingExtra, match=r"'\.\[sam3\]'"):
        Sam3("anywhere")
