"""Options that don't go together are refused, rather than left out of account."""

from __future__ import annotations

from collections.abc import Mapping

from probe.episodes.conditions import NO_DIALS, Conditions
from probe.episodes.participation import has_tools
from probe.errors import BadData
from probe.transcripts.prompts import Graphs, Setting


def refuse_stray(command: str, when: str, given: Mapping[str, object]) -> None:
    """See that nothing is said that would do nothing.

    Args:
        command: Whose options they are: "run".
        when: When they do nothing: "with --model", "without --model".
        given: Values of these options by name; None where nothing was said.

    Raises:
        BadData: Something is.
    """
    for name, value in given.items():
        if value is not None:
            raise BadData(name, f"does nothing {when}", f"See `probe {command} --help`")


def check_pointer(pointer: str, setting: Setting, conditions: Conditions) -> None:
    """See that a model that is to point would be asked.

    Raises:
        BadData: It wouldn't: nobody points in this setting, or perception is the oracle's all the
            same.
    """
    if pointer == "oracle":
        return
    if setting != "agentic":
        raise BadData("--pointer", f"does nothing with --setting {setting}", "Leave it out")
    if conditions.dials != NO_DIALS or conditions.ideal == "perception":
        reason = "does nothing with --dials or --ideal perception, which are about the oracle"
        raise BadData("--pointer", reason, "Leave one of the two out")


def check_graphs(graphs: Graphs | None, setting: Setting) -> None:
    """See that the form of lists is said only where lists have forms.

    Raises:
        BadData: It is said of another setting.
    """
    if graphs is not None and setting != "text-only":
        reason = f"does nothing with --setting {setting}"
        raise BadData("--graphs", reason, "Say --setting text-only, or leave it out")


def check_tools_wanted(conditions: Conditions, setting: str, when: str) -> None:
    """See that how tools err is said only where there are tools.

    Args:
        conditions: What was asked for.
        setting: How the agent may answer.
        when: When it does nothing, if there are none: "with --setting direct".

    Raises:
        BadData: It is said where there are none.
    """
    if has_tools(setting):
        return
    for name, said in (
        ("--dials", conditions.dials != NO_DIALS),
        (f"--ideal {conditions.ideal}", conditions.ideal != "none"),
    ):
        if said:
            raise BadData(name, f"does nothing {when}", "Leave it out")
