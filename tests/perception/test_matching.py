import pytest
from hypothesis import given
from hypothesis import strategies as st

from probe.perception.matching import NEAREST, match, nearest
from probe.perception.oracle import Oracle
from tabletops import Block, paint, spec

SPECS = [
    spec("red mug", "red", description="A red mug with a handle."),
    spec("blue mug", "blue"),
    spec("figure with red cap", "red", "blue", category="toy figure"),
    spec("golf ball", "white"),
    spec("crayon box", "yellow", "green", description="A small cardboard box with crayons."),
    spec("turquoise plate", "teal", "white"),
    spec("tin of fish", "silver", category="tin"),
]
BLOCKS = [
    Block(n, (100 + 120 * n, 300 + 20 * n, 180 + 120 * n, 380 + 20 * n))
    for n in range(len(SPECS))
    if n
] + [Block(20, (60, 60, 140, 140)), Block(21, (800, 700, 960, 900), share=0.1)]
THINGS = Oracle(dict(enumerate(SPECS)) | {20: SPECS[0], 21: spec("teapot", "green")}).detect(
    paint(BLOCKS)
)


def found(words):
    result = match(words, THINGS)
    return result and result.thing.words.name


@pytest.mark.parametrize(
    ("words", "name"),
    [
        ("red mug", "red mug"),
        ("the red mug", "red mug"),
        ("A mug that is red", "red mug"),
        ("Mugs, blue", "blue mug"),
        ("coffee mug, red", "red mug"),
        ("toy figure", "figure with red cap"),
        ("the figure with the red cap", "figure with red cap"),
        ("golf ball", "golf ball"),
        ("box of crayons", "crayon box"),
        ("teal plate", "turquoise plate"),
        ("gray tin", "tin of fish"),
        ("the thing at (60, 60)", "red mug"),
        ("(150.5, 100)", "red mug"),
        ("whatever is at 100, 100", "red mug"),
    ],
)
def test_finds_what_is_meant(words, name):
    assert found(words) == name


@pytest.mark.parametrize(
    "words",
    ["green mug", "teapot", "hammer", "(10, 1000)", "", "the", "object", "🫖", "(9999, 9999)"],
)
def test_finds_nothing_for_what_does_not_show(words):
    assert match(words, THINGS) is None


def test_coarse_things_are_found_by_colour_alone_or_by_place():
    result = match("something red at (880, 800)", THINGS)
    assert result and not result.thing.nameable


def test_spatial_words_choose_among_equals():
    left, right = match("leftmost mug", THINGS), match("mug on the right", THINGS)
    assert left and left.thing.words.name == "red mug"
    assert right and right.thing.words.name == "blue mug"
    either = match("mug", THINGS)
    assert either and [other.words.name for other in either.others] == ["blue mug"]
    assert left.others == ()


def test_spatial_words_alone_choose_among_all():
    largest, top = match("the largest object", THINGS), match("topmost thing", THINGS)
    assert largest and largest.thing.point_px == (880, 780)
    assert top and top.thing.point_px == (100, 100)


@given(st.text(max_size=300))
def test_any_text_is_answered(words):
    match(words, THINGS)


PEOPLE = [
    spec("yellow plate", "yellow", description="A yellow glazed plate."),
    spec("white speaker", "white", description="A small white loudspeaker with a round grille."),
    spec("blue pot lid", "blue", "black", category="pot lid", description="A lid with a knob."),
    spec("cereal box", "green", category="cereal box", description="A box with a bowl on it."),
    spec("red apple", "red", category="apple"),
    spec("cooking pot", "silver", category="cooking pot"),
]
AMONG = Oracle(dict(enumerate(PEOPLE, start=1)) | {9: spec("red sand timer")}).detect(
    paint(
        [
            Block(n, (100 * n, 300, 100 * n + 80, 380), colour=colour)
            for n, colour in enumerate(
                [
                    (245, 215, 60),
                    (240, 240, 240),
                    (40, 85, 170),
                    (60, 140, 65),
                    (205, 45, 45),
                    (165, 165, 165),
                ],
                start=1,
            )
        ]
        + [Block(9, (800, 700, 860, 760), share=0.2)]
    )
)


@pytest.mark.parametrize(
    ("words", "name"),
    [
        ("yellow bowl", "yellow plate"),
        ("the small yellow dish", "yellow plate"),
        ("white box", "white speaker"),
        ("blue domed cover with black handle", "blue pot lid"),
        ("carton", "cereal box"),
        ("a piece of fruit", "red apple"),
        ("round red fruit", "red apple"),
        ("saucepan", "cooking pot"),
        ("pot", "cooking pot"),
        ("red box", None),  # the unnamed patch is flat and boxy
    ],
)
def test_finds_what_people_mean(words, name):
    found = match(words, AMONG)
    assert found and found.thing.words.name == name


def test_its_own_words_win_and_others_are_marked():
    own, other = match("yellow plate", AMONG), match("yellow bowl", AMONG)
    assert own and own.literal and other and not other.literal


def test_a_noun_that_is_only_mentioned_is_not_the_thing():
    found = match("green bowl", AMONG)
    assert found is None


def test_what_comes_nearest_is_ranked():
    names = [thing.words.name for thing in nearest("purple plate", AMONG)]
    assert names[0] == "yellow plate" and len(names) <= NEAREST
    assert nearest("yellow zeppelin", AMONG) == (AMONG[0],) and nearest("(10, 1000)", AMONG) == ()


def test_what_only_partly_shows_may_be_anything_of_its_colour():
    (sliver,) = (thing for thing in AMONG if not thing.nameable)
    assert nearest("zeppelin", AMONG) == (sliver,)
    assert nearest("red horse", AMONG)[0] is sliver
    assert sliver not in nearest("green horse", AMONG)


def test_what_is_found_by_likeness_comes_with_others_that_may_be_meant():
    alike, own = match("red box", AMONG), match("red apple", AMONG)
    assert alike and not alike.literal and "cereal box" in map(called, alike.maybe)
    assert own and own.whole and own.maybe == ()


def test_a_word_that_does_not_fit_brings_others_up():
    part = match("striped red apple", AMONG)
    assert part and part.literal and not part.whole and called(part.thing) == "red apple"
    assert any(not thing.nameable for thing in part.maybe)


def test_a_reply_lists_few_things():
    vague = match("white something", AMONG), match("domed red cover with dots", AMONG)
    assert all(len(m.others) + len(m.maybe) <= NEAREST for m in vague if m)


def called(thing):
    return thing.words.called


TOYS = Oracle(
    dict(
        enumerate(
            [
                spec("spinning top", "orange", "green", category="spinning top"),
                spec("beige animal figurine", "beige", category="animal figurine"),
                spec("lion figurine", "brown", category="animal figurine"),
                spec("green tyrannosaurus", "green", category="dinosaur figurine"),
                spec("orange mug", "orange", category="mug"),
                spec("ketchup bottle", "red", category="ketchup bottle"),
                spec("red pot lid", "red", category="pot lid"),
                spec("blue block", "blue", category="toy block"),
            ],
            start=1,
        )
    )
).detect(paint([Block(n, (100 * n, 300, 100 * n + 80, 380)) for n in range(1, 9)]))


@pytest.mark.parametrize(
    ("words", "name"),
    [
        ("toy top", "spinning top"),
        ("dog", "beige animal figurine"),
        ("lion", "lion figurine"),
        ("toy lion", "lion figurine"),
        ("T-rex", "green tyrannosaurus"),
        ("animal", "lion figurine"),
        ("mug, orange", "orange mug"),
        ("ketchup", "ketchup bottle"),
        ("mug next to the blue block", "orange mug"),
        ("half hidden orange mug", "orange mug"),
        ("the topmost thing", "spinning top"),
        ("pot", None),
        ("an orange", None),
        ("pineapple", None),
        ("yellow pineapple", None),
    ],
)
def test_finds_a_kind_a_part_and_contents(words, name):
    result = match(words, TOYS)
    told = (result.thing, *result.others) if result else ()
    assert (name in map(called, told)) if name else result is None


def test_what_is_of_one_kind_is_listed_but_never_found():
    names = [called(thing) for thing in nearest("tiger", TOYS[1:3])]
    assert set(names) == {"beige animal figurine", "lion figurine"}
    assert match("tiger", [TOYS[2]]) is None


def test_words_for_size_rank_but_hide_nothing():
    small, smallest = match("small mug", THINGS), match("smallest mug", THINGS)
    assert small and smallest and len(small.others) == 1 and smallest.others == ()
