"""The two pools of built-in objects, measured: no near-duplicate of one is in the other."""

from __future__ import annotations

import importlib.util
from pathlib import Path

import pytest

from every_object import every_object, looking_the_same
from probe.assets.mesh.likeness import like_pairs
from probe.assets.mesh.nearness import NearPair
from probe.assets.pools.division import divided, division_text
from probe.assets.procedural import specs
from probe.assets.procedural.tables import entries
from probe.errors import BadData

ROOT = Path(__file__).parents[3]


@pytest.fixture(scope="module")
def script():
    spec = importlib.util.spec_from_file_location("divide", ROOT / "scripts/divide_objects.py")
    assert spec and spec.loader
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def parted(alike: list[NearPair]) -> list[tuple[str, str]]:
    rows = divided()
    return [
        (pair.one, pair.other) for pair in alike if rows[pair.one].part != rows[pair.other].part
    ]


@pytest.mark.slow
def test_a_share_of_all_objects_is_sound():
    made = every_object(nth=24)
    assert len(made) > 50
    assert {name: it.wrong for name, it in made.items() if it.wrong} == {}


@pytest.mark.slow
@pytest.mark.every_object
def test_every_object_is_sound_and_unlike_the_others_and_pools_are_apart(script):
    """One test, so that each object is built once.

    No two look the same: of the first edition, and one of the second of each shape that has more.
    """
    made = every_object()
    assert {name: it.wrong for name, it in made.items() if it.wrong} == {}
    prints = {name: it.seen for name, it in made.items()}
    alike = like_pairs(prints)
    added = {entries(2)[spec.id].shape: spec for spec in reversed(specs(2)[len(specs(1)) :])}
    chosen = {spec.id for spec in (*specs(1), *added.values())}
    assert looking_the_same(prints, [p for p in alike if {p.one, p.other} <= chosen]) == []
    assert parted(alike) == []
    earlier = {row.id: row.part for row in divided().values()}
    again = script.division_of(list(made), alike, earlier)
    assert division_text(again) == script.FILE.read_text()


def test_an_object_that_is_copied_into_the_other_pool_is_noticed(script):
    red = script.print_of("proc_red_mug")
    copied = like_pairs({"proc_orange_mug": red, "proc_red_mug": red})
    assert parted(copied) == [("proc_orange_mug", "proc_red_mug")]
    earlier = {row.id: row.part for row in divided().values()}
    with pytest.raises(BadData, match="proc_orange_mug is for training, proc_red_mug for eval"):
        script.division_of(["proc_orange_mug", "proc_red_mug"], copied, earlier)


def test_a_series_is_no_copy(script):
    mugs = ("proc_orange_mug", "proc_red_mug", "proc_blue_mug")
    assert parted(like_pairs({it: script.print_of(it) for it in mugs})) == []
