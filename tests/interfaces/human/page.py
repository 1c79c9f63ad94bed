"""A person at the page, in a browser: clicks and types, knows no address but the first."""

from __future__ import annotations

import json
import time
from collections.abc import Mapping
from typing import Any

from browser import Browser
from probe.episodes.turns import Call

PATIENCE = 400.0


class AtPage:
    """Plays in a browser's page.

    Args:
        browser: Open.
        port: Of the server.
    """

    def __init__(self, browser: Browser, port: int) -> None:
        self.browser = browser
        self.home = f"http://127.0.0.1:{port}/"

    def begin(self, name: str) -> None:
        """Give a name at the door, and wait for the table."""
        self.browser.open(self.home)
        self.browser.run(f"document.getElementById('name').value = {json.dumps(name)}")
        self.click("form button")
        self.browser.wait("location.pathname === '/seat' && document.readyState === 'complete'")
        self.wait_for_table()

    def wait(self, condition: str) -> None:
        """As the browser's, but as long as a table may take."""
        limit = time.monotonic() + PATIENCE
        while not self.browser.run(condition):
            assert time.monotonic() < limit, f"never so: {condition}"
            time.sleep(0.1)

    def wait_for_table(self) -> None:
        self.wait(
            "!document.getElementById('game').hidden && !controls.disabled && picture.complete"
        )

    def wait_for_end(self) -> None:
        """Until a question is over, the last one too."""
        through = "/through/.test(document.getElementById('between-words').textContent)"
        self.wait(f"document.getElementById('game').hidden && !next.hidden || {through}")

    def click(self, selector: str) -> None:
        """Press what a selector finds; it has to be in use."""
        chosen = f"document.querySelector({json.dumps(selector)})"
        assert self.browser.run(f"!{chosen}.disabled && {chosen}.offsetParent !== null"), selector
        self.browser.run(f"{chosen}.click()")

    def type(self, id: str, text: str) -> None:
        self.browser.run(f"document.getElementById({json.dumps(id)}).value = {json.dumps(text)}")

    def point(self, u: float, v: float) -> None:
        """Press the mouse on a pixel of the picture."""
        self.browser.run("picture.scrollIntoView({block: 'center'})")
        box = json.loads(self.browser.run("JSON.stringify(picture.getBoundingClientRect())"))
        x = box["left"] + (u + 0.5) / 1024 * box["width"]
        y = box["top"] + (v + 0.5) / 1024 * box["height"]
        for question_type in ("mousePressed", "mouseReleased"):
            self.browser.call(
                "Input.dispatchMouseEvent",
                type=question_type,
                x=x,
                y=y,
                button="left",
                clickCount=1,
            )

    def told(self) -> str:
        """What the last tool told."""
        return self.browser.run("document.getElementById('told').textContent")

    def do(self, call: Call) -> str:
        """A call as a person makes it; what came of it."""
        steps = self.browser.run("steps.children.length")
        self._press(call.name, call.values)
        if call.name == "answer_question":
            self.wait_for_end()
            return ""
        self.wait(f"steps.children.length > {steps} && !controls.disabled && picture.complete")
        return self.told()

    def _press(self, tool: str, said: Mapping[str, Any]) -> None:
        if tool == "perceive_scene":
            self.click("#perceive")
        elif tool == "find_object":
            self.type("description", said["description"])
            self.click("#find-form .row button:not(#perceive)")
        elif tool == "grasp_and_remove":
            self.type("object", said["object_id"])
            self.click("#grasp")
        elif tool == "push":
            self.type("object", said["object_id"])
            self.browser.run(
                f"document.querySelector('[value={said['direction']}]').checked = true"
            )
            self.type("distance", str(said["distance_cm"]))
            self.click("#push")
        else:
            self.answer(said["choice"], said.get("point"))

    def answer(self, choice: str, point: tuple[float, float] | None) -> None:
        if point:
            self.point(*point)
        self.browser.run(f"document.querySelector('[name=option][value={choice}]').click()")
        self.click("#answer")
        self.click("#sure-yes")

    def give_up(self) -> None:
        """End the question without an answer."""
        self.click("#stop")
        self.click("#sure-yes")
        self.wait_for_end()
