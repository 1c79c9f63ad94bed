"""`probe init-tiny`: an untrained model to try the recipe on."""

from __future__ import annotations

from typing import Annotated

import tyro

from probe.cli.metavars import Folder
from probe.cli.numbers import check_numbers
from probe.cli.screen import say
from probe.train.tune.tiny import make_tiny
from probe.train.tune.tiny_parts import Shape

_USUAL = Shape()


def init_tiny(
    dataset: Folder,
    out: Folder,
    shape: Annotated[Shape, tyro.conf.arg(name="")] = _USUAL,
) -> None:
    """Make a very small, untrained model: to see that the recipe works, not to use.

    It has Qwen3-VL's architecture, or Llama's with --no-pictures, and a tokenizer of its own,
    trained on the data set's texts.

    Args:
        dataset: A folder that `probe dataset` wrote.
        out: A new folder.
        shape: How small.
    """
    numbers = {name: n for name, n in vars(shape).items() if name != "pictures"}
    check_numbers({f"--{name.replace('_', '-')}": n for name, n in numbers.items()})
    weights = make_tiny(dataset, out, shape)
    say(f"A model of {weights / 1e6:.1f} million weights is in {out}; it knows nothing yet.")
