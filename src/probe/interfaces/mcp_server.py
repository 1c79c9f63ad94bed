"""The five tools over MCP, on standard input and output; the only file that knows fastmcp."""

from __future__ import annotations

import asyncio
import os
import signal

from fastmcp import FastMCP
from fastmcp.prompts import Message
from fastmcp.server.middleware import CallNext, Middleware, MiddlewareContext
from fastmcp.tools import Tool
from fastmcp.tools.base import ToolResult as Told
from fastmcp.utilities.types import Image
from mcp_types import CallToolRequestParams, ContentBlock, TextContent

from probe import __version__
from probe.episodes.turns import Call, Question
from probe.interfaces.session import Session
from probe.interfaces.words import instructions, question_text
from probe.toolshed.result import DID_NOTHING, ToolResult
from probe.toolshed.tools import tool_schemas
from probe.transcripts.pictures import jpeg
from probe.types import USUAL_SCALE, PictureScale

QUESTION, FIRST_PICTURE = "probe://question", "probe://first-picture"


def serve(session: Session, question: Question, scale: PictureScale = USUAL_SCALE) -> None:
    """Serve one client until it leaves; nothing else may write to standard output.

    Args:
        session: Does the calls; it is left, not closed.
        question: What it is about.
        scale: Of its pictures.
    """
    asyncio.run(_serve(_server(session, question, scale), session))


async def _serve(server: FastMCP, session: Session) -> None:
    for number in (signal.SIGINT, signal.SIGTERM):
        asyncio.get_running_loop().add_signal_handler(number, _leave_and_die, session, number)
    try:
        await server.run_stdio_async(show_banner=False, log_level="WARNING")
    finally:
        session.leave()


def _leave_and_die(session: Session, number: int) -> None:
    """Obey a signal as if it weren't handled, once the record is written.

    Ending in order isn't possible: a thread waits for standard input, and can't be stopped.
    """
    session.leave()
    signal.signal(number, signal.SIG_DFL)
    os.kill(os.getpid(), number)


class _Calls(Middleware):
    """Hands every call to the session, unknown names and odd arguments included.

    The toolshed answers those in its own words and counts them, as it does for every agent.
    """

    def __init__(self, session: Session) -> None:
        self._session = session

    async def on_call_tool(
        self,
        context: MiddlewareContext[CallToolRequestParams],
        call_next: CallNext[CallToolRequestParams, Told],
    ) -> Told:
        sent = context.message
        result = await asyncio.wrap_future(self._session.call(Call.of(sent.name, sent.arguments)))
        return _told(result)


def _server(session: Session, question: Question, scale: PictureScale) -> FastMCP:
    server = FastMCP(
        "probe",
        instructions(question),
        version=__version__,
        middleware=[_Calls(session)],
        tools=[
            Tool(name=tool.name, description=tool.description, parameters=tool.parameters)
            for tool in tool_schemas(scale)
        ],
        mask_error_details=True,
    )

    async def first_picture() -> bytes:
        return jpeg(await asyncio.wrap_future(session.first_picture()))

    async def ask() -> list[Message]:
        picture = Image(data=await first_picture(), format="jpeg")
        return [Message(instructions(question)), Message(picture.to_image_content())]

    server.prompt(name="question", description="The question and the first picture.")(ask)
    server.resource(QUESTION, name="question", mime_type="text/plain")(
        lambda: question_text(question)
    )
    server.resource(FIRST_PICTURE, name="first picture", mime_type="image/jpeg")(first_picture)
    return server


def _told(result: ToolResult) -> Told:
    content: list[ContentBlock] = [TextContent(type="text", text=result.text)]
    if result.picture is not None:
        content.append(Image(data=jpeg(result.picture), format="jpeg").to_image_content())
    # To a client, an error is a call that did nothing; a grasp that failed is a result.
    return Told(content, is_error=result.status in DID_NOTHING)
