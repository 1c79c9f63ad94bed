"""Words in the entries of imported objects, from what data sets call them."""

import pytest

from probe.assets.importers.entries import category_of, words_of
from probe.assets.importers.source import SourceFacts
from probe.assets.importers.wording import described


@pytest.mark.parametrize(
    ("raw", "name", "category"),
    [
        ("Cole_Hardware_Hammer_Black", "black cole hardware hammer", "hammer"),
        ("Room_Essentials_Mug_White_Yellow", "white and yellow room essentials mug", "mug"),
        ("Android_Figure_Orange", "orange android figure", "figure"),
        ("tea_set_01_teapot_01_lid", "tea set teapot lid", "lid"),
        # Colours that are no colours, or belong to what stands before them.
        ("017_orange", "orange", "orange"),
        ("mandarin_orange", "mandarin orange", "orange"),
        ("shoe_in_red", "shoe in red", "shoe"),
        ("towel_green_and_white", "towel green and white", "towel"),
        ("red", "red", "red"),
    ],
)
def test_a_draft_reads_as_people_say_it(raw, name, category):
    facts = SourceFacts(raw)
    assert (words_of(facts), category_of(facts)) == (name, category)


def test_a_data_set_s_category_is_that_of_one_thing():
    said = ("Action Figures", "Shoe", "Headphones", "Bus", "Things")
    categories = [category_of(SourceFacts("x", category=category)) for category in said]
    assert categories == ["action figure", "shoe", "headphones", "bus", "things"]


def test_what_is_many_takes_no_article():
    told = [described(name) for name in ("red scissors", "cups", "school bus", "glass", "egg box")]
    assert told == ["Red scissors.", "Cups.", "A school bus.", "A glass.", "An egg box."]
