"""The libraries that train and run models; imported when they are first needed."""

from __future__ import annotations

from functools import lru_cache
from importlib import import_module
from importlib.metadata import version
from typing import Any

from probe.errors import MissingExtra

EXTRA = "train"
USED = ("torch", "torchvision", "transformers", "trl", "peft", "accelerate", "datasets")
"""What the extra installs, and a run card tells the versions of."""

_OPERATORS = (
    "nms(Tensor dets, Tensor scores, float iou_threshold) -> Tensor",
    "qnms(Tensor dets, Tensor scores, float iou_threshold) -> Tensor",
)


def torch() -> Any:
    """PyTorch.

    Raises:
        MissingExtra: It isn't installed.
    """
    return _imported("torch")


@lru_cache(1)
def transformers() -> Any:
    """Transformers, with a torchvision that its processors can import.

    Raises:
        MissingExtra: One of them isn't installed.
    """
    made = _imported("torch")
    try:
        _imported("torchvision")
    except RuntimeError as error:
        if "torchvision::" not in str(error):
            raise
        _declare(made)
    library = _imported("transformers")
    library.utils.logging.disable_progress_bar()
    return library


def trl() -> Any:
    """TRL.

    Raises:
        MissingExtra: It isn't installed.
    """
    transformers()
    return _imported("trl")


def computes_in_bfloat16() -> bool:
    """Whether there is a GPU that does; older ones only make as if, slowly."""
    cuda = torch().cuda
    return bool(cuda.is_available() and cuda.is_bf16_supported(including_emulation=False))


def cpu_computes_in_bfloat16() -> bool:
    """Whether this machine's processor has instructions for it; others only make as if."""
    known = torch().cpu.get_capabilities()
    return bool(known.get("avx512_bf16") or known.get("amx_bf16"))


def attend_to_any_length() -> None:
    """Keep attention from cuDNN, which builds a plan for each length of text that it hasn't seen.

    Nearly every conversation has a length of its own. On an H200 the plans of a batch took a
    second, where the batch itself takes a tenth (docs/results/log.md, 2026-11-27).
    """
    torch().backends.cuda.enable_cudnn_sdp(False)


def part(name: str) -> Any:
    """Another one, or a part of one, by its full name.

    Raises:
        MissingExtra: It isn't installed.
    """
    transformers()
    return _imported(name)


def versions() -> dict[str, str]:
    """Of all libraries that the extra installs."""
    return {name: version(name) for name in USED}


_KEPT: list[Any] = []


def _declare(made: Any) -> None:
    """Name the operators that a torchvision built for another torch looks for at import.

    Package indexes without builds for CPUs have such pairs. None of these operators is called
    here: pictures are resized by torch alone.
    """
    library = made.library.Library("torchvision", "DEF")
    for operator in _OPERATORS:
        library.define(operator)
    _KEPT.append(library)  # what it declares lasts as long as it does
    _imported("torchvision")


def _imported(name: str) -> Any:
    try:
        return import_module(name)
    except ImportError as error:
        raise MissingExtra("Training and serving models", EXTRA) from error
