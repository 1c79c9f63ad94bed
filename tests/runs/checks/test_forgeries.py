"""What a forger may write into a folder of records, and what the checks say of it."""

from __future__ import annotations

import json
from dataclasses import replace

import pytest

from forgeries import GRASP, LOOK, TASK, honest, moved, with_step, with_steps, write_folder
from probe.api.grading import graded
from probe.api.rows import SCORES
from probe.cli.merge import merge
from probe.cli.rescore import rescore
from probe.episodes.conditions import Conditions
from probe.episodes.folder import SUITE
from probe.episodes.noise import NOISES
from probe.episodes.participation import ModelReply, Participation
from probe.episodes.record import Seconds, Step, TableState
from probe.episodes.turns import Call, Question
from probe.errors import BadData
from probe.runs.checks.folder import check_records, read_checked
from probe.runs.variation import Variation, digest_of_tasks, write_variation
from probe.scene.lighting import Lighting
from probe.scene.viewpoint import Viewpoint
from probe.tasks.suite import part, selection
from probe.tasks.suite_file import packaged_suite, read_suite, write_suite
from probe.tasks.task import Task
from probe.toolshed.result import Answer
from run_folders import DEMO

HONEST = honest()
START, AFTER = HONEST.start, HONEST.steps[2].after
OTHER = "A" if TASK.answer != "A" else "B"
SPEECH = ModelReply(0, f"I see it.\nANSWER: {TASK.answer} (100, 200)")
SPOKEN = Participation("direct", replies=(ModelReply(0, "Hm."), SPEECH))
CALLED = Participation("agentic", replies=(ModelReply(3), ModelReply(1)))
IN_WORDS = replace(with_steps(HONEST), participation=SPOKEN, seconds=Seconds())
"""An honest record of a model that has no tools."""

WITH_TOOLS = replace(HONEST, participation=CALLED)


def checked(out):
    return read_checked(out, read_suite(out / SUITE))


def answer_of(choice: str, **more: object) -> Step:
    return replace(HONEST.steps[-1], call=Call.of("answer_question", {"choice": choice, **more}))


def scene_without_a_thing():
    gone = TASK.scene.objects[-1].instance
    return TableState(TASK.scene.without(gone), START.joints)


def everywhere_without_a_thing():
    """Objects taken out of every scene, so that these still follow from one another."""
    gone = TASK.scene.objects[-1].instance
    start = scene_without_a_thing()
    after = TableState(AFTER.scene.without(gone), AFTER.joints)
    steps = [replace(it, after=start if it.after == START else after) for it in HONEST.steps]
    return replace(HONEST, start=start, steps=tuple(steps))


LOOKED = Step(LOOK, "done", "objects: []", None, START)
REST = HONEST.steps[1:]

FORGERIES = {
    "the answer isn't the last call's": (
        replace(HONEST, answer=Answer(OTHER, (100.0, 200.0))),
        f"its answer is '{OTHER}' at .*, and its last call says '{TASK.answer}' at",
    ),
    "the point isn't the last call's": (
        replace(HONEST, answer=Answer(TASK.answer, (101.0, 200.0))),
        r"its answer is .* at \(101, 200\), and its last call says .* at \(100, 200\)",
    ),
    "all steps deleted": (
        with_steps(HONEST),
        "its answer is .*, and its last call says none",
    ),
    "145 steps": (
        with_steps(HONEST, *[LOOKED] * 142, *REST),
        "it has 145 calls, and the rules allow 40",
    ),
    "11 manipulations": (
        with_steps(HONEST, LOOKED, REST[0], *[REST[1]] * 11, REST[2]),
        "it has 11 manipulations, and the rules allow 10",
    ),
    "out of turns, with an answer": (
        replace(HONEST, end="out_of_turns"),
        'it has an answer, and its end is "out_of_turns"',
    ),
    "stopped, with an answer": (
        replace(HONEST, end="stopped"),
        'it has an answer, and its end is "stopped"',
    ),
    "a fault, with an answer": (
        replace(HONEST, end="fault", fault="gone"),
        'it has an answer, and its end is "fault"',
    ),
    "a wrong answer made a fault": (
        replace(HONEST, end="fault", fault="gone", answer=None),
        "its answer is none, and its last call says",
    ),
    "a fault without words": (
        replace(with_steps(HONEST, LOOKED), end="fault", answer=None),
        'it tells of none, and its end is "fault"',
    ),
    "an answer deleted": (
        replace(HONEST, end="stopped", answer=None),
        "its answer is none, and its last call says",
    ),
    "a second try": (
        with_steps(HONEST, *HONEST.steps[:3], answer_of(OTHER, point=[1, 2]), HONEST.steps[3]),
        "calls follow its answer",
    ),
    "a first answer called malformed": (
        with_steps(
            HONEST,
            replace(answer_of(OTHER, point=[1, 2]), status="malformed", after=START),
            *HONEST.steps,
        ),
        r'step 1 \(answer_question\): it is "malformed", and such a call can only be done',
    ),
    "out of turns early": (
        replace(with_steps(HONEST, LOOKED), end="out_of_turns", answer=None),
        'its end is "out_of_turns" after 1 of 40 turns',
    ),
    "objects taken out of the start": (
        replace(HONEST, start=scene_without_a_thing()),
        "its table at the start isn't that of the suite",
    ),
    "objects taken out of all scenes": (
        everywhere_without_a_thing(),
        "its table at the start isn't that of the suite",
    ),
    "objects taken out on the way": (
        with_step(HONEST, 2, after=scene_without_a_thing()),
        r"step 3 \(grasp_and_remove\): other objects are on the table afterwards",
    ),
    "the target lies elsewhere at the start": (
        replace(HONEST, start=TableState(moved(TASK.scene, TASK.targets[0]), START.joints)),
        "its table at the start isn't that of the suite",
    ),
    "a look moves the target": (
        with_step(HONEST, 0, after=TableState(moved(TASK.scene, TASK.targets[0]), START.joints)),
        r"step 1 \(perceive_scene\): the table is another one afterwards, though it moves nothing",
    ),
    "an answer moves the target": (
        with_step(HONEST, 3, after=TableState(moved(AFTER.scene, TASK.targets[0]), AFTER.joints)),
        r"step 4 \(answer_question\): the table is another one afterwards",
    ),
    "an answer moves the setting": (
        with_step(HONEST, 3, after=TableState(AFTER.scene, (0.2,) * 6)),
        r"step 4 \(answer_question\): the table is another one afterwards",
    ),
    "a refused grasp moves things": (
        with_step(HONEST, 2, status="malformed"),
        r"step 3 \(grasp_and_remove\): the table is another one afterwards",
    ),
    "a call that fits no tool": (
        with_step(HONEST, 2, call=replace(GRASP, arguments='{"object": 1}')),
        'step 3 .*: it is "done", and such a call can only be malformed',
    ),
    "a refusal with manipulations left": (
        with_step(HONEST, 2, status="refused", after=START),
        'step 3 .*: it is "refused", and such a call can only be done or failed or malformed',
    ),
    "another question": (
        replace(HONEST, question=replace(HONEST.question, text="What is 2 + 2?")),
        "its question isn't that of the suite",
    ),
    "other options": (
        replace(HONEST, question=Question(TASK.question, (("A", "yes"), ("B", "no")))),
        "its options aren't those of the suite",
    ),
    "a run beyond those ordered": (
        replace(HONEST, run=2),
        "2 runs of each task were ordered, numbered from 0",
    ),
    "nobody": (replace(HONEST, agent=" "), "its agent has no name"),
    "too few times": (
        replace(HONEST, seconds=Seconds((1.0,) * 3, (1.0,) * 4)),
        "it has 3 times of its agent for 4 calls",
    ),
    "times of one side": (
        replace(HONEST, seconds=Seconds((), (1.0,) * 4)),
        "it has times of one side alone",
    ),
    "a time below 0": (
        replace(HONEST, seconds=Seconds((1.0,) * 4, (-1.0,) * 4)),
        "a time of its tools is below 0",
    ),
    "another light than its conditions": (
        replace(HONEST, viewpoint=Viewpoint(lighting=Lighting("loft", 0.5))),
        "its light isn't that of its conditions",
    ),
    "a camera that didn't stray": (
        replace(HONEST, conditions=Conditions(camera="moved")),
        "its camera isn't where its conditions put it",
    ),
    "free words after a setting": (
        replace(WITH_TOOLS, participation=replace(CALLED, setting="agentic, pointing self")),
        "There is no setting called 'agentic, pointing self'",
    ),
    "nobody who points": (
        replace(WITH_TOOLS, participation=replace(CALLED, setting="agentic, pointer ")),
        "There is no setting called 'agentic, pointer '",
    ),
    "a setting without a space": (
        replace(WITH_TOOLS, participation=replace(CALLED, setting="agentic,pointer self")),
        "There is no setting called 'agentic,pointer self'",
    ),
    "a pointer without tools": (
        replace(IN_WORDS, participation=replace(SPOKEN, setting="direct, pointer self")),
        "There is no setting called 'direct, pointer self'",
    ),
    "an unknown setting": (
        replace(WITH_TOOLS, participation=replace(CALLED, setting="agentical")),
        "There is no setting called 'agentical'",
    ),
    "tools in a setting without": (
        replace(HONEST, participation=SPOKEN),
        "it has calls, and nobody has tools in the setting 'direct'",
    ),
    "calls that no reply made": (
        replace(WITH_TOOLS, participation=replace(CALLED, replies=(ModelReply(3),))),
        "its model's replies made 3 calls, and it has 4",
    ),
    "words that say otherwise": (
        replace(IN_WORDS, answer=Answer(OTHER, (100.0, 200.0))),
        f"its answer is '{OTHER}' at .*, and its replies say '{TASK.answer}' at",
    ),
    "words that point elsewhere": (
        replace(IN_WORDS, answer=Answer(TASK.answer, (300.0, 200.0))),
        r"its answer is .* at \(300, 200\), and its replies say .* at \(100, 200\)",
    ),
    "many replies without tools": (
        replace(IN_WORDS, participation=replace(SPOKEN, replies=(SPEECH,) * 3)),
        "a model makes 2 replies at most",
    ),
    "a cost below 0": (
        replace(WITH_TOOLS, participation=replace(CALLED, cost=-1.0)),
        "its tokens or their cost are below 0",
    ),
}


@pytest.mark.parametrize("record", [HONEST, IN_WORDS, WITH_TOOLS], ids=["tools", "words", "model"])
def test_honest_records_pass(tmp_path, record):
    assert checked(write_folder(tmp_path, record)) == [record]


@pytest.mark.parametrize("name", FORGERIES)
def test_a_forgery_is_refused_by_file_line_and_reason(tmp_path, name):
    record, reason = FORGERIES[name]
    out = write_folder(tmp_path, replace(HONEST, run=1), record)
    whose = rf"records\.jsonl, line 2: {TASK.id}, run {record.run} of {record.agent}: "
    with pytest.raises(BadData, match=whose + ".*" + reason):
        checked(out)


def test_no_score_comes_of_a_forged_folder(tmp_path):
    forged, _ = FORGERIES["all steps deleted"]
    out = write_folder(tmp_path / "run", forged)
    with pytest.raises(BadData, match="its last call says none"):
        rescore(out)
    assert not (out / SCORES).exists()
    with pytest.raises(BadData, match="its last call says none"):
        merge((out,), tmp_path / "merged")
    assert not (tmp_path / "merged").exists()
    with pytest.raises(BadData, match="its last call says none"):
        graded(out)


def test_all_lines_that_do_not_agree_are_counted(tmp_path):
    forged, _ = FORGERIES["145 steps"]
    out = write_folder(tmp_path, forged, replace(forged, run=1))
    with pytest.raises(BadData, match="line 1: .* 1 more lines don't agree either"):
        checked(out)


def test_noise_and_conditions_are_those_of_the_folder(tmp_path):
    loud = replace(HONEST, run=1, noise=NOISES["paper"])
    with pytest.raises(BadData, match="line 2: .*its noise or its conditions aren't those"):
        checked(write_folder(tmp_path / "noise", HONEST, loud))
    ideal = replace(HONEST, run=1, conditions=Conditions(ideal="grasp"))
    with pytest.raises(BadData, match="line 2: .*its noise or its conditions aren't those"):
        checked(write_folder(tmp_path / "ideal", HONEST, ideal))


def test_conditions_are_those_that_the_tables_were_made_for(tmp_path):
    other = replace(HONEST, conditions=Conditions(table="other"))
    out = write_folder(tmp_path, other)
    with pytest.raises(BadData, match=r"run under table other, and variation\.json is missing"):
        checked(out)
    known = Variation(base="0", conditions="jitter 3 mm", notes={})
    write_variation(out, known)
    with pytest.raises(BadData, match=r"its conditions aren't those of variation\.json"):
        checked(out)
    write_variation(out, known.model_copy(update={"conditions": "table other"}))
    with pytest.raises(BadData, match=r"variation\.json: wasn't made from the packaged demo"):
        checked(out)
    base = digest_of_tasks(DEMO.tasks)
    write_variation(out, known.model_copy(update={"conditions": "table other", "base": base}))
    assert checked(out) == [other]


def test_a_run_has_one_result(tmp_path):
    fault = replace(with_steps(HONEST, LOOKED), answer=None, end="fault", fault="gone")
    assert len(checked(write_folder(tmp_path / "good", fault, fault, HONEST))) == 3
    with pytest.raises(BadData, match="line 2: .*the same run has a result above"):
        checked(write_folder(tmp_path / "bad", HONEST, HONEST))


def test_places_in_thousandths_may_be_rounded(tmp_path):
    said = ModelReply(0, f"ANSWER: {TASK.answer} (98, 195)")
    seat = Participation("direct", "0-1000", (said,))
    # 98 and 195 thousandths of 1024 pixels are 100.352 and 199.68.
    record = replace(IN_WORDS, participation=seat)
    assert checked(write_folder(tmp_path / "near", record)) == [record]
    far = replace(record, answer=Answer(TASK.answer, (102.0, 200.0)))
    with pytest.raises(BadData, match="its replies say"):
        checked(write_folder(tmp_path / "far", far))


def rewritten(out, tasks: tuple[Task, ...], name: str = "demo"):
    """The folder with other tasks, with right hashes and a right checksum."""
    write_suite(out / SUITE, replace(DEMO, name=name, tasks=tasks))
    return out


def test_a_suite_with_a_packaged_name_is_the_packaged_one(tmp_path):
    others = tuple(replace(it, answer=OTHER) if it == TASK else it for it in DEMO.tasks)
    out = rewritten(write_folder(tmp_path, HONEST), others)
    words = rf"suite\.json: is called demo but isn't .*task {TASK.id} .*its answer differs"
    with pytest.raises(BadData, match=words):
        checked(out)
    assert len(checked(rewritten(out, others, "mine"))) == 1


def test_another_fingerprint_under_a_packaged_name_is_refused(tmp_path):
    out = write_folder(tmp_path, HONEST)
    id, mark = next(iter(DEMO.objects.items()))
    write_suite(out / SUITE, replace(DEMO, objects={**DEMO.objects, id: (*mark[:-1], 0.25)}))
    with pytest.raises(BadData, match=f"the fingerprint of {id} is another one there"):
        checked(out)


def test_a_part_of_a_packaged_suite_may_keep_its_name(tmp_path):
    out = write_folder(tmp_path, HONEST)
    write_suite(out / SUITE, part(DEMO, TASK))
    assert len(checked(out)) == 1
    write_suite(out / SUITE, selection(DEMO, DEMO.tasks[::-1], "demo"))
    with pytest.raises(BadData, match="its tasks stand in another order"):
        checked(out)
    v1 = packaged_suite("v1")
    write_suite(out / SUITE, selection(v1, v1.tasks[:2], "demo"))
    with pytest.raises(BadData, match=r"is not in suite\.json"):
        checked(out)
    write_suite(out / SUITE, replace(DEMO, name="v1"))
    with pytest.raises(BadData, match="is called v1 but isn't .*that has no task"):
        checked(out)


def test_a_record_of_no_task_is_refused(tmp_path):
    out = write_folder(tmp_path, replace(HONEST, task="find-00000000"))
    with pytest.raises(BadData, match=r"find-00000000 is not in suite\.json"):
        checked(out)


def test_a_forged_line_has_a_right_checksum(tmp_path):
    """The checksum isn't what catches forgeries: whoever forges can make one."""
    out = write_folder(tmp_path, FORGERIES["145 steps"][0])
    (line,) = (out / "records.jsonl").read_text().splitlines()
    assert len(json.loads(line)["steps"]) == 145


ASKED = replace(answer_of(TASK.answer), status="malformed", text="Give a point.", after=AFTER)
POINTLESS = replace(HONEST, answer=Answer(TASK.answer, None))


def test_an_answer_may_lack_its_point_once_it_was_asked_for(tmp_path):
    with_point = with_steps(HONEST, *HONEST.steps[:3], ASKED, HONEST.steps[3])
    without = with_steps(POINTLESS, *HONEST.steps[:3], ASKED, answer_of(TASK.answer))
    for number, record in enumerate((with_point, without)):
        assert checked(write_folder(tmp_path / str(number), record)) == [record]


def test_an_answer_without_its_point_was_asked_for_it(tmp_path):
    record = with_steps(POINTLESS, *HONEST.steps[:3], answer_of(TASK.answer))
    with pytest.raises(BadData, match='it is "done", and such a call can only be malformed'):
        checked(write_folder(tmp_path / "now", record))
    first = replace(record, tools=1)
    assert checked(write_folder(tmp_path / "then", first)) == [first]


def test_a_letter_that_is_not_offered_is_no_answer(tmp_path):
    suite = packaged_suite("v1")
    task = next(task for task in suite.tasks if task.question_type == "size")
    made = honest(task)
    last = replace(made.steps[-1], call=Call.of("answer_question", {"choice": "E"}))
    record = with_steps(replace(made, answer=Answer("E", None)), *made.steps[:3], last)
    with pytest.raises(BadData, match='it is "done", and such a call can only be malformed'):
        check_records([record], suite, tmp_path)
    check_records([replace(record, tools=1)], suite, tmp_path)


def test_tools_are_those_of_the_folder(tmp_path):
    with pytest.raises(BadData, match="line 2: .*the version of its tools isn't that of the first"):
        checked(write_folder(tmp_path, HONEST, replace(HONEST, run=1, tools=1)))
