"""How a training is told to TRL."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from probe.train import libraries
from probe.train.started import CHECKPOINTS
from probe.train.tuning import Tuning

_KEPT = 2
"""Checkpoints: the last one may be cut off."""


def settings_for(out: Path, tuning: Tuning) -> Any:
    """What TRL's trainer is told.

    Args:
        out: The training's folder.
        tuning: How a model is trained.

    Raises:
        BadData: The batch doesn't come out even over the processes that there are.
    """
    processes = int(libraries.part("accelerate").PartialState().num_processes)
    gpu = bool(libraries.torch().cuda.is_available())
    return libraries.trl().SFTConfig(
        output_dir=str(out / CHECKPOINTS),
        learning_rate=tuning.learning_rate,
        num_train_epochs=tuning.epochs,
        per_device_train_batch_size=tuning.device_batch,
        gradient_accumulation_steps=tuning.accumulation(processes),
        lr_scheduler_type=tuning.schedule,
        warmup_steps=tuning.warmup,
        seed=tuning.seed,
        data_seed=tuning.seed,
        bf16=gpu,
        use_cpu=not gpu,
        gradient_checkpointing=tuning.save_memory,
        assistant_only_loss=True,
        max_length=None,  # what is cut off may be a picture
        packing=False,
        remove_unused_columns=False,
        dataset_kwargs={"skip_prepare_dataset": True},
        dataloader_pin_memory=gpu,
        dataloader_num_workers=tuning.loaders,
        logging_steps=1,
        save_strategy="steps",
        save_steps=tuning.save_every,
        save_total_limit=_KEPT,
        report_to="none",
        disable_tqdm=False,
    )
