"""What a very small model is made of: tokenizer, processor, weights by chance."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

from probe.train.tune import libraries
from probe.train.tune.processors import qwen_template, sees, tokenizer_of

_SPECIAL = (
    "<|endoftext|>", "<|im_start|>", "<|im_end|>", "<|vision_start|>", "<|vision_end|>",
    "<|image_pad|>", "<|video_pad|>", "<tool_call>", "</tool_call>", "<tool_response>",
    "</tool_response>",
)  # fmt: skip
"""Tokens that Qwen's template and processor name; the last four aren't special to a decoder."""

_UNSPECIAL = 4


@dataclass(frozen=True)
class Shape:
    """How small it is.

    Attributes:
        width: Of the language model.
        layers: Of it.
        heads: Of its attention.
        words: Tokens of its own tokenizer.
        vision_width, vision_layers: Of the part that sees.
        side_px: To which pictures are made smaller; 32 pixels are a token's side.
        seed: Of the weights.
        pictures: Whether it takes some; else it is a language model of Llama's architecture.
    """

    width: int = 192
    layers: int = 4
    heads: int = 4
    words: int = 3000
    vision_width: int = 96
    vision_layers: int = 3
    side_px: int = 128
    seed: int = 0
    pictures: bool = True


def _tokenizer(texts: Iterator[str], words: int) -> Any:
    parts = libraries.part("tokenizers")
    made = parts.Tokenizer(parts.models.BPE())
    # Qwen's: digits stand alone, and a line break is part of the full stop before it, so that the
    # one before a call isn't the one in it.
    qwen = libraries.transformers().Qwen2Tokenizer().backend_tokenizer
    made.pre_tokenizer = qwen.pre_tokenizer
    made.decoder = parts.decoders.ByteLevel()
    trainer = parts.trainers.BpeTrainer(
        vocab_size=words,
        initial_alphabet=parts.pre_tokenizers.ByteLevel.alphabet(),
        special_tokens=list(_SPECIAL[:-_UNSPECIAL]),
        show_progress=False,
    )
    made.train_from_iterator(texts, trainer)
    made.add_tokens(list(_SPECIAL[-_UNSPECIAL:]))
    return libraries.transformers().PreTrainedTokenizerFast(
        tokenizer_object=made,
        eos_token="<|im_end|>",
        pad_token="<|endoftext|>",
        additional_special_tokens=list(_SPECIAL[1:-_UNSPECIAL]),
    )


def processor_for(texts: Iterator[str], shape: Shape) -> Any:
    """A processor of Qwen3-VL's kind with a tokenizer of its own, or that alone.

    Args:
        texts: That the tokenizer is trained on.
        shape: How small pictures are made.
    """
    tokenizer = _tokenizer(texts, shape.words)
    transformers = libraries.transformers()
    pixels = shape.side_px**2
    template = qwen_template()
    if not shape.pictures:
        tokenizer.chat_template = template
        return tokenizer
    pictures = transformers.Qwen2VLImageProcessor(
        patch_size=16, merge_size=2, min_pixels=32 * 32, max_pixels=pixels
    )
    videos = transformers.Qwen3VLVideoProcessor(patch_size=16, merge_size=2)
    return transformers.Qwen3VLProcessor(pictures, tokenizer, videos, chat_template=template)


def untrained(processor: Any, shape: Shape) -> Any:
    """A model with weights by chance, of Qwen3-VL's architecture or, for a tokenizer, Llama's."""
    libraries.torch().manual_seed(shape.seed)
    tokenizer = tokenizer_of(processor)
    made = _seeing(tokenizer, shape) if sees(processor) else _unseeing(tokenizer, shape)
    made.generation_config.eos_token_id = tokenizer.eos_token_id
    made.generation_config.pad_token_id = tokenizer.pad_token_id
    return made


def _language(tokenizer: Any, shape: Shape) -> dict[str, Any]:
    """What both architectures call by the same names."""
    return {
        "vocab_size": len(tokenizer),
        "hidden_size": shape.width,
        "intermediate_size": 3 * shape.width,
        "num_hidden_layers": shape.layers,
        "num_attention_heads": shape.heads,
        "num_key_value_heads": shape.heads,
        "head_dim": shape.width // shape.heads,
        "max_position_embeddings": 65536,
        "pad_token_id": tokenizer.pad_token_id,
        "eos_token_id": tokenizer.eos_token_id,
        "bos_token_id": None,
    }


def _unseeing(tokenizer: Any, shape: Shape) -> Any:
    transformers = libraries.transformers()
    config = transformers.LlamaConfig(**_language(tokenizer, shape), tie_word_embeddings=True)
    return transformers.LlamaForCausalLM(config)


def _seeing(tokenizer: Any, shape: Shape) -> Any:
    transformers = libraries.transformers()
    word = tokenizer.convert_tokens_to_ids
    head = shape.width // shape.heads
    config = transformers.Qwen3VLConfig(
        text_config={
            **_language(tokenizer, shape),
            # Halves of a head's dimensions, shared between time, height and width.
            "rope_parameters": {
                "rope_type": "default",
                "rope_theta": 500000.0,
                "mrope_section": [head // 2 - 2 * (head // 6), head // 6, head // 6],
                "mrope_interleaved": True,
            },
        },
        vision_config={
            "depth": shape.vision_layers,
            "hidden_size": shape.vision_width,
            "intermediate_size": 2 * shape.vision_width,
            "num_heads": 4,
            "out_hidden_size": shape.width,
            "num_position_embeddings": 16 * 16,
            "deepstack_visual_indexes": [1],
        },
        image_token_id=word("<|image_pad|>"),
        video_token_id=word("<|video_pad|>"),
        vision_start_token_id=word("<|vision_start|>"),
        vision_end_token_id=word("<|vision_end|>"),
        tie_word_embeddings=True,
    )
    return transformers.Qwen3VLForConditionalGeneration(config)
