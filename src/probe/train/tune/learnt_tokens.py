"""A trainer for processors that compares no token with the vocabulary but those that are learnt."""

from __future__ import annotations

from typing import Any

from probe.train.tune import libraries
from probe.train.tune.collating import IGNORED


def trainer_on_cpu() -> Any:
    """TRL's trainer with another loss; a class.

    TRL 1.16 compares all tokens of a conversation where there is no Triton, though a loss is taken
    on a fifth, and measures their entropy. On two cores that was half of a step
    (docs/results/log.md, 2026-11-29).
    """
    base: Any = libraries.trl().SFTTrainer

    class LearntTokensTrainer(base):
        """An SFTTrainer."""

        def compute_loss(
            self,
            model: Any,
            inputs: dict[str, Any],
            return_outputs: bool = False,
            num_items_in_batch: Any = None,
        ) -> Any:
            """Mean cross entropy over the tokens that are learnt, of all of a step's batches."""
            loss, outputs = learnt_loss(model, inputs, num_items_in_batch)
            if self.args.average_tokens_across_devices and num_items_in_batch is not None:
                loss = loss * self.accelerator.num_processes
            return (loss, outputs) if return_outputs else loss

    return LearntTokensTrainer


def learnt_loss(model: Any, inputs: dict[str, Any], count: Any = None) -> tuple[Any, Any]:
    """The loss of a batch, and what the model gave for the tokens before those that are learnt.

    Args:
        model: A model of Transformers.
        inputs: With labels.
        count: What the sum is divided by; by default the tokens that are learnt here.
    """
    torch = libraries.torch()
    labels = inputs["labels"][:, 1:]
    kept = (labels != IGNORED).any(dim=0).nonzero().squeeze(1)
    told = {name: value for name, value in inputs.items() if name != "labels"}
    outputs = model(**told, use_cache=False, logits_to_keep=kept)
    wanted = labels[:, kept].flatten()
    loss = torch.nn.functional.cross_entropy(
        outputs.logits.flatten(0, 1).float(), wanted, ignore_index=IGNORED, reduction="sum"
    )
    return loss / ((wanted != IGNORED).sum() if count is None else count), outputs
