"""By newer rules the others are thrown anew where they cover too much of what is marked."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import pytest

from probe.generation.plan import plan_of
from probe.generation.result import Rejected
from probe.question_types.compare import generator as compare
from probe.scene.seeds import generator
from probe.tasks.task import RulesVersion

MADE: Any = SimpleNamespace(view=SimpleNamespace(labels=lambda scene: None))
ASKED: Any = SimpleNamespace(twins=(SimpleNamespace(id="red can"), SimpleNamespace(id="blue jar")))
NOTHING: Any = None


@pytest.mark.parametrize(
    ("rules", "fails", "thrown"), [(2, 0, 1), (2, 1, 1), (3, 0, 1), (3, 2, 3), (3, 9, 3)]
)
def test_how_often_they_are_thrown(
    rules: RulesVersion, fails: int, thrown: int, monkeypatch: pytest.MonkeyPatch
):
    scenes = list[int]()

    def settle_around(*_: object) -> int:
        scenes.append(len(scenes))
        return scenes[-1]

    def check(made: object, scene: int, *_: object) -> None:
        if scene < fails:
            raise Rejected("cues", f"throw {scene}")

    monkeypatch.setattr(compare, "settle_around", settle_around)
    monkeypatch.setattr(compare, "_marks", lambda made, asked, scene: f"marks {scene}")
    monkeypatch.setattr(compare, "check_unpainted", check)
    wanted, rng = plan_of("compare", 0, rules=rules), generator(0, "others")

    def among() -> tuple[Any, Any]:
        return compare._among_others(MADE, ASKED, NOTHING, wanted, NOTHING, rng)

    if fails < thrown:
        assert among() == (fails, f"marks {fails}")
    else:
        with pytest.raises(Rejected, match=f"throw {thrown - 1}"):
            among()
    assert len(scenes) == thrown
