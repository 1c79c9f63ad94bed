"""The option `--perception`: what the tools see with, for `probe run`, `serve` and `human`."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from probe.episodes.conditions import NO_DIALS, Conditions
from probe.episodes.participation import has_tools
from probe.episodes.perceptions import PerceptionKind
from probe.errors import BadData
from probe.perception.choice import Perceiver, enrolled, ideal, segmented


@dataclass(frozen=True)
class PerceptionChoice:
    """What the tools see with.

    Attributes:
        perception: What the tools see with: "oracle" reads the simulation's labels;
            "segmenter" goes by colours and depth alone and knows no names; "enrolled" does, too,
            and takes names from the objects of --enrolment.
        enrolment: An operator's list of objects, with their signatures beside it; see
            docs/reference/perception.md.
    """

    perception: PerceptionKind = "oracle"
    enrolment: Path | None = None

    def perceiver(self) -> Perceiver:
        """What it says.

        Raises:
            BadData: The enrolment can't be read, is missing or would do nothing.
        """
        if self.perception == "enrolled":
            if self.enrolment is None:
                reason = "needs an operator's list of objects"
                raise BadData("--perception enrolled", reason, "Say it with --enrolment FILE")
            return enrolled(self.enrolment)
        if self.enrolment is not None:
            reason = f"does nothing with --perception {self.perception}"
            raise BadData("--enrolment", reason, "Say --perception enrolled, or leave it out")
        return ideal if self.perception == "oracle" else segmented

    def check(self, conditions: Conditions) -> None:
        """See that no other option is about a perception that isn't used.

        Raises:
            BadData: --dials or --ideal perception is, which are about the oracle.
        """
        if self.perception == "oracle":
            return
        if conditions.dials != NO_DIALS or conditions.ideal == "perception":
            reason = "does nothing with --dials or --ideal perception, which are about the oracle"
            raise BadData(f"--perception {self.perception}", reason, "Leave one of the two out")

    def check_model(self, pointer: str, setting: str) -> None:
        """See that a model's other options leave this perception something to do.

        Raises:
            BadData: A model points, or there are no tools.
        """
        if self.perception == "oracle":
            return
        name = f"--perception {self.perception}"
        if pointer != "oracle":
            raise BadData(name, "does nothing with --pointer", "Leave one of the two out")
        if not has_tools(setting):
            raise BadData(name, f"does nothing with --setting {setting}", "Leave it out")
