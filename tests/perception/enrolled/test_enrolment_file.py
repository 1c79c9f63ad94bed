import numpy as np
import pytest

from probe.errors import BadData
from probe.perception.enrolled.enrolment import EnrolledWords
from probe.perception.enrolled.enrolment_file import (
    SIGNATURES,
    enrolment_of,
    read_enrolment,
    write_signatures,
)
from probe.perception.enrolled.showing import shown
from tabletops import Block, paint

LIST = """
objects:
  - name: red box
    synonyms: [carton, package]
    description: A red box with nothing on it.
  - name: blue bar
"""
RED, BLUE = Block(1, (300, 300, 499, 399)), Block(1, (300, 300, 699, 340), colour=(30, 60, 160))
SHOWN = {"red box": shown([paint([RED])]), "blue bar": shown([paint([BLUE])] * 2)}


@pytest.fixture
def path(tmp_path):
    path = tmp_path / "objects.yaml"
    path.write_text(LIST)
    return path


def test_what_was_shown_is_read_again(path):
    write_signatures(path, SHOWN)
    assert path.with_suffix(SIGNATURES).name == "objects.signatures.json"
    known = read_enrolment(path)
    box, bar = known.objects
    assert box.words == EnrolledWords(
        "red box", ("carton", "package"), "A red box with nothing on it."
    )
    assert (len(box.views), len(bar.views)) == (1, 2)
    for read, made in ((box.views[0], SHOWN["red box"][0]), (bar.views[1], SHOWN["blue bar"][1])):
        assert np.allclose(read.colours, made.colours, atol=1e-3)
        assert (read.length, read.width) == pytest.approx((made.length, made.width), abs=1e-4)
    assert (
        known.digest == enrolment_of({o.words: SHOWN[o.words.name] for o in known.objects}).digest
    )


def test_another_word_is_another_enrolment(path):
    write_signatures(path, SHOWN)
    first = read_enrolment(path).digest
    path.write_text(LIST.replace("carton", "crate"))
    assert read_enrolment(path).digest != first


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("objects: []", "objects"),
        ("objects: [{name: a}, {name: A}]", "a is the name of two objects"),
        ("objects: [{name: a, colour: red}]", "objects.0.colour"),
        ("objects: [{name: red box}, {name: pen}]", "has no signature of pen"),
        ("{", "is no YAML"),
    ],
)
def test_what_cannot_be_used_is_refused(path, text, words):
    write_signatures(path, SHOWN)
    path.write_text(text)
    with pytest.raises(BadData, match=words):
        read_enrolment(path)


def test_without_signatures_it_says_what_to_do(path):
    with pytest.raises(BadData, match="Enrol its objects first"):
        read_enrolment(path)
