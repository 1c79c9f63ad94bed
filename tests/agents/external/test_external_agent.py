"""An agent of a file is handed question and history, and its calls come back."""

import json

import numpy as np
import pytest

from probe.agents.external.external_agent import seed_of
from probe.agents.external.factory import introduced
from probe.agents.external.sandbox import AgentFile, Sandbox
from probe.episodes.turns import Call, Question, Turn
from probe.errors import BadData
from probe.toolshed.result import ToolResult
from probe.types import PictureScale

QUESTION = Question("What is under the mug?", (("A", "a die"), ("B", "a key")))
PICTURE = np.arange(2 * 3 * 3, dtype=np.uint8).reshape(2, 3, 3)


def turn(name, text="Done: it is gone.", picture=None):
    result = ToolResult(text, picture, status="failed", point_px=(3, 4))
    return Turn(Call.of(name, {"n": 1}, "So."), result)


TELLS = """
import json

class Tells:
    def act(self, question, history):
        seen = [[t.call.name, t.call.values, t.call.words, t.result.text, t.result.status,
                 t.result.point_px, t.result.picture is None] for t in history]
        return Call.of("push", {"asked": question.text, "options": question.options, "seen": seen},
                       "Why not?")
"""


def test_it_gets_the_question_and_all_turns_so_far(outsider):
    agent = outsider(TELLS)
    first = agent.act(QUESTION, ())
    assert (first.name, first.words) == ("push", "Why not?")
    assert first.values == {
        "asked": "What is under the mug?",
        "options": [["A", "a die"], ["B", "a key"]],
        "seen": [],
    }
    # Of a result it gets the text: status and point are for statistics.
    told = ["{}", {"n": 1}, "So.", "Done: it is gone.", "done", None, True]
    one, two = turn("look"), turn("grasp")
    assert agent.act(QUESTION, (one,)).values["seen"] == [["look", *told[1:]]]
    assert agent.act(QUESTION, (one, two)).values["seen"] == [
        ["look", *told[1:]],
        ["grasp", *told[1:]],
    ]
    assert agent.fault is None


MEASURES = """
class Measures:
    def act(self, question, history):
        scale = question.scale
        told = [scale.side_px, scale.width, scale.oblique, scale.opening, question.manipulations]
        return Call.of("push", {"told": told})
"""


@pytest.mark.parametrize("manipulations", [None, 3])
def test_it_is_told_how_much_a_picture_shows_and_how_often_it_may_move_things(
    outsider, manipulations
):
    seen = PictureScale(800, 0.4, oblique=True, opening=0.085)
    question = Question("?", (), scale=seen, manipulations=manipulations)
    told = outsider(MEASURES).act(question, ()).values["told"]
    assert told == [800, 0.4, True, 0.085, manipulations]


def test_none_ends_the_episode_and_is_no_fault(outsider):
    agent = outsider("class Shy:\n    def act(self, question, history):\n        return None\n")
    assert agent.act(QUESTION, ()) is None
    assert agent.fault is None


SEES = """
class Sees:
    pictures = True
    def act(self, question, history):
        seen = [question.picture, *(t.result.picture for t in history)]
        return Call.of("push", {"seen": [s is not None and s.tolist() for s in seen]})
"""


def test_pictures_arrive_pixel_for_pixel(outsider, invite):
    assert introduced(invite(SEES))[1].pictures is True
    assert introduced(invite(TELLS))[1].pictures is False
    question = Question(QUESTION.text, QUESTION.options, PICTURE)
    call = outsider(SEES).act(question, (turn("look", picture=255 - PICTURE), turn("push")))
    assert call.values["seen"] == [PICTURE.tolist(), (255 - PICTURE).tolist(), False]


PRINTS = """
import sys
print("loaded")

class Prints:
    def act(self, question, history):
        print("thinking \\x1b[31mred")
        sys.stderr.write("no newline")
        sys.stdout.write('{"call": null}\\n')
        return Call.of("answer_question", {"choice": "B"})
"""


def test_prints_go_to_the_log_and_break_nothing(outsider, tmp_path):
    agent = outsider(PRINTS)
    assert agent.act(QUESTION, ()).values == {"choice": "B"}
    agent.close()
    assert (tmp_path / "agent.log").read_text() == (
        "== task-1, run 0 ==\nloaded\nthinking \ufffd[31mred\nno newline" + '{"call": null}\n'
    )
    assert agent.fault is None


SEEDED = """
import random

class Seeded:
    def __init__(self, seed):
        self._seed = seed
    def act(self, question, history):
        words = list({"mug", "die", "key", "tape", "bowl", "spoon"})
        return Call.of("push", {"seed": self._seed, "set": words})
"""


def test_the_same_question_and_run_give_the_same_agent(outsider):
    first, again, other = (outsider(SEEDED, run=run).act(QUESTION, ()) for run in (0, 0, 1))
    assert first == again != other
    assert first.values["set"] == other.values["set"]


def test_the_seed_follows_from_what_the_agent_is_told_anyway():
    """So that it is no way to a task's seed: whoever has the question can work it out."""
    import hashlib

    text = '["What is under the mug?", [["A", "a die"], ["B", "a key"]], 2]'
    digest = hashlib.sha256(text.encode()).digest()
    assert seed_of(QUESTION, 2) == int.from_bytes(digest[:8], "big")


TWO = """
class One:
    def act(self, question, history): return None
class Two(One):
    pass
def three():
    return Two()
def four():
    return 4
"""


@pytest.mark.parametrize(
    ("code", "name", "words"),
    [
        (TWO, None, "it needs one class with act(), or its name after a colon; found: One, Two"),
        ("", None, "found: none"),
        (TWO, "Five", "there is no class or function called Five in it"),
        (TWO, "four", "four makes something that has no act(question, history)"),
        ("import nowhere", None, "ModuleNotFoundError: No module named 'nowhere'"),
        ("class A(", None, "SyntaxError"),
        ("raise SystemExit(3)", None, "SystemExit: 3"),
        ("import os; os._exit(3)", None, "ended its process with status 3"),
    ],
)
def test_a_file_without_an_agent_is_refused_in_words(invite, code, name, words):
    with pytest.raises(BadData) as error:
        introduced(invite(code, name))
    assert words in str(error.value)
    assert "agent.py: " in str(error.value) and "docs/reference/agents.md" in str(error.value)


def test_a_function_may_make_it(invite):
    assert introduced(invite(TWO, "three"))[1].name == "three"


def test_its_files_and_modules_are_those_it_was_allowed(outsider, tmp_path):
    folder = tmp_path / "weights"
    folder.mkdir()
    (folder / "lore.py").write_text("WORDS = 'from beside'\n")
    (tmp_path / "secret.txt").write_text("42")
    code = f"""
    class Reads:
        def act(self, question, history):
            from lore import WORDS
            try:
                secret = open({str(tmp_path / "secret.txt")!r}).read()
            except OSError as error:
                secret = type(error).__name__
            return Call.of("push", {{"words": WORDS, "secret": secret}})
    """
    agent = outsider(code, sandbox=Sandbox(files=(folder,)))
    assert json.loads(agent.act(QUESTION, ()).arguments)["words"] == "from beside"


@pytest.mark.parametrize(
    ("sandbox", "words"),
    [
        (Sandbox(seconds=0), "--sandbox.seconds: is 0. Say more than 0"),
        (Sandbox(seconds=float("nan")), "--sandbox.seconds: is nan"),
        (Sandbox(memory_gb=0.1), "--sandbox.memory-gb: is 0.1, too little"),
    ],
)
def test_a_sandbox_that_cannot_be_is_refused(sandbox, words):
    with pytest.raises(BadData, match=words):
        sandbox.check()


def test_a_file_that_is_not_there_is_refused(tmp_path):
    with pytest.raises(BadData, match=r"none.py: there is no such file"):
        AgentFile.of(str(tmp_path / "none.py:Name"))
