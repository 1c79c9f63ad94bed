"""Use the tools from another program, over MCP: `python examples/mcp_client.py --help`."""

from __future__ import annotations

import asyncio
import base64
import os
import sys
from pathlib import Path

import tyro
from mcp import StdioServerParameters
from mcp.client import Client

TASK = "beneath-8af85510"
"""A task of the demo suite: what did the green mug cover?"""


async def play(client: Client, out: Path) -> None:
    """Lift the cover, look what it hid, and answer; a model would choose these calls."""
    # What a model should be told before its first turn: the rules, the question, the options.
    print(client.instructions)
    out.mkdir(parents=True, exist_ok=True)

    async def call(name: str, **arguments: object) -> None:
        result = await client.call_tool(name, arguments)
        given = ", ".join(f"{key}={value!r}" for key, value in arguments.items())
        print(f"\n> {name}({given})")
        for part in result.content:
            if part.type == "text":
                print(part.text)
            elif part.type == "image":
                (out / f"{name}.jpg").write_bytes(base64.b64decode(part.data))

    await call("perceive_scene")
    await call("find_object", description="green mug")
    await call("grasp_and_remove", object_id="object_10")
    await call("answer_question", choice="C")


async def connect(out: Path, suite: Path | None) -> None:
    """Start a server of our own; the SDK ends it when we leave."""
    told = ["-m", "probe", "serve", "--task", TASK, "--out", str(out)]
    told += [] if suite is None else ["--suite", str(suite)]
    # The SDK hands on a few variables alone; ours say where assets and the cache are.
    server = StdioServerParameters(command=sys.executable, args=told, env=dict(os.environ))
    async with Client(server) as client:
        await play(client, out)


def main(out: Path = Path("outputs/examples/mcp_client"), suite: Path | None = None) -> None:
    """Play one episode over MCP.

    Args:
        out: Folder for the record and the pictures; `probe report` draws it.
        suite: Where the task is from; without it, the demo suite.
    """
    asyncio.run(connect(out, suite))
    print(f"\nSee `probe report {out}`")


if __name__ == "__main__":
    tyro.cli(main)
