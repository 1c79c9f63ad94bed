from __future__ import annotations

from probe.assets.library import Library
from probe.generation.restored_stage import RestoredStage
from probe.scene.scene import PlacedObject, Scene
from probe.types import Pose


def scene(*placed: tuple[int, str, Pose]) -> Scene:
    return Scene(0, "t", tuple(PlacedObject(*each) for each in placed))


def test_what_lies_flat_stays_and_keeps_its_number(library: Library):
    # An object's own frame has the resting pose's underside at z = 0.
    book = (9, "proc_red_book", Pose((0.1, 0.0, 0.0)))
    can = (4, "proc_corn_can", Pose((-0.1, 0.0, 0.0)))
    bare = RestoredStage.of(scene(book, can), library)
    assert bare.unrest() is None
    assert bare.places(4, 9) == [2, 1]
    without = bare.moved({2: Pose((0.0, 0.05, 0.0))})
    assert [(o.instance, o.pose.position) for o in without.objects] == [(4, (0.0, 0.05, 0.0))]


def test_what_balances_on_an_edge_is_found_to_move(library: Library):
    height = library["proc_red_book"].size[2]
    # Two thirds of the can's foot stand beyond the book's long edge.
    beyond = library["proc_red_book"].size[0] / 2 + library["proc_corn_can"].size[0] / 6
    tipping = scene((1, "proc_red_book", Pose()), (2, "proc_corn_can", Pose((beyond, 0.0, height))))
    found = RestoredStage.of(tipping, library).unrest() or "something moves by 0 mm"
    assert float(found.split()[3]) > 10
