"""A client that is going to be killed: `python doomed.py idle|busy SERVER...`.

It uses the official SDK, looks, finds a mug, says "ready", and waits; "busy" while it grasps.
"""

from __future__ import annotations

import asyncio
import os
import sys

from mcp import StdioServerParameters
from mcp.client import Client


async def main(state: str, server: list[str]) -> None:
    """Play until killed."""
    start = StdioServerParameters(command=sys.executable, args=server, env=dict(os.environ))
    async with Client(start) as client:
        await client.call_tool("perceive_scene", {})
        await client.call_tool("find_object", {"description": "green mug"})
        grasp = client.call_tool("grasp_and_remove", {"object_id": "object_10"})
        pending = asyncio.create_task(grasp) if state == "busy" else grasp.close()
        await asyncio.sleep(0.3)
        print("ready", flush=True)
        await asyncio.sleep(600)
        del pending


if __name__ == "__main__":
    asyncio.run(main(sys.argv[1], sys.argv[2:]))
