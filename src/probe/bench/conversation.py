"""How an episode goes with a model: with tools until it answers, or in words at once."""

from __future__ import annotations

from inspect_ai.model import ChatMessageAssistant, ChatMessageTool

from probe.bench.model_conversation import ModelConversation
from probe.bench.process_pool import Assignment
from probe.bench.wire import call_of, result_message
from probe.episodes.grading import answer_form
from probe.episodes.participation import ModelReply, Points
from probe.runs.worker_messages import CallResult
from probe.tasks.task import Task
from probe.toolshed.result import Answer
from probe.transcripts.answers import read_answer
from probe.transcripts.coordinates import meant
from probe.transcripts.messages import pictureless_first
from probe.transcripts.prompts import Graphs, Setting, reminder
from probe.transcripts.result_texts import ResultTexts


async def with_tools(
    conversation: ModelConversation,
    assignment: Assignment,
    points: Points,
    graphs: Graphs = "full",
) -> None:
    """Let a model call tools until the episode ends; it is reminded once in a row to call one.

    Args:
        conversation: With the model.
        assignment: The table.
        points: How the model counts places.
        graphs: How lists are told to it.

    Raises:
        ModelFailed: No reply came.
        TableLost: The table failed too often.
    """
    reminded, texts = False, ResultTexts(points, graphs)
    while True:
        said = await conversation.reply()
        if said.tool_calls:
            reminded = False
            if await _carried_out(said, conversation, assignment, points, texts):
                return
            continue
        conversation.replies.append(ModelReply(0, said.text))
        if reminded:
            return
        reminded = True
        conversation.say(reminder("agentic"))


async def in_words(
    conversation: ModelConversation, setting: Setting, task: Task, points: Points
) -> Answer | None:
    """What a model answers that has no tools; it is reminded once, of the point too.

    Raises:
        ModelFailed: No reply came.
    """
    form = answer_form(task)
    answer: Answer | None = None
    for last in (False, True):
        said = await conversation.reply()
        conversation.replies.append(ModelReply(0, said.text))
        answer = read_answer(said.text, points, "".join(form.letters)) or answer
        if last or (answer and not form.lacks_point(answer.choice, answer.point_px)):
            break
        conversation.say(reminder(setting, answered=answer is not None))
    return answer


async def _carried_out(
    said: ChatMessageAssistant,
    conversation: ModelConversation,
    assignment: Assignment,
    points: Points,
    texts: ResultTexts,
) -> bool:
    """Do the calls of a reply, one after another; whether the episode has ended."""
    came: list[CallResult] = []
    results: list[ChatMessageTool] = []
    calls = said.tool_calls or []
    for call in calls:
        words = "" if came else said.text
        asked = meant(call_of(call, words), points)
        came.append(await assignment.call(asked))
        read = texts.told(asked.name, came[-1].text)
        results.append(result_message(call, read, came[-1].picture))
        if came[-1].ended:
            break
    conversation.replies.append(ModelReply(len(came)))
    order = pictureless_first([told.picture for told in came])
    conversation.messages += [results[index] for index in order]
    return came[-1].ended
