import numpy as np

from probe.episodes.ideal_grasp import IdealGrasp
from probe.scene.setup import UR5_TABLE
from probe.types import Frame

LABELS = np.zeros((8, 8), np.int32)
LABELS[:4, :4], LABELS[4:, 4:] = 1, 2
FRAME = Frame(UR5_TABLE.top.camera(8), np.ones((8, 8), np.float32), labels=LABELS)
AFTER = Frame(UR5_TABLE.top.camera(8), np.zeros((8, 8), np.float32))


class Table:
    """A table whose things vanish, and a station that sees one picture."""

    def __init__(self):
        self.taken = []

    def take_away(self, instance):
        self.taken.append(instance)

    def observe(self, *, rgb):
        assert not rgb
        return AFTER


class Pushed:
    """Skills whose pushes can be told from others."""

    def push(self, *arguments):
        return arguments


def grasp(mask):
    table = Table()
    outcome = IdealGrasp(Pushed(), table).grasp_and_remove(table, FRAME, mask, (0, 0, 0))  # pyright: ignore[reportArgumentType]
    return outcome, table


def test_the_thing_that_most_of_the_mask_shows_is_taken():
    mask = LABELS == 2
    mask[0, 0] = True
    outcome, table = grasp(mask)
    assert (outcome.status, outcome.frame, table.taken) == ("removed", AFTER, [2])


def test_there_is_nothing_to_take_of_the_bare_table():
    outcome, table = grasp(LABELS == 0)
    assert (outcome.status, outcome.frame, table.taken) == ("no_candidate", FRAME, [])


def test_pushes_are_as_they_would_be():
    ideal, arguments = IdealGrasp(Pushed(), Table()), (1, 2, 3, "up", 0.1, (0, 0, 0))  # pyright: ignore[reportArgumentType]
    assert ideal.push(*arguments) == arguments  # pyright: ignore[reportArgumentType]
