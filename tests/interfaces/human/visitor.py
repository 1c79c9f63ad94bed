"""A page's part of the conversation, spoken by hand; keeps all that it is sent."""

from __future__ import annotations

import http.client
import json
import time
from dataclasses import dataclass, field
from typing import Any
from urllib.parse import urlencode

PATIENCE = 60.0


@dataclass(frozen=True)
class Reply:
    status: int
    headers: dict[str, str]
    body: bytes

    @property
    def json(self) -> Any:
        return json.loads(self.body)


@dataclass
class Visitor:
    port: int
    name: str = "Ada"
    practice: bool = False
    heard: list[Reply] = field(default_factory=list[Reply])

    def send(self, method: str, path: str, body: bytes | None = None, **headers: str) -> Reply:
        """A request as it is said; `_` in a header's name stands for `-`."""
        wire = http.client.HTTPConnection("127.0.0.1", self.port, timeout=PATIENCE)
        wire.request(method, path, body, {k.replace("_", "-"): v for k, v in headers.items()})
        response = wire.getresponse()
        told = {k.lower(): v for k, v in response.getheaders()}
        reply = Reply(response.status, told, response.read())
        wire.close()
        self.heard.append(reply)
        return reply

    def get(self, path: str, **query: str) -> Reply:
        return self.send("GET", f"{path}?{urlencode(query)}" if query else path)

    def post(self, path: str, **said: object) -> Reply:
        body = json.dumps({"name": self.name, "practice": self.practice, **said}).encode()
        return self.send("POST", f"/seat/{path}", body, content_type="application/json")

    def state(self) -> dict[str, Any]:
        """The state once nothing is going on."""
        limit = time.monotonic() + PATIENCE
        while (state := self.look("state").json).get("doing"):
            assert time.monotonic() < limit
            time.sleep(0.01)
        return state

    def enter(self) -> dict[str, Any]:
        assert self.post("enter").status == 200
        return self.state()

    def call(self, tool: str, **arguments: object) -> dict[str, Any]:
        turn = len(self.state()["entries"])
        reply = self.post("call", turn=turn, tool=tool, arguments=arguments)
        assert reply.status == 200, reply.body
        return self.state()

    def look(self, path: str, **query: str) -> Reply:
        who = {"name": self.name} | ({"practice": "1"} if self.practice else {})
        return self.get(f"/seat/{path}", **who, **query)

    def picture(self, number: int) -> Reply:
        return self.look("picture", number=str(number))

    def evidence(self, number: int) -> Reply:
        return self.look("evidence", number=str(number))
