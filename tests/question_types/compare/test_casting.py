"""By newer rules an attempt goes on to other casts where covers leave too much or too little."""

from __future__ import annotations

from itertools import count
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest

from probe.generation.plan import plan_of
from probe.generation.result import Rejected
from probe.question_types.compare import casting
from probe.scene.seeds import generator
from probe.tasks.task import RulesVersion

ASKED: Any = SimpleNamespace(
    twins=(SimpleNamespace(id="red can"), SimpleNamespace(id="blue jar")),
    facing=(np.zeros(1), np.zeros(1)),
)


def staged(rules: RulesVersion, works: int, monkeypatch: pytest.MonkeyPatch) -> list[int]:
    """Which casts an attempt puts on a stage if only one of them can be laid as wanted."""
    tried = list[int]()

    def draw(made: int, *_: object) -> str:
        if made != works:
            raise Rejected("nest", f"cast {made}")
        return "nests"

    monkeypatch.setattr(casting, "_casts", lambda *_: ((ASKED, number) for number in count()))
    for name in ("aim_unpainted", "draw_unpainted"):
        monkeypatch.setattr(casting, name, draw)

    def stage(cast: Any) -> Any:
        tried.append(cast)
        return cast

    nothing: Any = None
    wanted = plan_of("compare", 0, rules=rules)
    try:
        found = casting.draw_covered(nothing, wanted, generator(0, "casts"), stage)
    except Rejected as failure:
        assert failure.rejection.detail == f"cast {tried[-1]}"
    else:
        assert found == (ASKED, works, "nests")
    return tried


def test_by_older_rules_there_is_one_cast(monkeypatch: pytest.MonkeyPatch):
    assert staged(2, 1, monkeypatch) == [0]


@pytest.mark.parametrize(("works", "tried"), [(0, [0]), (2, [0, 1, 2]), (9, [0, 1, 2, 3, 4, 5])])
def test_by_newer_rules_there_are_six(works, tried, monkeypatch: pytest.MonkeyPatch):
    assert staged(3, works, monkeypatch) == tried
