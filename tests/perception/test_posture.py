from dataclasses import replace

import numpy as np
import pytest

from probe.perception.posture import described, has_top, posture
from probe.types import Pose
from tabletops import spec


def turned(degrees, axis=0):
    """A pose after a turn about x or y."""
    half = np.radians(degrees) / 2
    wxyz = np.array([np.cos(half), 0.0, 0.0, 0.0])
    wxyz[1 + axis] = np.sin(half)
    return Pose.of(np.zeros(3), wxyz)


def thing(name, size, description="", *, hollow=False):
    return replace(spec(name, description=description or f"A {name}."), size=size, hollow=hollow)


BOX = thing("cardboard box", (0.1, 0.1, 0.06), "A cardboard box, open at the top.", hollow=True)
POT = thing("flower pot", (0.1, 0.1, 0.09), "An empty flower pot.", hollow=True)
BOTTLE = thing("water bottle", (0.07, 0.2, 0.07), "A steel bottle with a cap, lying down.")
BALL = thing("ball", (0.07, 0.07, 0.07))
BOOK = thing("book", (0.1, 0.15, 0.02))
CAN = thing("can", (0.06, 0.06, 0.11))


@pytest.mark.parametrize(
    ("what", "degrees", "axis", "how"),
    [
        (BOX, 0, 0, "as told"),
        (BOX, 10, 0, "as told"),
        (BOX, 45, 0, "tilted"),
        (BOX, 90, 1, "lying on its side"),
        (BOX, 135, 0, "tilted"),
        (BOX, 175, 0, "upside down"),
        (CAN, 90, 0, "lying on its side"),
        (CAN, 180, 0, "rolled"),
        (BOTTLE, 90, 0, "standing on end"),
        (BOTTLE, 90, 1, "rolled"),
        (BOTTLE, 45, 0, "tilted"),
        (BALL, 180, 0, "rolled"),
        (BALL, 90, 0, "rolled"),
        (BOOK, 180, 0, "rolled"),
        (BOOK, 90, 1, "standing on edge"),
    ],
)
def test_how_things_lie(what, degrees, axis, how):
    assert posture(what, turned(degrees, axis)) == how


@pytest.mark.parametrize(
    ("what", "degrees", "axis", "text"),
    [
        (BOX, 0, 0, "A cardboard box, open at the top."),
        (BOX, 180, 0, "A cardboard box, upside down."),
        (BOX, 90, 0, "A cardboard box, lying on its side."),
        (BOX, 45, 0, "A cardboard box."),
        (POT, 180, 0, "A flower pot, upside down."),
        (BOTTLE, 0, 0, "A steel bottle with a cap, lying down."),
        (BOTTLE, 90, 1, "A steel bottle with a cap, lying down."),
        (BOTTLE, 90, 0, "A steel bottle with a cap, standing on end."),
        (BOTTLE, 45, 0, "A steel bottle with a cap."),
        (BALL, 180, 0, "A ball."),
    ],
)
def test_what_holds_is_said_and_what_does_not_is_not(what, degrees, axis, text):
    assert described(what, posture(what, turned(degrees, axis))) == text


def test_vessels_and_some_other_kinds_have_a_top():
    assert has_top(POT) and has_top(thing("teapot", (0.2, 0.1, 0.1)))
    assert not has_top(BALL) and not has_top(CAN)


def test_an_article_fits_what_is_left():
    bowl = thing("bowl", (0.2, 0.2, 0.1), "An empty orange bowl.", hollow=True)
    assert described(bowl, "upside down") == "An orange bowl, upside down."
    pot = thing("flower pot", (0.1, 0.1, 0.09), "A white empty flower pot.", hollow=True)
    assert described(pot, "lying on its side") == "A white flower pot, lying on its side."
