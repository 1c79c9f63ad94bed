"""A person lays a table like a task's, and says what is true of it."""

from __future__ import annotations

from probe.episodes.grading import question_of
from probe.errors import ArmInView
from probe.runs.session.layout import FOLDER, PAGE, wanted_view, watched, write_layout
from probe.runs.session.operator import LAID, Operator, ask_for
from probe.runs.session.resources import Robot, SessionResources
from probe.runs.session.seal import Truth, truth_of
from probe.tasks.task import Task
from probe.types import Frame


def laid(task: Task, robot: Robot, its: SessionResources) -> Truth:
    """Have a table laid until the person finds there what the suite says of it.

    Raises:
        RobotLost: Its camera doesn't answer.
    """
    folder, operator = its.out / FOLDER, its.operator
    first = _first_look(robot, operator)
    assert first.rgb is not None
    wanted = wanted_view(task, first.camera, its.things, its.renderer)
    write_layout(folder, wanted, first.rgb)
    operator.tell(f"Open {folder / PAGE} in a browser, and lay the table as it shows.")
    while True:
        with watched(folder, robot.station, wanted):
            ask_for(operator, f"Say {LAID} when it lies so: ", (LAID,))
        answer = _asked(task, operator)
        if answer == task.answer:
            note = operator.ask("What differs from the picture? Enter for nothing: ")
            return truth_of(answer, note)
        operator.tell("By the suite it is another letter. Look again, and lay the table anew.")


def _first_look(robot: Robot, operator: Operator) -> Frame:
    while True:
        try:
            return robot.station.observe(rgb=True)
        except ArmInView:
            operator.ask("The arm hides the table. Clear its way; Enter parks it: ")
            robot.park()


def _asked(task: Task, operator: Operator) -> str:
    options = question_of(task).options
    operator.tell(task.question, *(f"{letter}: {text}" for letter, text in options))
    letters = [letter for letter, _ in options]
    return ask_for(operator, "Which letter is right on this table? ", letters)
