"""What a client is told besides the tools' own texts: product text. Knows no answer."""

from __future__ import annotations

from probe.episodes.turns import Question
from probe.toolshed.toolshed import MANIPULATIONS, TURNS

_INSTRUCTIONS = """\
Before you stands a table with a pile of objects, seen by a camera, with a robot arm beside it. \
You are asked one question about these objects. Often the first picture doesn't show the answer: \
then move what is in the way and look again. Answer with answer_question. You may answer once; an \
episode that ends without an answer counts as wrong.

You have {turns} tool calls in all, and {manipulations} of them may be grasps or pushes."""


def question_text(question: Question) -> str:
    """The question and its options, one a line."""
    return "\n".join([question.text, *(f"{letter}: {text}" for letter, text in question.options)])


def instructions(question: Question) -> str:
    """How an episode goes, and what is asked."""
    allowed = question.manipulations
    budget = MANIPULATIONS if allowed is None else allowed
    told = _INSTRUCTIONS.format(turns=TURNS, manipulations=budget)
    return f"{told}\n\nThe question:\n{question_text(question)}"
