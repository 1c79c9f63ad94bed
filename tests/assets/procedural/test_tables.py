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


def read(entry: dict) -> tables.Entry:
    return tables._entry("test", entry, SHAPES, PAINTS)


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


def test_every_shape_and_paint_template_is_used() -> None:
    text = "".join((tables.FOLDER / f"{n}.yaml").read_text("utf-8") for n in tables.OBJECT_FILES)
    assert {entry.shape for entry in entries().values()} == set(tables._read("shapes"))
    unused = [name for name in tables._read("paints") if f"template: {name}" not in text]
    assert unused == []
