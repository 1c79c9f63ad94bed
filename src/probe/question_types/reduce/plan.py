"""How the scripted agent goes about Reduce: it removes what is named and names what is left."""

from __future__ import annotations

from probe.agents.moves import Plan
from probe.agents.phrases import Reason
from probe.agents.type_plan import ScriptedQuestion, TypePlan
from probe.agents.uncovering import uncover


def _begin(asked: ScriptedQuestion) -> Plan[None]:
    return uncover(asked, asked.subject.split(", "), Reason("named"))


PLAN = TypePlan(_begin)
