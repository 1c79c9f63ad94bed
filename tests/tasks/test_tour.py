"""The suite of the demo: a task of each of seven types, none of which is new."""

from probe.tasks.suite_file import TaskDocument, packaged_suite

TOUR = packaged_suite("tour")


def test_each_type_of_a_packaged_suite_has_a_task():
    seven = ["behind", "beneath", "compare", "count", "find", "reduce", "size"]
    assert sorted(task.question_type for task in TOUR.tasks) == seven


def test_its_tasks_are_those_of_frozen_suites_to_the_byte():
    suites = [packaged_suite(name) for name in ("demo", "v1.1", "behind")]
    frozen = {
        task.id: (TaskDocument.of(task).digest(), suite.objects)
        for suite in suites
        for task in suite.tasks
    }
    for task in TOUR.tasks:
        digest, objects = frozen[task.id]
        assert TaskDocument.of(task).digest() == digest
        for placed in task.scene.objects:
            assert TOUR.objects[placed.object_id] == objects[placed.object_id]
