"""A model and its processor in memory, for training and for serving."""

from __future__ import annotations

from typing import Any

from probe.errors import ProbeError
from probe.train.tune import libraries
from probe.train.tune.collating import Collator
from probe.train.tune.processors import sees, tokenizer_of


class NoModel(ProbeError):
    """There is no model to start from."""

    def __init__(self, model: str, reason: str) -> None:
        super().__init__(
            f"{model} can't be loaded as a model ({reason}). Name a whole folder, or a model "
            "at Hugging Face such as Qwen/Qwen3-VL-8B-Instruct."
        )


class UnknownTemplate(ProbeError):
    """Nobody knows where the assistant's turns are in what a chat template writes."""

    def __init__(self, model: str) -> None:
        super().__init__(
            f"TRL can't mark the assistant's turns in the chat template of {model}. Give it Qwen's "
            "as it was published, or one with {% generation %} around these turns."
        )


def load(model: str, *, exact: bool = False, cpu_bfloat16: bool = False) -> tuple[Any, Any]:
    """A model and its processor; a language model has a tokenizer in that place.

    Args:
        model: A folder, or a name at Hugging Face.
        exact: Its weights in float32, as they must be to be trained: bfloat16 has no room for
            most small steps. Else in bfloat16, if a GPU computes so.
        cpu_bfloat16: In bfloat16 also if there is no GPU and the processor computes so.

    Raises:
        MissingExtra: A library isn't installed.
        NoModel: It can't be loaded.
    """
    torch, transformers = libraries.torch(), libraries.transformers()
    libraries.attend_to_any_length()
    cut_off: Any = libraries.part("safetensors").SafetensorError
    short = libraries.computes_in_bfloat16() or (
        cpu_bfloat16 and libraries.cpu_computes_in_bfloat16()
    )
    kind = torch.bfloat16 if short and not exact else torch.float32
    try:
        processor = transformers.AutoProcessor.from_pretrained(model)
        wide = transformers.AutoModelForImageTextToText
        family = wide if sees(processor) else transformers.AutoModelForCausalLM
        loaded = family.from_pretrained(model, dtype=kind)
    except (OSError, ValueError, RuntimeError, cut_off) as error:
        raise NoModel(model, str(error).split("\n")[0]) from error
    return loaded, processor


def collator_for(processor: Any) -> Collator:
    """What makes batches for a model; its template is TRL's, with the assistant's turns marked.

    Raises:
        UnknownTemplate: TRL can't mark them.
    """
    templates = libraries.part("trl.chat_template_utils")
    named = str(tokenizer_of(processor).name_or_path)
    if processor.chat_template is None:
        raise UnknownTemplate(named)
    try:
        marked: Any = templates.get_training_chat_template(processor)
    except ValueError as error:
        raise UnknownTemplate(named) from error
    return Collator(processor, marked or processor.chat_template)
