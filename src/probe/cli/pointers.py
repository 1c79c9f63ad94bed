"""Who points for perception, and where models are, as the command line has it: what fits."""

from __future__ import annotations

from probe.bench.models import known_models
from probe.chat.prompts import Arm
from probe.errors import BadData


def check_addresses(arm: Arm, pointer: str, endpoint: str | None) -> None:
    """See that a pointer has something to do and can be found, and that an endpoint is one.

    Args:
        arm: How the model that acts may answer.
        pointer: "oracle", "self", or a model's name.
        endpoint: Address of a server, if it isn't the model's usual.

    Raises:
        BadData: It isn't so.
    """
    if endpoint is not None and not endpoint.startswith(("http://", "https://")):
        remedy = "Begin it with http:// or https://"
        raise BadData("--endpoint", f"{endpoint!r} is no address of a server", remedy)
    if pointer == "oracle":
        return
    if arm != "agentic":
        reason = f"nothing is pointed at in the arm {arm}, which has no tools"
        raise BadData("--pointer", reason, "Leave it out")
    named = pointer == "self" or pointer in known_models() or "/" in pointer
    if not named and endpoint is None:
        remedy = 'Say "oracle", "self", a short name of docs/models.md or PROVIDER/NAME'
        raise BadData("--pointer", f"there is no model {pointer!r}", remedy)
