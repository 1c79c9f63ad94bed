import pytest
from hypothesis import given
from hypothesis import strategies as st

from probe.assets.procedural.families import members
from probe.assets.procedural.paint.colours import NAMED, SHADES

WORDS = {"and": {}, "big": {"scale": 2.0}, "dotted": {"finish": "dots", "second": "white"}}
CUP = {
    "category": "cup",
    "described": "cup with a handle",
    "mass": 0.1,
    "shape": "cup",
    "defaults": {"finish": "plain", "inside": "$main"},
    "paints": {"body": {"template": "$finish", "colour": "$main"}, "in": {"ground": "$inside"}},
}
COLOURS = st.sampled_from([f"{s} {c}".strip() for s in ("", *SHADES) for c in NAMED])


def one(variant: object, **changes: object) -> dict:
    (found,) = members(CUP | {"variants": [variant]} | changes, WORDS)
    return found


def test_an_entry_without_variants_stays_as_it_is() -> None:
    assert members({"id": "proc_x", "name": "$x"}, WORDS) == [{"id": "proc_x", "name": "$x"}]


@given(COLOURS, COLOURS)
def test_colours_are_read_from_the_words(first: str, second: str) -> None:
    cup = one(f"{first} and {second} dotted")
    assert cup["colours"] == list(dict.fromkeys([first, second]))
    assert cup["name"] == f"{first} and {second} dotted cup"
    assert cup["id"] == f"proc_{cup['name'].replace(' ', '_')}"
    assert cup["paints"]["body"]["template"] == "dots"
    assert cup["paints"]["body"]["colour"] == first
    assert cup["paints"]["body"]["second"] == second
    assert cup["paints"]["in"] == {"ground": first}


def test_a_word_brings_its_own_colour_unless_one_is_named() -> None:
    assert one("red dotted")["colours"] == ["red", "white"]
    assert one("red and black dotted")["colours"] == ["red", "black"]


def test_values_of_a_variant_win() -> None:
    cup = one({"big red": {"name": "bucket", "scale": 3.0, "inside": "blue", "mass": 5}})
    assert (cup["name"], cup["id"], cup["scale"], cup["mass"]) == ("bucket", "proc_bucket", 3.0, 5)
    assert cup["paints"]["in"] == {"ground": "blue"}


def test_mass_grows_with_volume() -> None:
    assert one("big red")["mass"] == pytest.approx(0.8)
    assert one({"red": {"stretch": [1, 2, 1]}})["mass"] == pytest.approx(0.2)


def test_descriptions_have_the_right_article() -> None:
    assert one("red")["description"] == "A red cup with a handle."
    assert one("orange")["description"] == "An orange cup with a handle."


@pytest.mark.parametrize(
    ("look", "described", "description"),
    [
        ("red", "red cup with a handle", "A red cup with a handle."),
        ("dark red", "tall dark red cup", "A tall dark red cup."),
        ("red", "cup with a red handle", "A red cup with a red handle."),
        ("light blue", "light bulb", "A light blue light bulb."),
        ("red and black and red", "big cup", "A red and black big cup."),
    ],
)
def test_a_description_says_a_look_once(look: str, described: str, description: str) -> None:
    assert one(look, described=described)["description"] == description


def test_a_noun_of_its_own() -> None:
    assert one("red", noun="beaker")["name"] == "red beaker"


@pytest.mark.parametrize("variant", ["fluffy red", {"red": {"inside": "$nothing"}}, "big"])
def test_what_nothing_explains_is_refused(variant: object) -> None:
    with pytest.raises(KeyError):
        one(variant)
