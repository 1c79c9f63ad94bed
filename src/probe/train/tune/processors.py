"""What stands before a model: a processor that reads words and pictures, or a tokenizer alone."""

from __future__ import annotations

from importlib.resources import files
from pathlib import Path
from typing import Any

from probe.train.tune import libraries


def sees(processor: Any) -> bool:
    """Whether it takes pictures; that of a language model is a tokenizer, which takes none."""
    return hasattr(processor, "image_processor")


def tokenizer_of(processor: Any) -> Any:
    """Its tokenizer, which may be itself."""
    return processor.tokenizer if sees(processor) else processor


def qwen_template() -> str:
    """Qwen3-VL's chat template, as TRL ships it: calls as `<tool_call>`, lists of parts.

    It is that of models without pictures here as well, so that calls have one form.
    """
    folder = Path(str(files(libraries.trl()) / "chat_templates"))
    return (folder / "qwen3_vl.jinja").read_text("utf-8")
