"""Masks from SAM 3: the thing under a pixel, by the weights of Meta's model. Needs torch.

The weights are gated: their licence has to be accepted on the model's page before a download.
"""

from __future__ import annotations

from importlib import import_module
from typing import Any

import numpy as np

from probe.errors import MissingExtra, ModelFailed, ProbeError
from probe.types import Array, Frame

WEIGHTS = "facebook/sam3"
"""Where Hugging Face keeps them."""


class NoWeights(ProbeError):
    """SAM 3's weights aren't where they were looked for."""

    def __init__(self, weights: str, reason: str) -> None:
        super().__init__(
            f"{weights}: SAM 3 can't be loaded ({reason}). Name a folder that holds its "
            f"weights and processor, or accept the licence on https://huggingface.co/{WEIGHTS}, "
            "then run `hf auth login` (or set HF_TOKEN)."
        )


class Sam3:
    """A Masker. It reads colours alone."""

    def __init__(self, weights: str = WEIGHTS, device: str | None = None) -> None:
        """Load the model.

        Args:
            weights: A folder with weights and processor, or a name at Hugging Face.
            device: As torch calls it ("cpu", "cuda:0"); None for a GPU if there is one.

        Raises:
            MissingExtra: torch, torchvision or transformers aren't installed.
            NoWeights: They can't be found, or their licence hasn't been accepted.
            ModelFailed: torch doesn't know the device, or doesn't fit torchvision.
        """
        self._torch, transformers = _libraries()
        try:
            self._processor = transformers.Sam3TrackerProcessor.from_pretrained(weights)
            model = transformers.Sam3TrackerModel.from_pretrained(weights)
        except (OSError, ValueError) as error:
            raise NoWeights(weights, str(error).split("\n")[0]) from error
        self._device = device or ("cuda" if self._torch.cuda.is_available() else "cpu")
        try:
            self._model = model.to(self._device).eval()
        except (RuntimeError, AssertionError) as error:
            raise ModelFailed(f"device {self._device!r}: {str(error).splitlines()[0]}") from error

    def mask_at(self, frame: Frame, point_px: tuple[int, int]) -> Array | None:
        """Visible pixels of the thing at (u, v), bool, shape (h, w); None if there is none.

        Of the three masks that a lone point gives, the one that the model thinks best of; of its
        parts, all.
        """
        assert frame.rgb is not None
        u, v = point_px
        inputs = self._processor(
            images=frame.rgb,
            input_points=[[[[u + 0.5, v + 0.5]]]],
            input_labels=[[[1]]],
            return_tensors="pt",
        ).to(self._device)
        with self._torch.inference_mode():
            outputs = self._model(**inputs, multimask_output=True)
        masks = self._processor.post_process_masks(outputs.pred_masks, inputs["original_sizes"])
        best = int(outputs.iou_scores[0, 0].argmax())
        mask = np.asarray(masks[0][0, best].cpu().numpy(), dtype=bool)
        return mask if mask.any() else None


def _libraries() -> tuple[Any, Any]:
    """torch and transformers, which ship half of their types.

    Raises:
        MissingExtra: One of the packages isn't installed.
        ModelFailed: torchvision was built for another torch.
    """
    try:
        torch = import_module("torch")
        import_module("torchvision")  # asked for by the processor, whose own message misleads
        return torch, import_module("transformers")
    except ImportError as error:
        raise MissingExtra("Masks from SAM 3", "sam3") from error
    except RuntimeError as error:
        raise ModelFailed(
            f"torchvision doesn't fit torch ({error}). Install both from one index, as "
            "https://pytorch.org says."
        ) from error
