"""How the scripted agent goes about Behind: it takes what is in front away and looks again."""

from __future__ import annotations

from probe.agents.moves import Plan
from probe.agents.phrases import Reason
from probe.agents.type_plan import ScriptedQuestion, TypePlan
from probe.agents.uncovering import uncover


def _begin(asked: ScriptedQuestion) -> Plan[None]:
    return uncover(asked, [asked.subject], Reason("in front"))


PLAN = TypePlan(_begin)
