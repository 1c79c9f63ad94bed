"""Trains a model on a data set with TRL: all weights or LoRA's, loss on the turns to be learnt."""

from __future__ import annotations

import shutil
from contextlib import nullcontext
from pathlib import Path
from typing import Any

from probe.episodes.folder import reserved
from probe.errors import BadData
from probe.train.dataset.manifest import Manifest, check_dataset
from probe.train.tune import libraries
from probe.train.tune.by_blocks import attend_by_blocks
from probe.train.tune.learnt_tokens import trainer_on_cpu
from probe.train.tune.loading import collator_for, load
from probe.train.tune.processors import sees
from probe.train.tune.run_card import write_card
from probe.train.tune.started import (
    MODEL,
    ROWS,
    TRAINING,
    TrainingStart,
    begun,
    last_checkpoint,
    take_up,
)
from probe.train.tune.trainer_settings import settings_for
from probe.train.tune.training_log import diary_callback
from probe.train.tune.tuning import Tuning


def train(dataset: Path, model: str, out: Path, tuning: Tuning, types: tuple[str, ...]) -> Path:
    """Train a model, or go on with it; returns the folder of the trained one.

    Args:
        dataset: That `probe dataset` wrote.
        model: A folder, or a name at Hugging Face.
        out: Folder for checkpoints, the loss, the model and its card.
        tuning: How.
        types: Of which there must be examples, besides those that the manifest names.

    Raises:
        BadData: Something is wrong with the data set, the folder is another training's, one is at
            work there, the settings don't fit this machine, or the loss isn't finite.
        MissingExtra: A library isn't installed.
        NoModel: The model can't be loaded.
        UnknownTemplate: Nobody knows what to take its loss on.
    """
    manifest = check_dataset(dataset, types)
    asked = begun(dataset, model, tuning)
    if (out / MODEL).exists():
        take_up(out, asked)
        return out / MODEL
    # Before the model: then of several processes one alone reads its weights.
    settings = settings_for(out, tuning)
    loaded, processor = load(model, exact=tuning.lora is None)
    if manifest.pictures and not sees(processor):
        reason = f"shows {manifest.pictures} pictures, and {model} takes none"
        raise BadData(dataset, reason, "Write it with --setting text-only")
    collator = collator_for(processor)
    take_up(out, asked)
    with reserved(out, TRAINING) if settings.process_index == 0 else nullcontext():
        trainer = _trainer_for(loaded, bfloat16=bool(settings.bf16))(
            model=loaded,
            args=settings,
            train_dataset=_rows(dataset, out, manifest, pictures=sees(processor)),
            processing_class=processor,
            data_collator=collator,
            peft_config=_lora(tuning),
            callbacks=[diary_callback(out)],
        )
        last = last_checkpoint(out)
        trainer.train(resume_from_checkpoint=str(last) if last else None)
        _finish(trainer, out, asked, manifest)
    return out / MODEL


def _finish(trainer: Any, out: Path, asked: TrainingStart, manifest: Manifest) -> None:
    """Save the model and its card."""
    weights = _numbers(trainer.model)
    growing = _saved(trainer, out, lora=asked.tuning["lora"] is not None)
    if trainer.is_world_process_zero():
        computed = "bfloat16" if trainer.args.bf16 else weights
        write_card(out, asked, manifest, weights, computed)
        shutil.rmtree(out / ROWS, ignore_errors=True)
        growing.rename(out / MODEL)  # at the very end: where it is, nothing is left to do


def _trainer_for(loaded: Any, *, bfloat16: bool) -> Any:
    """TRL's trainer; on a processor, one that doesn't waste its time."""
    if libraries.torch().cuda.is_available():
        return libraries.trl().SFTTrainer
    if bfloat16:
        attend_by_blocks(loaded)
    return trainer_on_cpu()


def _lora(tuning: Tuning) -> Any:
    if tuning.lora is None:
        return None
    return libraries.part("peft").LoraConfig(
        r=tuning.lora,
        lora_alpha=2 * tuning.lora,
        target_modules="all-linear",
        task_type="CAUSAL_LM",
    )


def _rows(dataset: Path, out: Path, manifest: Manifest, *, pictures: bool) -> Any:
    data = libraries.part("datasets")
    data.disable_progress_bars()
    files = sorted(str(dataset / name) for name in manifest.files if name.endswith(".parquet"))
    rows = data.Dataset.from_parquet(files, cache_dir=str(out / ROWS))
    # By this column TRL knows a data set for models that see.
    return rows if pictures else rows.remove_columns("images")


def _numbers(model: Any) -> str:
    """Of what type the weights are that were trained."""
    kinds = {str(it.dtype) for it in model.parameters() if it.requires_grad}
    return ", ".join(sorted(kind.removeprefix("torch.") for kind in kinds))


def _saved(trainer: Any, out: Path, *, lora: bool) -> Path:
    """Save the whole model, LoRA's matrices merged into it, into a hidden folder."""
    growing = out / f".{MODEL}"
    if lora:
        trainer.save_model(str(out / "adapter"))
        merged = trainer.accelerator.unwrap_model(trainer.model).merge_and_unload()
        if trainer.is_world_process_zero():
            merged.save_pretrained(str(growing))
    else:
        trainer.save_model(str(growing))
    trainer.accelerator.wait_for_everyone()
    if trainer.is_world_process_zero():
        trainer.processing_class.save_pretrained(str(growing))
    return growing
