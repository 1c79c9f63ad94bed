import csv

import pytest

from probe.assets.annotation.notes import (
    from_source,
    note_path,
    read_note,
    read_notes,
    said,
    write_note,
)
from probe.assets.annotation.table import corrected, write_table
from probe.assets.annotation.words import Described
from probe.assets.spec import ObjectSpec
from probe.errors import BadData


def spec(name: str) -> ObjectSpec:
    return ObjectSpec(
        f"own_{name}", name, "thing", ("gray",), "Something.", 0.1, 0.5, (0.1, 0.1, 0.1), False,
        "own", "CC0-1.0", "test",
    )  # fmt: skip


WORDS = Described(name="red mug", category="mug", colours=("red",), description="A red mug, round.")


@pytest.fixture
def notes():
    return (said(from_source(spec("a")), WORDS, "model"), from_source(spec("b"), "it was slow"))


def edit(path, number: int, column: str, value: str) -> None:
    with path.open(newline="") as file:
        rows = list(csv.DictReader(file))
    rows[number][column] = value
    with path.open("w", newline="") as file:
        writer = csv.DictWriter(file, list(rows[0]))
        writer.writeheader()
        writer.writerows(rows)


def test_notes_are_kept_as_they_are(tmp_path, notes):
    for note in notes:
        write_note(tmp_path, note)
    assert read_notes(tmp_path) == notes
    assert [note.done for note in notes] == [True, False]


def test_a_table_that_nobody_touched_changes_nothing(tmp_path, notes):
    write_table(tmp_path / "t.csv", notes)
    assert corrected(tmp_path / "t.csv", notes) == notes


def test_no_cell_is_a_formula(tmp_path, notes):
    noted = [note.model_copy(update={"description": "=1+1"}) for note in notes]
    write_table(tmp_path / "t.csv", noted)
    assert ",'=1+1," in (tmp_path / "t.csv").read_text()
    assert corrected(tmp_path / "t.csv", noted) == tuple(noted)


def test_a_person_s_word_is_marked_and_outlives_the_model_s(tmp_path, notes):
    write_table(tmp_path / "t.csv", notes)
    edit(tmp_path / "t.csv", 0, "name", "crimson mug")
    first, second = corrected(tmp_path / "t.csv", notes)
    assert first.name == "crimson mug" and second == notes[1]
    assert first.origins == {
        "name": "human",
        "category": "model",
        "colours": "model",
        "description": "model",
    }
    again = said(first, WORDS, "model")
    assert again.name == "crimson mug" and again.origins["name"] == "human"


def test_a_sentence_made_of_the_name_follows_it_and_one_that_was_written_stays(tmp_path, notes):
    drafted = notes[1].model_copy(update={"name": "suger", "description": "A suger."})
    write_table(tmp_path / "t.csv", [notes[0], drafted])
    for number in (0, 1):
        edit(tmp_path / "t.csv", number, "name", "orange gum jar")
    written, made = corrected(tmp_path / "t.csv", [notes[0], drafted])
    assert written.description == WORDS.description
    assert (made.description, made.origins["description"]) == ("An orange gum jar.", "human")


@pytest.mark.parametrize(
    ("column", "value", "words"),
    [
        ("colours", "red;mauve", "t.csv:2: colours"),
        ("name", "", "t.csv:2: name"),
        ("id", "own_nobody", "t.csv:2: no object is called own_nobody"),
    ],
)
def test_a_broken_line_is_named_and_nothing_is_taken(tmp_path, notes, column, value, words):
    write_table(tmp_path / "t.csv", notes)
    edit(tmp_path / "t.csv", 0, column, value)
    with pytest.raises(BadData, match=words):
        corrected(tmp_path / "t.csv", notes)


def test_a_table_without_its_columns_is_refused(tmp_path, notes):
    (tmp_path / "t.csv").write_text("id,name\nown_a,mug\n")
    with pytest.raises(BadData, match="lacks one of the columns"):
        corrected(tmp_path / "t.csv", notes)


def test_a_truncated_note_is_refused_with_its_file(tmp_path, notes):
    write_note(tmp_path, notes[0])
    path = note_path(tmp_path, "own_a")
    path.write_bytes(path.read_bytes()[:40])
    with pytest.raises(BadData, match="own_a.json"):
        read_note(path)


def test_masses_and_axes_are_corrected_by_hand(tmp_path, notes):
    first = notes[0].model_copy(update={"up": "y", "other_up": "z"})
    write_table(tmp_path / "t.csv", (first, notes[1]))
    edit(tmp_path / "t.csv", 0, "mass_kg", "0.25")
    edit(tmp_path / "t.csv", 0, "up", "z")
    after, second = corrected(tmp_path / "t.csv", (first, notes[1]))
    assert (after.mass, after.up, after.other_up) == (0.25, "z", None)
    assert (after.origins["mass"], after.origins["up"]) == ("human", "human")
    assert after.name == first.name and second == notes[1]


@pytest.mark.parametrize(
    ("column", "value", "words"),
    [
        ("mass_kg", "heavy", "t.csv:2: mass"),
        ("mass_kg", "-1", "t.csv:2: mass"),
        ("mass_kg", "12", "t.csv:2: mass"),
        ("up", "x", "t.csv:2: .*up"),
    ],
)
def test_masses_and_axes_that_make_no_sense_are_named(tmp_path, notes, column, value, words):
    first = notes[0].model_copy(update={"up": "y"})
    write_table(tmp_path / "t.csv", (first, notes[1]))
    edit(tmp_path / "t.csv", 0, column, value)
    with pytest.raises(BadData, match=words):
        corrected(tmp_path / "t.csv", (first, notes[1]))


def test_only_what_was_changed_has_to_keep_the_rules(tmp_path, notes):
    long = notes[0].model_copy(
        update={"name": "a name from a file that is longer than allowed here"}
    )
    write_table(tmp_path / "t.csv", (long, notes[1]))
    edit(tmp_path / "t.csv", 0, "colours", "blue")
    (after, _) = corrected(tmp_path / "t.csv", (long, notes[1]))
    assert after.colours == ("blue",) and after.name == long.name


def test_tables_and_notes_of_before_are_read(tmp_path, notes):
    old = notes[0].model_dump(include={"id", "name", "category", "colours", "description",
                                       "origins", "problem"})  # fmt: skip
    note = type(notes[0]).model_validate(old)
    assert note.mass is None
    (tmp_path / "t.csv").write_text(
        "id,name,category,colours,description,said by,problem\n"
        'own_a,crimson mug,mug,red,"A red mug, round.",model;model;model;model,\n'
    )
    (after, _) = corrected(tmp_path / "t.csv", (note, notes[1]))
    assert after.name == "crimson mug" and after.up is None
