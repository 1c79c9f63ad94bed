from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from probe.changes.change import Changes, Fate
from probe.changes.compare import compare
from probe.changes.sighting import Look, including, sightings
from probe.perception.oracle import Oracle
from probe.perception.things import Thing, Words
from probe.scene.setup import UR5_TABLE
from probe.types import Frame
from tabletops import Block, paint, spec

SPECS = {
    1: spec("red mug", "red"),
    2: spec("blue book", "blue"),
    3: spec("white ball", "white"),
    4: spec("white ball", "white"),
}
MUG = Block(1, (100, 100, 219, 219))
BOOK = Block(2, (500, 300, 799, 699), height=0.02, colour=(30, 60, 150))
BALL = Block(3, (600, 450, 679, 529), height=0.08, colour=(240, 240, 240))
TWIN = Block(4, (850, 450, 929, 529), height=0.08, colour=(240, 240, 240))
LEFT, RIGHT = (100, 100, 124, 150), (125, 100, 150, 150)
CM = round(0.01 * 1024 / UR5_TABLE.view_size)


def moved(block: Block, du: int, dv: int = 0) -> Block:
    left, top, right, bottom = block.box
    box = (left + du, top + dv, right + du, bottom + dv)
    return Block(block.instance, box, block.height, block.colour)


def look(*blocks: Block, basket: tuple[Block, ...] = ()) -> Look:
    table, (frame, things) = paint(blocks), below(*basket)
    here = sightings(table, Oracle(SPECS).detect(table))
    return Look(table, here, frame, sightings(frame, things))


def below(*blocks: Block) -> tuple[Frame, tuple[Thing, ...]]:
    """What the camera above the basket sees."""
    frame = paint(blocks, camera=UR5_TABLE.basket_camera)
    return frame, Oracle(SPECS).detect(frame)


def fates(changes: Changes) -> dict[str, Fate]:
    return {str(change.before.thing.words.name): change.fate for change in changes.things}


def test_a_thing_that_shows_more_of_itself_has_stayed():
    changes = compare(look(MUG, BOOK, BALL), look(MUG, BOOK))
    assert fates(changes) == {"red mug": "stayed", "blue book": "stayed", "white ball": "lost"}


def test_a_thing_that_shows_less_of_itself_has_stayed():
    over = Block(3, (500, 300, 700, 500), height=0.08, colour=(240, 240, 240))
    assert fates(compare(look(MUG, BOOK, TWIN), look(MUG, BOOK, over)))["blue book"] == "stayed"


@pytest.mark.parametrize(("way", "fate"), [(CM, "stayed"), (3 * CM, "moved")])
def test_things_count_as_moved_from_2_cm_on(way: int, fate: Fate):
    changes = compare(look(MUG, BOOK), look(moved(MUG, way), BOOK))
    assert fates(changes) == {"red mug": fate, "blue book": "stayed"}


def test_a_flat_thing_that_slides_on_its_own_plane_has_moved():
    card = Block(2, (300, 600, 699, 899), height=0.001, colour=(30, 60, 150))
    changes = compare(look(card), look(moved(card, 5 * CM)))
    assert fates(changes) == {"blue book": "moved"}
    assert np.linalg.norm(changes.things[0].shift) == pytest.approx(0.05, abs=0.003)


def test_a_sliver_that_has_gone_is_not_what_came_to_light_around_its_place():
    sliver = Block(1, (600, 440, 619, 449), height=0.03, colour=(190, 40, 40), share=0.1)
    changes = compare(look(BALL, BOOK, sliver), look(BOOK))
    assert [c.fate for c in changes.things if c.before.thing.words.name is None] == ["lost"]


def test_what_was_put_into_the_basket_is_found_there():
    inside = Block(3, (100, 100, 150, 150), height=0.08, colour=(240, 240, 240))
    changes = compare(look(MUG, BOOK, BALL), look(MUG, BOOK, basket=(inside,)))
    assert fates(changes)["white ball"] == "basket"
    assert changes.newly_in_basket == ()


def test_what_lay_in_the_basket_before_is_not_what_was_put_there():
    inside = Block(4, (100, 100, 150, 150), height=0.08, colour=(240, 240, 240))
    changes = compare(look(MUG, BALL, basket=(inside,)), look(MUG, basket=(inside,)))
    assert fates(changes) == {"red mug": "stayed", "white ball": "lost"}


def test_of_twins_the_one_that_stayed_is_not_the_one_that_went():
    inside = Block(3, (100, 100, 150, 150), height=0.08, colour=(240, 240, 240))
    before, after = look(BALL, TWIN), look(TWIN, basket=(inside,))
    ball = next(s for s in before.things if s.thing.box_px == BALL.box)
    assert compare(before, after).of(ball).fate == "basket"
    assert [change.fate for change in compare(before, after).but(ball)] == ["stayed"]


def test_what_was_held_is_in_the_basket_though_a_twin_comes_to_light():
    inside = Block(3, (100, 100, 150, 150), height=0.08, colour=(240, 240, 240))
    beneath = moved(Block(4, BALL.box, 0.04, BALL.colour), 10)
    before, after = look(BALL), look(beneath, basket=(inside,))
    assert compare(before, after, before.things[0]).things[0].fate == "basket"


def test_a_part_that_was_held_is_in_the_basket_though_something_came_to_light_in_its_place():
    part = Block(3, (600, 440, 659, 499), 0.08, BALL.colour, share=0.2)
    inside = Block(3, (100, 100, 150, 150), height=0.08, colour=BALL.colour)
    beneath = Block(2, (560, 400, 719, 539), 0.02, BALL.colour)
    before, after = look(MUG, part), look(MUG, beneath, basket=(inside,))
    (held,) = [it for it in before.things if it.thing.words.name is None]
    changes = compare(before, after, held)
    assert changes.of(held).fate == "basket" and changes.newly_in_basket == ()


def test_what_was_held_is_what_is_new_in_the_basket_though_it_looks_otherwise():
    inside = Block(2, (100, 100, 150, 150), height=0.08, colour=(30, 60, 150))
    before, after = look(MUG, TWIN), look(TWIN, basket=(inside,))
    assert compare(before, after).of(before.things[0]).fate == "lost"
    changes = compare(before, after, before.things[0])
    assert changes.of(before.things[0]).fate == "basket" and changes.newly_in_basket == ()


def test_what_shows_beside_the_basket_is_not_in_it():
    out = sightings(*below(Block(3, (100, 100, 150, 150), height=0.08, colour=(240, 240, 240))))
    after = replace(look(MUG, BOOK), beside=out)
    assert fates(compare(look(MUG, BOOK, BALL), after))["white ball"] == "beside"


def over(left: int, right: int) -> Block:
    return Block(3, (left, 280, right, 720), height=0.08, colour=(240, 240, 240))


@pytest.mark.parametrize(
    ("until", "since", "share", "fate"),
    [(580, 720, 1.0, "stayed"), (650, 630, 0.1, "stayed"), (650, 630, 1.0, "moved")],
)
def test_a_thing_that_shows_another_part_of_itself_has_stayed(
    until: int, since: int, share: float, fate: Fate
):
    # The middle of what shows goes by 80 pixels or 160; the book has come up a little.
    book = Block(2, BOOK.box, BOOK.height, BOOK.colour, share)
    risen = Block(2, (497, 300, 796, 699), 0.028, BOOK.colour, share)
    changes = compare(look(book, over(480, until)), look(risen, over(since, 820))).things
    (mine,) = [it for it in changes if it.before.thing.words.name != "white ball"]
    assert mine.fate == fate


@pytest.mark.parametrize(("du", "at_least"), [(150, False), (400, True)])
def test_a_thing_that_is_cut_off_may_have_gone_further(du: int, at_least: bool):
    ball = moved(BALL, du)
    (change,) = compare(look(BALL), look(ball)).things
    assert change.at_least is at_least and change.fate == "moved"
    went = float(np.linalg.norm(change.shift[:2]))
    true = du / CM / 100
    assert went < 0.95 * true if at_least else went == pytest.approx(true, rel=0.1)


def test_a_thing_that_turns_about_its_middle_has_turned():
    bar = Block(2, (300, 480, 699, 519), height=0.02, colour=(30, 60, 150))
    across = Block(2, (480, 300, 519, 699), height=0.02, colour=(30, 60, 150))
    assert fates(compare(look(bar), look(across))) == {"blue book": "turned"}
    assert fates(compare(look(bar), look(moved(bar, 5)))) == {"blue book": "stayed"}


def test_a_narrow_thing_that_slides_by_less_than_counts_has_stayed():
    rod = Block(2, (300, 490, 699, 509), height=0.02, colour=(30, 60, 150))
    (change,) = compare(look(rod), look(moved(rod, 0, CM))).things
    assert (change.fate, change.turned) == ("stayed", False)


BAR = Block(2, (300, 480, 699, 519), height=0.02, colour=(30, 60, 150))
ACROSS = Block(2, (480, 300, 519, 699), height=0.02, colour=(30, 60, 150))
UPRIGHT = Block(2, (400, 400, 499, 499), height=0.15, colour=(30, 60, 150))
ON_ITS_SIDE = Block(2, (400, 400, 639, 499), height=0.06, colour=(30, 60, 150))
ABOVE = Block(3, (250, 440, 499, 559), height=0.08, colour=(240, 240, 240))
BEYOND = moved(ABOVE, 200)


@pytest.mark.parametrize(
    ("before", "after", "turned"),
    [
        ([BAR], [BAR], False),
        ([BAR], [ACROSS], True),
        ([UPRIGHT], [UPRIGHT], False),
        ([UPRIGHT], [ON_ITS_SIDE], True),
        ([ON_ITS_SIDE], [UPRIGHT], True),
        ([BAR, ABOVE], [BAR], False),
        ([BAR], [BAR, BEYOND], False),
        ([BAR, ABOVE], [ACROSS], True),
    ],
)
def test_a_thing_that_moved_has_turned_if_no_slide_explains_what_shows(before, after, turned: bool):
    slid = [moved(block, 14 * CM, 4 * CM) if block.instance == 2 else block for block in after]
    (change,) = [
        it
        for it in compare(look(*before), look(*slid)).things
        if it.before.thing.words.name == "blue book"
    ]
    assert (change.fate, change.turned) == ("moved", turned)


@pytest.mark.parametrize(("white", "doubtful"), [(0.1, True), (0.01, False)])
def test_what_may_show_in_part_is_not_surely_gone(white: float, doubtful: bool):
    before = look(MUG, BALL)
    after = look(MUG, Block(4, (800, 440, 819, 449), height=0.03, colour=(20, 90, 20), share=0.1))
    mug, sliver = after.things
    mixed = white * before.things[-1].colours + (1 - white) * sliver.colours
    change = compare(before, replace(after, things=(mug, replace(sliver, colours=mixed)))).things[
        -1
    ]
    assert change.fate == "lost" and change.doubtful is doubtful


@pytest.mark.parametrize(("twin", "fate"), [(False, "moved"), (True, "lost")])
def test_a_thing_that_shows_another_side_of_itself_is_known_by_its_name_alone(
    twin: bool, fate: Fate
):
    # A cup lay on its side and stands up: only its inside shows. A twin might be meant as well.
    ball = Block(3, (100, 800, 179, 879), 0.08, (240, 240, 240))
    inside = Block(3, (300, 700, 399, 799), 0.08, (20, 20, 20))
    after = look(MUG, inside, *([replace(TWIN, colour=(20, 20, 20))] if twin else []))
    changes = compare(look(MUG, ball), after)
    assert fates(changes)["white ball"] == fate


def test_what_something_came_over_is_covered():
    over = Block(2, (80, 80, 379, 479), height=0.1, colour=(30, 60, 150))
    assert fates(compare(look(MUG, BOOK), look(MUG, over))) == {
        "red mug": "covered",
        "blue book": "moved",
    }


def test_other_things_of_other_names_are_not_taken_for_one():
    other = Block(2, (300, 600, 419, 719), colour=MUG.colour)
    assert fates(compare(look(MUG), look(other))) == {"red mug": "lost"}


def test_a_thing_that_was_pointed_at_takes_the_place_of_what_it_covers():
    before = look(MUG, BOOK)
    pointed = Thing.of(before.things[0].thing.mask, Words(None, "", (), "that"))
    with_it, sighting = including(before, pointed)
    assert len(with_it.things) == 2 and with_it.things[-1] is sighting
    assert compare(with_it, look(MUG, BOOK)).of(sighting).fate == "stayed"
    same, known = including(before, before.things[0].thing)
    assert same is before and known is before.things[0]


def test_how_far_a_thing_went_that_shows_more_of_itself_is_the_least_that_it_may_be():
    half = Block(2, (500, 300, 599, 699), height=0.02, colour=(30, 60, 150))
    tilted = replace(BOOK, height=0.03)
    (book,) = compare(look(half), look(tilted)).things
    assert np.linalg.norm(book.shift) == 0
    (book,) = compare(look(half), look(moved(tilted, 4 * CM))).things
    assert book.fate == "moved" and np.linalg.norm(book.shift) == pytest.approx(0.04, abs=0.004)


# Nothing hid the rest of it before, so that it can't have stayed.
@pytest.mark.parametrize(("way", "fate"), [(1, "moved"), (15, "lost")])
def test_a_part_is_what_came_to_light_around_its_place(way: int, fate: Fate):
    part = Block(2, (560, 400, 599, 579), height=0.01, colour=(20, 90, 20), share=0.1)
    before, after = look(MUG, part), look(MUG, moved(BOOK, way * CM))
    mug, sliver = before.things
    mixed = 0.7 * sliver.colours + 0.3 * after.things[1].colours
    mixed_before = replace(before, things=(mug, replace(sliver, colours=mixed)))
    assert compare(mixed_before, after).things[1].fate == fate


def test_a_part_that_comes_to_light_in_its_place_is_found_there_though_another_looks_like_it():
    gray = (60, 60, 60)
    blade = Block(2, (480, 560, 499, 589), 0.02, gray, 0.1)
    handle = Block(1, (560, 900, 659, 919), 0.02, gray, 0.3)
    whole, gone = Block(2, (440, 560, 719, 619), 0.02, gray), moved(handle, -300, -400)
    before = look(blade, handle, Block(3, (500, 540, 719, 700), 0.06, (40, 120, 40)))
    found = {c.before.thing.box_px: c for c in compare(before, look(whole, gone)).things}
    mine, other = found[blade.box], found[handle.box]
    assert mine.fate == "stayed" and mine.after is not None
    assert mine.after.thing.words.name == "blue book"
    assert other.after is not None and other.after.thing.box_px == gone.box


def test_a_part_is_not_what_came_to_its_place_if_something_else_looks_more_like_it():
    # A gray thing lay in a dark pot, of which a part showed; both were pushed.
    boat = Block(1, (480, 560, 539, 619), 0.05, (150, 150, 150), 0.4)
    pot = Block(2, (300, 500, 420, 640), 0.04, (30, 30, 30), 0.2)
    later = Block(1, (480, 760, 539, 819), 0.05, (150, 150, 150), 0.4)
    there = Block(2, (380, 500, 560, 640), 0.04, (30, 30, 30), 0.2)
    before, after = look(boat, pot), look(later, there)
    colours = {it.thing.box_px: it.colours for it in before.things}
    mixed = 0.3 * colours[boat.box] + 0.7 * colours[pot.box]
    pushed = tuple(
        replace(it, colours=mixed) if it.thing.box_px == there.box else it for it in after.things
    )
    changes = compare(before, replace(after, things=pushed)).things
    places = {c.before.thing.box_px: c.after and c.after.thing.box_px for c in changes}
    assert places == {boat.box: later.box, pot.box: there.box}


def test_a_part_is_no_far_thing_of_its_colours_where_something_lies_that_it_may_belong_to():
    # The handle of a sieve that a pot hid; a die of its red came to light elsewhere.
    handle = Block(2, (130, 860, 169, 879), 0.05, (190, 40, 40), 0.1)
    sieve = Block(2, (120, 640, 319, 879), 0.03, (150, 150, 150))
    die = Block(1, (600, 300, 649, 349), 0.03, (190, 40, 40))
    before, after = look(handle), look(die, sieve)
    mixed = 0.3 * before.things[0].colours + 0.7 * after.things[1].colours
    seen = tuple(
        replace(it, colours=mixed) if it.thing.box_px == sieve.box else it for it in after.things
    )
    (change,) = compare(before, replace(after, things=seen)).things
    assert (change.fate, change.after, change.perhaps) == ("lost", None, None)
    assert change.doubtful
    (alone,) = compare(before, look(die)).things
    assert alone.after is not None and alone.after.thing.box_px == die.box


def test_a_thing_that_fell_flat_has_tipped_though_it_lies_about_where_it_was():
    # A lid leant against a bucket, which went; it shows more of itself now.
    lid = Block(2, (500, 300, 699, 499), 0.02, (150, 150, 150))
    bucket = Block(3, (620, 300, 779, 499), 0.12, (40, 120, 40))
    standing = look(lid, bucket)
    frame = standing.table
    left, _, right, _ = lid.box
    rise = np.linspace(0, 0.08, right + 1 - left, dtype=np.float32)
    depth, labels = frame.depth.copy(), frame.labels
    assert labels is not None
    depth[:, left : right + 1] -= np.where(labels[:, left : right + 1] == 2, rise, 0)
    table = replace(frame, depth=depth)
    leaning = replace(standing, table=table, things=sightings(table, Oracle(SPECS).detect(table)))
    assert fates(compare(leaning, look(lid)))["blue book"] == "turned"


@pytest.mark.parametrize(
    ("shown", "perhaps"), [([], None), ([MUG], "red mug"), ([MUG, BOOK], None)]
)
def test_a_part_that_is_gone_may_be_the_only_like_thing_that_came_to_light(shown, perhaps):
    sliver = Block(1, (800, 840, 819, 849), 0.03, MUG.colour, share=0.1)
    before, after = look(BALL, sliver), look(BALL, *shown)
    part = next(it for it in before.things if it.thing.words.name is None)
    mixed = tuple(
        it if it.thing.words.name == "white ball"
        # As a lid has another colour than the pot.
        else replace(it, colours=0.4 * part.colours + 0.6 * before.things[0].colours)
        for it in after.things
    )  # fmt: skip
    after = replace(after, things=mixed)
    (change,) = [c for c in compare(before, after).things if c.before.thing.words.name is None]
    found = change.perhaps and change.perhaps.thing.words.name
    assert (change.fate, change.doubtful, found) == ("lost", bool(shown), perhaps)


INSIDE = Block(4, (100, 100, 150, 150), height=0.08, colour=(240, 240, 240))
OVER = Block(2, (80, 80, 179, 179), height=0.1, colour=(30, 60, 150))


def test_what_lay_in_the_basket_and_shows_again_is_not_new():
    first, second = look(MUG, BOOK, basket=(INSIDE,)), look(MUG, basket=(OVER,))
    hidden = compare(first, second)
    assert [s.thing.words.name for s in hidden.buried] == ["white ball"]
    rolled = moved(INSIDE, 200)
    later = compare(replace(second, buried=hidden.buried), look(basket=(OVER, rolled)))
    assert later.newly_in_basket == later.maybe_in_basket == later.buried == ()
    assert compare(second, look(basket=(OVER, rolled))).newly_in_basket != ()


@pytest.mark.parametrize(("colour", "unclear"), [((240, 240, 240), 0), ((200, 130, 30), 1)])
def test_a_part_in_the_basket_may_be_of_what_lies_there(colour, unclear: int):
    part = Block(1, (200, 100, 220, 150), height=0.02, colour=colour, share=0.1)
    changes = compare(look(MUG, BOOK, basket=(INSIDE,)), look(MUG, basket=(OVER, part)))
    assert changes.newly_in_basket == () and len(changes.maybe_in_basket) == unclear


def test_what_was_missing_is_known_in_the_basket():
    gone = compare(look(MUG, BALL), look(MUG))
    assert [s.thing.words.name for s in gone.missing] == ["white ball"]
    before = replace(look(MUG), missing=gone.missing)
    back = compare(before, look(basket=(INSIDE,)))
    assert [s.thing.words.name for s in back.back_in_basket] == ["white ball"]
    assert back.newly_in_basket == () and [s.thing.words.name for s in back.missing] == ["red mug"]
    assert compare(before, look(MUG, TWIN)).missing == ()


def guessed(seen: Look) -> Look:
    """A look by whoever may outline a thing in two pieces, or in one with its neighbour."""
    return replace(seen, guessed=True)


def test_two_pieces_of_what_was_dropped_are_one_thing_where_outlines_are_guessed():
    pieces = [Block(n, box, 0.08, BALL.colour) for n, box in ((3, LEFT), (4, RIGHT))]
    before, after = look(MUG, BALL), look(MUG, basket=tuple(pieces))
    ball = next(s for s in before.things if s.thing.words.name == "white ball")
    assert len(compare(before, after, ball).newly_in_basket) == 1
    changes = compare(guessed(before), guessed(after), ball)
    assert changes.of(ball).fate == "basket" and changes.newly_in_basket == ()


def test_another_piece_of_what_lay_there_is_nothing_new_where_outlines_are_guessed():
    whole = Block(3, (100, 100, 150, 150), 0.08, BALL.colour)
    pieces = [Block(n, box, 0.05, BALL.colour) for n, box in ((3, LEFT), (4, RIGHT))]
    before, after = look(MUG, basket=(whole,)), look(MUG, basket=tuple(pieces))
    assert len(compare(before, after).newly_in_basket) == 1
    assert compare(guessed(before), guessed(after)).newly_in_basket == ()


def test_what_came_along_is_told_where_outlines_are_guessed():
    inside = Block(3, (100, 100, 150, 150), 0.08, BALL.colour)
    along = Block(2, (200, 100, 250, 150), 0.02, BOOK.colour)
    before, after = look(MUG, BALL), look(MUG, basket=(inside, along))
    changes = compare(guessed(before), guessed(after))
    assert [s.thing.words.name for s in changes.newly_in_basket] == ["blue book"]


@pytest.mark.parametrize("grown", [True, False])
def test_what_was_held_may_be_in_one_piece_with_what_lay_in_the_basket(grown: bool):
    """Where outlines are guessed, the basket shows by its change that something has come."""
    lay = Block(2, (100, 100, 150, 150), 0.02, BOOK.colour)
    lies = Block(2, (100, 100, 199, 199), 0.06, BOOK.colour) if grown else lay
    before, after = look(MUG, BALL, TWIN, basket=(lay,)), look(MUG, basket=(lies,))
    ball = next(s for s in before.things if s.thing.box_px == BALL.box)
    assert compare(before, after, ball).of(ball).fate == "lost"
    changes = compare(guessed(before), guessed(after), ball)
    assert changes.of(ball).fate == ("basket" if grown else "lost")
    assert [change.fate for change in changes.but(ball)] == ["stayed", "lost"]


def test_nothing_is_said_to_be_gone_for_certain_where_outlines_are_guessed():
    """It may be in one piece with its neighbour now, and so may half of what was dropped."""
    before, after = look(MUG, BALL), look(MUG)
    (ball,) = compare(before, after).but(before.things[0])
    assert (ball.fate, ball.doubtful) == ("lost", False)
    (ball,) = compare(guessed(before), guessed(after)).but(before.things[0])
    assert (ball.fate, ball.doubtful) == ("lost", True)
