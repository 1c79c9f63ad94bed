"""Remarks on the page to review."""

from probe.assets.annotation.notes import from_source
from probe.assets.spec import ObjectSpec
from probe.cli.assets_review import with_twins


def note(object_id: str, name: str):
    return from_source(
        ObjectSpec(
            object_id, name, "mug", ("red",), "A mug.", 0.1, 0.5, (0.1, 0.1, 0.1), True, "own",
            "CC0-1.0", "test",
        )
    )  # fmt: skip


def test_who_might_be_taken_for_another_by_name_is_told():
    notes = [note("own_a", "mug"), note("own_b", "red mug"), note("own_c", "red mug")]
    plain, first, second = with_twins(notes, ["blue mug", "smug"])
    assert plain.remarks == ("might be taken for a 'blue mug': say more, its colour perhaps",)
    assert first.remarks == ()
    assert second.remarks == ("has the name of own_b",)
    assert with_twins(notes[1:2]) == (notes[1],)
