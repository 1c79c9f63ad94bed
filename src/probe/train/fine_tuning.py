"""Trains a model on a data set with TRL: all weights or LoRA's, loss on the assistant's turns."""

from __future__ import annotations

import shutil
from pathlib import Path
from typing import Any

from probe.errors import ProbeError
from probe.train import libraries
from probe.train.collating import Collator
from probe.train.diary import diary_callback
from probe.train.manifest import Manifest, check_dataset
from probe.train.run_card import write_card
from probe.train.started import MODEL, ROWS, begun, last_checkpoint, take_up
from probe.train.trainer_settings import settings_for
from probe.train.tuning import Tuning


class NoModel(ProbeError):
    """There is no model to start from."""

    def __init__(self, model: str, reason: str) -> None:
        super().__init__(
            f"{model} can't be loaded as a vision-language model ({reason}). Name a folder, or a "
            "model at Hugging Face such as Qwen/Qwen3-VL-8B-Instruct."
        )


def train(dataset: Path, model: str, out: Path, tuning: Tuning, types: tuple[str, ...]) -> Path:
    """Train a model, or go on with it; returns the folder of the trained one.

    Args:
        dataset: That `probe dataset` wrote.
        model: A folder, or a name at Hugging Face.
        out: Folder for checkpoints, the loss, the model and its card.
        tuning: How.
        types: Of which there must be examples, besides those that the manifest names.

    Raises:
        BadData: Something is wrong with the data set, or the folder is another training's.
        MissingExtra: A library isn't installed.
        NoModel: The model can't be loaded.
    """
    manifest = check_dataset(dataset, types)
    asked = begun(dataset, model, tuning)
    if (out / MODEL).exists():
        take_up(out, asked)
        return out / MODEL
    loaded, processor = load(model)
    take_up(out, asked)
    rows = _rows(dataset, out, manifest)
    trainer = _trainer(loaded, processor, rows, out, tuning)
    last = last_checkpoint(out)
    trainer.train(resume_from_checkpoint=str(last) if last else None)
    _keep(trainer, out, tuning)
    if trainer.is_world_process_zero():
        write_card(out, asked, manifest)
        shutil.rmtree(out / ROWS, ignore_errors=True)
    return out / MODEL


def load(model: str) -> tuple[Any, Any]:
    """A model and its processor.

    Raises:
        MissingExtra: A library isn't installed.
        NoModel: It can't be loaded.
    """
    torch, transformers = libraries.torch(), libraries.transformers()
    kind = torch.bfloat16 if torch.cuda.is_available() else torch.float32
    try:
        processor = transformers.AutoProcessor.from_pretrained(model)
        loaded = transformers.AutoModelForImageTextToText.from_pretrained(model, dtype=kind)
    except (OSError, ValueError) as error:
        raise NoModel(model, str(error).split("\n")[0]) from error
    return loaded, processor


def collator_for(processor: Any) -> Collator:
    """What makes batches for a model; its template is TRL's, with the assistant's turns marked."""
    templates = libraries.part("trl.chat_template_utils")
    marked: Any = templates.get_training_chat_template(processor)
    return Collator(processor, marked or processor.chat_template)


def _trainer(loaded: Any, processor: Any, rows: Any, out: Path, tuning: Tuning) -> Any:
    trl = libraries.trl()
    peft = None
    if tuning.lora is not None:
        peft = libraries.part("peft").LoraConfig(
            r=tuning.lora,
            lora_alpha=2 * tuning.lora,
            target_modules="all-linear",
            task_type="CAUSAL_LM",
        )
    return trl.SFTTrainer(
        model=loaded,
        args=settings_for(out, tuning),
        train_dataset=rows,
        processing_class=processor,
        data_collator=collator_for(processor),
        peft_config=peft,
        callbacks=[diary_callback(out)],
    )


def _rows(dataset: Path, out: Path, manifest: Manifest) -> Any:
    data = libraries.part("datasets")
    data.disable_progress_bars()
    files = sorted(str(dataset / name) for name in manifest.files if name.endswith(".parquet"))
    return data.Dataset.from_parquet(files, cache_dir=str(out / ROWS))


def _keep(trainer: Any, out: Path, tuning: Tuning) -> None:
    """Save the model whole, LoRA's matrices merged into it; the folder appears when it is whole."""
    growing = out / f".{MODEL}"
    if tuning.lora is not None:
        trainer.save_model(str(out / "adapter"))
        merged = trainer.accelerator.unwrap_model(trainer.model).merge_and_unload()
        if trainer.is_world_process_zero():
            merged.save_pretrained(str(growing))
    else:
        trainer.save_model(str(growing))
    trainer.accelerator.wait_for_everyone()
    if trainer.is_world_process_zero():
        trainer.processing_class.save_pretrained(str(growing))
        growing.rename(out / MODEL)
