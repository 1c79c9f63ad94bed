"""How the scripted agent goes about Beneath: it lifts the cover and names what comes to light."""

from __future__ import annotations

from probe.agents.moves import Plan
from probe.agents.phrases import Reason
from probe.agents.type_plan import ScriptedQuestion, TypePlan
from probe.agents.uncovering import uncover


def _begin(asked: ScriptedQuestion) -> Plan[None]:
    return uncover(asked, [asked.subject], Reason("cover"))


PLAN = TypePlan(_begin)
