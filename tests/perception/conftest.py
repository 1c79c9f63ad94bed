"""A tiny SAM 3 with random weights, as a folder; and torchvision where its kernels are missing."""

from __future__ import annotations

import pytest

from probe.errors import MissingExtra
from probe.train.tune import libraries


@pytest.fixture(scope="session")
def torchvision():
    """Torchvision, importable also where the package index has no build for this torch."""
    try:
        libraries.transformers()
    except MissingExtra as missing:
        pytest.skip(str(missing))


@pytest.fixture(scope="session")
def tiny_sam3(torchvision, tmp_path_factory):
    """A folder with a processor and a random model of 56 x 56 pixels."""
    transformers = pytest.importorskip("transformers")
    torch = pytest.importorskip("torch")
    torch.manual_seed(3)
    vision = {
        "model_type": "sam3_vision_model",
        "backbone_config": {
            "model_type": "sam3_vit_model",
            "hidden_size": 16,
            "intermediate_size": 16,
            "num_hidden_layers": 1,
            "num_attention_heads": 2,
            "image_size": 56,
            "pretrain_image_size": 56,
            "patch_size": 14,
            "window_size": 2,
            "global_attn_indexes": [0],
        },
        "fpn_hidden_size": 32,
        "backbone_feature_sizes": [[16, 16], [8, 8], [4, 4]],
    }
    prompts = {"hidden_size": 32, "image_size": 56, "patch_size": 14, "mask_input_channels": 4}
    decoder = {
        "hidden_size": 32,
        "mlp_dim": 16,
        "num_hidden_layers": 1,
        "num_attention_heads": 2,
        "iou_head_hidden_dim": 8,
        "dynamic_multimask_via_stability": False,
    }
    config = transformers.Sam3TrackerConfig(
        vision_config=vision, prompt_encoder_config=prompts, mask_decoder_config=decoder
    )
    folder = tmp_path_factory.mktemp("sam3")
    transformers.Sam3TrackerModel(config).save_pretrained(folder)
    small = transformers.Sam3ImageProcessor(
        size={"height": 56, "width": 56}, mask_size={"height": 16, "width": 16}
    )
    transformers.Sam3TrackerProcessor(small).save_pretrained(folder)
    return folder
