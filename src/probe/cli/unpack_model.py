"""`probe unpack-model`: packed weights as a folder that `probe train` takes."""

from __future__ import annotations

from pathlib import Path

from probe.cli.metavars import Folder
from probe.cli.screen import say
from probe.train.tune.packed import installed_weights, unpack


def unpack_model(out: Folder, weights: Path | None = None) -> None:
    """Turn a language model's packed weights (GGUF) into an ordinary folder, once.

    It gets Qwen's chat template, which tells calls and replies of tools. Such a model sees no
    pictures: it is for the setting text-only.

    Args:
        out: A new folder.
        weights: A GGUF file; by default that of SmolLM2-135M-Instruct, which `make .venv/.student`
            installs.
    """
    file = weights or installed_weights()
    count = unpack(file, out)
    say(f"A model of {count / 1e6:.1f} million weights is in {out}, from {file.name}.")
