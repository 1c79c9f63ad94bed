from dataclasses import replace

from played_examples import played
from probe.report.highlight import highlight_of
from probe.tasks.task import Task
from run_folders import DEMO, episode

NAMED = next(task for task in DEMO.tasks if task.answer != "E")
NONE_OF_THEM = next(task for task in DEMO.tasks if task.answer == "E")


def lifted(task: Task, *, moves: str = "done", right: bool = True, run: int = 0):
    """An episode whose second step, a grasp, went like this."""
    record = episode(task, right=right, run=run)
    find, grasp, push, last = record.steps
    return played(replace(record, steps=(find, replace(grasp, status=moves), push, last)))


def test_the_first_picture_the_thing_found_and_what_came_to_light():
    found = highlight_of([lifted(NAMED)])
    assert found is not None
    assert [shot.picture for shot in found.shots] == [f"pictures/{n}.webp" for n in range(3)]
    assert "lifted into the basket" in found.shots[2].caption


def test_an_answer_that_names_something_comes_first():
    found = highlight_of([lifted(NONE_OF_THEM), lifted(NAMED), lifted(NAMED, right=False)])
    assert found is not None
    assert (found.played.task, found.alike) == (NAMED, 2)


def test_nothing_is_made_up_where_nothing_worked():
    assert highlight_of([lifted(NAMED, right=False), lifted(NAMED, moves="failed")]) is None
    assert highlight_of([]) is None


def test_a_film_stands_before_what_it_led_to():
    found = highlight_of([replace(lifted(NAMED), clips=((2, "clips/a.webm"),))])
    assert found is not None
    assert [shot.clip for shot in found.shots] == [None, None, "clips/a.webm", None]
    assert found.shots[2].caption == "It is lifted into the basket"
