import hashlib
import re
import subprocess
import sys
from collections import Counter
from dataclasses import replace
from functools import cache

import numpy as np
import pytest

from every_object import check, looking_the_same
from probe.assets.mesh.likeness import like_pairs
from probe.assets.mesh.nearness import fingerprint
from probe.assets.procedural import build, specs
from probe.assets.procedural.paint.colours import NAMED, SHADES, rgb
from probe.assets.procedural.tables import entries
from probe.assets.spec import ObjectSpec
from probe.errors import UnknownName
from probe.perception.phrase import main_phrase
from probe.tasks.english import plural

LOOKS = ("wooden", "striped", "dotted", "checked", "wicker", "leather", "glass", "metal", "plastic")
SOME = (
    "proc_blue_mug",
    "proc_straw_hat",
    "proc_wooden_tray",
    "proc_banana",
    "proc_cracker_box",
    "proc_jam_jar",
    "proc_masking_tape",
    "proc_green_car",
    "proc_small_yellow_plate",
    "proc_light_blue_and_white_banded_jug",
    "proc_pineapple",
    "proc_black_comb",
    "proc_brown_teddy_bear",
    "proc_yellow_hard_hat",
)


@cache
def spec_by_id() -> dict[str, ObjectSpec]:
    return {spec.id: spec for spec in specs(1)}


@pytest.mark.slow
def test_the_second_edition_begins_with_the_first() -> None:
    first, second = specs(1), specs(2)
    assert second[: len(first)] == first
    assert len(second) >= 1800
    assert len({spec.category for spec in second}) >= 480


def test_no_description_says_a_look_twice() -> None:
    colour = rf"(?:(?:{'|'.join(SHADES)}) )?(?:{'|'.join(NAMED)})"
    look = re.compile(rf"\b(?:{colour}|{'|'.join(LOOKS)})\b")
    for spec in specs(2):
        said = look.findall(main_phrase(spec.description))
        assert len(set(said)) == len(said), spec.description


def test_enough_of_everything() -> None:
    all_specs = specs(1)
    assert len(all_specs) >= 600
    assert len({spec.category for spec in all_specs}) >= 150
    covers = [s for s in all_specs if s.hollow and min(s.size[:2]) >= 0.10]
    assert len(covers) >= 60
    small = sorted(max(s.size) for s in all_specs if max(s.size) <= 0.08)
    assert len(small) >= 16
    twins = [sum(abs(a - b) <= 0.1 * a for b in small) - 1 for a in small]
    assert sum(count >= 4 for count in twins) >= 16


@pytest.mark.slow
def test_words() -> None:
    all_specs = specs(2)
    assert max(Counter(s.name for s in all_specs).values()) == 1
    assert max(Counter(s.id for s in all_specs).values()) == 1
    for spec in all_specs:
        assert spec.id.startswith("proc_")
        assert spec.name == spec.name.lower()
        assert spec.description.endswith(".")
        assert spec.description.count(".") == 1
        assert plural(spec.name) is not None, spec.name
        assert plural(spec.category) is not None, spec.category
        assert len(set(spec.colours)) == len(spec.colours) > 0
        for colour in spec.colours:
            rgb(colour)
            assert not colour.startswith("#")


def test_members_of_a_category_differ_in_main_colour_or_kind() -> None:
    shared = Counter((s.category, s.colours[0]) for s in specs(2))
    assert {pair: n for pair, n in shared.items() if n > 1} == {}


def test_a_shape_s_name_says_what_it_is_made_of() -> None:
    found: dict[str, object] = {}
    for entry in entries(2).values():
        assert found.setdefault(entry.shape, entry.parts) == entry.parts, entry.shape


def test_everyday_sizes_and_densities() -> None:
    for spec in specs(2):
        assert 0.03 <= max(spec.size) <= 0.26, spec.id
        box = float(np.prod(spec.size))
        assert 15 < spec.mass / box < 2600, spec.id  # kg / m^3 of the bounding box


def test_an_unknown_object_is_refused() -> None:
    with pytest.raises(UnknownName, match="proc_unicorn"):
        build("proc_unicorn")


@pytest.mark.parametrize("object_id", SOME)
def test_an_object(object_id: str) -> None:
    check(spec_by_id()[object_id], build(object_id))


def test_an_object_twice_is_noticed_and_one_in_another_colour_is_not() -> None:
    red, blue = build("proc_red_mug").mesh, build("proc_blue_mug").mesh
    quarter = np.array([[0, 1, 0], [-1, 0, 0], [0, 0, 1]], dtype=np.float32)
    turned = replace(red, vertices=red.vertices @ quarter)
    prints = {"proc_red_mug": fingerprint(red), "proc_blue_mug": fingerprint(blue)}
    assert looking_the_same(prints, like_pairs(prints)) == []
    again = prints | {"proc_white_mug": fingerprint(turned)}
    assert looking_the_same(again, like_pairs(again)) == [("proc_red_mug", "proc_white_mug")]


@pytest.mark.slow
@pytest.mark.parametrize("object_id", ["proc_red_apple", "proc_wicker_basket"])
def test_same_bytes_in_another_process(object_id: str) -> None:
    body = build(object_id)
    program = (
        "import hashlib; from probe.assets.procedural import build; "
        f"b = build({object_id!r}); "
        "h = hashlib.sha256(b''.join(p.vertices.tobytes() for p in b.pieces)).hexdigest(); "
        "print(b.mesh.digest(), h)"
    )
    run = subprocess.run(
        [sys.executable, "-c", program], capture_output=True, text=True, check=True
    )
    pieces = hashlib.sha256(b"".join(p.vertices.tobytes() for p in body.pieces)).hexdigest()
    assert run.stdout.split() == [body.mesh.digest(), pieces]


def test_variants_differ_in_look_but_not_in_form() -> None:
    red, blue = build("proc_red_mug").mesh, build("proc_blue_mug").mesh
    np.testing.assert_array_equal(red.vertices, blue.vertices)
    assert red.digest() != blue.digest()


def test_object_spec_types() -> None:
    for spec in specs(1):
        assert isinstance(spec, ObjectSpec)
        assert (spec.origin, spec.licence, spec.source) == (
            "procedural",
            "Apache-2.0",
            "PROBE procedural",
        )
