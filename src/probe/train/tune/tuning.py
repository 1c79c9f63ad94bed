"""How a model is trained. The defaults are the paper's."""

from __future__ import annotations

from dataclasses import dataclass
from math import inf
from typing import Literal

from probe.errors import BadData

_SEEDS = 2**32
"""NumPy takes so many."""


@dataclass(frozen=True)
class Tuning:
    """How a model is trained.

    Attributes:
        learning_rate: Of AdamW, at its highest.
        epochs: How often each example is seen.
        global_batch: Examples a step, over all processes.
        steps: How many, whatever that makes in epochs; by default as many as the epochs need.
        device_batch: Examples that a process takes at once; the rest of a step is accumulated.
        lora: Rank of LoRA's matrices; by default all weights are trained.
        schedule: How the learning rate goes down.
        warmup: Part of all steps in which it goes up, below 1.
        seed: Of the order of examples and of all else that is drawn.
        save_every: Steps between checkpoints, of which two are kept.
        save_memory: Compute activations twice rather than keep them.
        loaders: Processes that prepare batches ahead; 0 for none.
        cpu_bfloat16: Without a GPU, compute in bfloat16 if the processor has instructions for it.

    Raises:
        BadData: A value is out of its range.
    """

    learning_rate: float = 2e-5
    epochs: float = 2.0
    global_batch: int = 32
    steps: int | None = None
    device_batch: int = 1
    lora: int | None = None
    schedule: Literal["linear", "cosine", "constant"] = "linear"
    warmup: float = 0.0
    seed: int = 0
    save_every: int = 25
    save_memory: bool = True
    loaders: int = 0
    cpu_bfloat16: bool = False

    def __post_init__(self) -> None:
        """Refuse what trains nothing, or what libraries choke on."""
        for name, fits, remedy in (
            ("learning_rate", 0 < self.learning_rate < inf, "a number above 0"),
            ("epochs", 0 < self.epochs < inf, "a number above 0"),
            ("global_batch", self.global_batch >= 1, "1 or more"),
            ("steps", self.steps is None or self.steps >= 1, "1 or more, or leave it out"),
            ("device_batch", self.device_batch >= 1, "1 or more"),
            ("lora", self.lora is None or self.lora >= 1, "1 or more, or leave it out"),
            ("warmup", 0 <= self.warmup < 1, "a number from 0 to below 1"),
            ("seed", 0 <= self.seed < _SEEDS, f"a number from 0 to {_SEEDS - 1}"),
            ("save_every", self.save_every >= 1, "1 or more"),
            ("loaders", self.loaders >= 0, "0 or more"),
        ):
            if not fits:
                option = f"--{name.replace('_', '-')}"
                raise BadData(option, f"{getattr(self, name)} is out of range", f"Say {remedy}")

    def accumulation(self, processes: int) -> int:
        """Batches that a process takes before a step is made.

        Raises:
            BadData: They don't come out even.
        """
        at_once = self.device_batch * processes
        if self.global_batch % at_once:
            reason = f"{self.global_batch} isn't a multiple of {processes} x {self.device_batch}"
            remedy = "Choose --device-batch so that processes times it divide it"
            raise BadData("--global-batch", reason, remedy)
        return self.global_batch // at_once
