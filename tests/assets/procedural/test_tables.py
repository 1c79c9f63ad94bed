import re
from itertools import chain

import pytest

from probe.assets.procedural import tables
from probe.assets.procedural.paint.mottled import Mottled
from probe.assets.procedural.tables import entries
from probe.errors import BadData

ENTRY = {
    "id": "proc_thing",
    "name": "thing",
    "category": "thing",
    "colours": ["red"],
    "description": "A thing.",
    "mass": 0.1,
    "shape": "cube",
    "paints": {"all": {"template": "flat", "shade": "blue"}},
}
SHAPES = {"cube": [{"kind": "box", "size": [0.1, 0.1, 0.1], "paint": "all"}]}
PAINTS = {"flat": {"defaults": {"shade": "red"}, "paint": {"look": "mottled", "colour": "$shade"}}}


WORDS = {"big": {"scale": 1.5}}


def read(entry: dict) -> tables.ProceduralEntry:
    (found,) = tables._entries("test", entry, SHAPES, PAINTS, WORDS)
    return found


def test_values_replace_a_templates_defaults() -> None:
    plain = ENTRY | {"paints": {"all": {"template": "flat"}}}
    assert read(ENTRY).paints["all"] == Mottled(colour="blue")
    assert read(plain).paints["all"] == Mottled(colour="red")


@pytest.mark.parametrize(
    "change",
    [
        {"shape": "sphere"},
        {"mass": -1},
        {"paints": {"all": {"template": "shiny"}}},
        {"paints": {"other": {"template": "flat"}}},
        {"colour": "red"},
    ],
)
def test_a_mistake_names_its_entry(change: dict) -> None:
    with pytest.raises(BadData, match="proc_thing"):
        read(ENTRY | change)


def test_an_entry_may_bring_its_own_parts() -> None:
    own = ENTRY | {"parts": [SHAPES["cube"][0] | {"size": [0.2, 0.1, 0.1]}]}
    del own["shape"]
    assert read(own).shape == "own thing"
    assert read(own).parts[0].model_dump()["size"] == (0.2, 0.1, 0.1)


def test_every_shape_and_word_and_paint_template_is_used() -> None:
    text = "".join(
        (tables.FOLDER / f"{n}.yaml").read_text("utf-8")
        for n in chain(*tables.OBJECT_FILES.values())
    )
    words = (tables.FOLDER / "words.yaml").read_text("utf-8")
    shapes = {e.shape for e in entries(2).values() if not e.shape.startswith("own ")}
    assert shapes == set(tables._read("shapes"))
    paints = tables._read("paints")
    named = set(re.findall(r"(?:template|finish|bar): (\w+)", text + words))
    assert named - {"$finish"} >= set(paints) - {"blank"}
    spoken = {word for name in re.findall(r"\w[\w ]+", text) for word in name.split()}
    assert set(tables._read("words")) <= spoken


def test_more_of_an_earlier_family_says_what_differs() -> None:
    families: dict = {}
    family = {"category": "thing", "mass": 0.1, "scale": 1.1, "variants": ["red"]}
    assert tables._whole("test", family, families) is family
    more = {"more_of": "thing", "scale": 0.9, "variants": ["blue"]}
    whole = tables._whole("test", more, families)
    assert whole == {"category": "thing", "mass": 0.1, "scale": 0.9, "variants": ["blue"]}
    assert family["variants"] == ["red"]
    # One object alone is no family.
    assert tables._whole("test", ENTRY, families) is ENTRY
    with pytest.raises(BadData, match="'lamp' is no category with variants"):
        tables._whole("test", more | {"more_of": "lamp"}, families)


def test_what_is_more_of_a_family_has_its_shape_in_other_proportions() -> None:
    orange, teal, red = (entries(2)[f"proc_{it}_mug"] for it in ("orange", "teal", "red"))
    assert orange.shape == teal.shape == red.shape
    assert orange.stretch == teal.stretch == (1, 1, 1.2)
    assert orange.mass == pytest.approx(1.2 * 0.34, rel=0.05)
    assert "proc_orange_mug" not in entries(1)
