"""How a training is told to TRL."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from probe.errors import BadData
from probe.train.tune import libraries
from probe.train.tune.started import CHECKPOINTS
from probe.train.tune.tuning import Tuning

_KEPT = 2
"""Checkpoints: the last one may be cut off."""


def settings_for(out: Path, tuning: Tuning) -> Any:
    """What TRL's trainer is told.

    Args:
        out: The training's folder.
        tuning: How a model is trained.

    Raises:
        BadData: The batch doesn't come out even over the processes that there are, one process
            sees several GPUs, or several would share LoRA's matrices.
    """
    gpu = bool(libraries.torch().cuda.is_available())
    # Without being told, it takes several processes without GPUs for as many trainings.
    state = libraries.part("accelerate").PartialState(cpu=not gpu)
    _one_gpu_each(str(state.distributed_type.value))
    _one_alone_with_lora(tuning, int(state.num_processes))
    return libraries.trl().SFTConfig(
        output_dir=str(out / CHECKPOINTS),
        learning_rate=tuning.learning_rate,
        num_train_epochs=tuning.epochs,
        max_steps=-1 if tuning.steps is None else tuning.steps,
        per_device_train_batch_size=tuning.device_batch,
        gradient_accumulation_steps=tuning.accumulation(int(state.num_processes)),
        lr_scheduler_type=tuning.schedule,
        warmup_steps=tuning.warmup,
        seed=tuning.seed,
        data_seed=tuning.seed,
        bf16=_short(tuning, gpu=gpu),
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
        logging_nan_inf_filter=False,  # it logs 0 instead
        include_num_input_tokens_seen="non_padding",
        save_strategy="steps",
        save_steps=tuning.save_every,
        save_total_limit=_KEPT,
        report_to="none",
        disable_tqdm=False,
    )


def _short(tuning: Tuning, *, gpu: bool) -> bool:
    """Whether is computed in bfloat16; the weights stay in float32."""
    if gpu:
        return libraries.computes_in_bfloat16()
    return tuning.cpu_bfloat16 and libraries.cpu_computes_in_bfloat16()


def _one_gpu_each(distributed: str) -> None:
    gpus = int(libraries.torch().cuda.device_count())
    if distributed == "NO" and gpus > 1:
        remedy = "Start it through accelerate (docs/how-to/train.md), or set CUDA_VISIBLE_DEVICES=0"
        raise BadData("GPUs", f"one process sees {gpus}", remedy)


def _one_alone_with_lora(tuning: Tuning, processes: int) -> None:
    """Matrices that several GPUs divide among them can't be merged by one of them."""
    if tuning.lora is not None and processes > 1:
        remedy = "Train on one GPU (gpu_1.yaml), or all weights"
        raise BadData("--lora", f"can't be shared by {processes} processes", remedy)
