"""A trainer for processors that leaves out what is compared with the vocabulary for nothing."""

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
        """An SFTTrainer; where outputs are asked for, as in an evaluation, it is TRL's."""

        def compute_loss(
            self,
            model: Any,
            inputs: dict[str, Any],
            return_outputs: bool = False,
            num_items_in_batch: Any = None,
        ) -> Any:
            """Mean cross entropy over the tokens that are learnt, of all of a step's batches.

            That of mixtures of experts has another term, and is TRL's.
            """
            if self.aux_loss_enabled or return_outputs:
                whole: Any = super()
                return whole.compute_loss(model, inputs, return_outputs, num_items_in_batch)
            loss = learnt_loss(model, inputs, num_items_in_batch)
            if self.args.average_tokens_across_devices and num_items_in_batch is not None:
                loss = loss * self.accelerator.num_processes
            return loss

    return LearntTokensTrainer


def learnt_loss(model: Any, inputs: dict[str, Any], count: Any = None) -> Any:
    """The loss of a batch.

    What the model says is computed at places where some row learns; in float32 that takes 4 bytes
    for each of these places, row and word of the vocabulary.

    Args:
        model: A model of Transformers.
        inputs: With labels.
        count: What the sum is divided by; by default the tokens that are learnt here.
    """
    torch = libraries.torch()
    labels = inputs["labels"][:, 1:]
    kept = (labels != IGNORED).any(dim=0).nonzero().squeeze(1)
    told = {name: value for name, value in inputs.items() if name != "labels"}
    said = model(**told, use_cache=False, logits_to_keep=kept).logits
    wanted = labels[:, kept].flatten()
    loss = torch.nn.functional.cross_entropy(
        said.flatten(0, 1).float(), wanted, ignore_index=IGNORED, reduction="sum"
    )
    count = (wanted != IGNORED).sum() if count is None else torch.as_tensor(count)
    return loss / count.clamp(min=1)
