"""Draw an episode as a strip, as in docs/README.md: `python examples/strip.py --help`."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import numpy as np
import tyro
from numpy.typing import NDArray
from PIL import Image, ImageDraw, ImageFont

import probe
from probe import Agent, Call, Question, Turn

Picture = NDArray[np.uint8]
TASK = "beneath-8af85510"
SIDE, GAP, TOP, BELOW, CLOSE = 512, 16, 120, 178, 440
WIDTH = 3 * SIDE + 4 * GAP
INK, SOFT, GOOD, BAD, MARK, RIM = "#1f2328", "#5b6470", "#1a7f37", "#b42318", "#ff28c8", "white"


class Watched:
    """The scripted agent, and what it has been shown: a record keeps poses, not pictures."""

    def __init__(self, agent: Agent) -> None:
        self._agent = agent
        self.turns: Sequence[Turn] = ()

    def act(self, question: Question, history: Sequence[Turn]) -> Call | None:
        """What the agent does."""
        self.turns = history
        return self._agent.act(question, history)


def write(pen: ImageDraw.ImageDraw, at: tuple[int, int], words: str, size: int, ink: str) -> int:
    """Write words in lines that fit a panel, or the whole width from its left edge; next y."""
    font, lines = ImageFont.load_default(size), [""]
    room = WIDTH - 2 * GAP if at[1] < TOP else SIDE
    for word in words.split():
        longer = f"{lines[-1]} {word}".strip()
        if pen.textlength(longer, font) <= room:
            lines[-1] = longer
        else:
            lines.append(word)
    for number, line in enumerate(lines):
        pen.text((at[0], at[1] + round(1.3 * size) * number), line, ink, font)
    return at[1] + round(1.3 * size) * len(lines)


def ringed(picture: Picture, box: tuple[int, int, int, int]) -> Picture:
    """The picture with a ring around a box; it isn't in what the agent was given."""
    image = Image.fromarray(picture)
    left, top, right, bottom = box
    u, v, reach = (left + right) / 2, (top + bottom) / 2, max(right - left, bottom - top) / 2
    for radius, ink, width in ((reach + 17, RIM, 8), (reach + 15, MARK, 4)):
        bounds = (u - radius, v - radius, u + radius, v + radius)
        ImageDraw.Draw(image).ellipse(bounds, outline=ink, width=width)
    return np.asarray(image)


def panel(picture: Picture, middle: tuple[int, int] | None) -> Image.Image:
    """The whole picture, or a close-up of a place."""
    image = Image.fromarray(picture)
    if middle:
        left, top = (min(max(at - CLOSE // 2, 0), image.width - CLOSE) for at in middle)
        image = image.crop((left, top, left + CLOSE, top + CLOSE))
    return image.resize((SIDE, SIDE), Image.Resampling.LANCZOS)


def said(call: Call) -> str:
    """A call as one would write it in Python."""
    return f"{call.name}({', '.join(f'{key}={value!r}' for key, value in call.values.items())})"


def main(out: Path = Path("outputs/examples/strip.jpg")) -> None:
    """Let the scripted agent solve one demo task, and draw what it was shown."""
    task, library = probe.load_suite("demo")[TASK], probe.open_library("procedural")
    with probe.Renderer() as renderer:
        # With the random draws that `probe demo` gives it.
        agent = Watched(probe.builtin_agent("scripted", task, library, renderer=renderer))
        record = probe.play(task, agent, library, name="scripted", renderer=renderer)
        outcome = probe.score(task, record, library, renderer=renderer).outcome
    question = record.question
    grasp = next(t for t in agent.turns if t.call.name == "grasp_and_remove")
    find = agent.turns[agent.turns.index(grasp) - 1]
    assert record.answer and question.picture is not None
    assert find.result.picture is not None and grasp.result.picture is not None
    chosen = dict(question.options)[record.answer.choice]
    seen = probe.read_graph(agent.turns[-1].result.text).called(chosen)[0]
    place = grasp.result.point_px

    image = Image.new("RGB", (WIDTH, TOP + SIDE + BELOW), "white")
    pen = ImageDraw.Draw(image)
    y = write(pen, (GAP, 18), question.text, 34, INK)
    options = "     ".join(f"{letter}  {text}" for letter, text in question.options)
    pen.text((GAP, y + 4), options, SOFT, ImageFont.load_default(25))
    told = find.result.text.splitlines()
    panels = (
        (panel(question.picture, None), "The first picture", "What the mug covers can't be seen."),
        (panel(find.result.picture, place), said(find.call), ", ".join(told[:2])),
        (panel(ringed(grasp.result.picture, seen.box), place), said(grasp.call), grasp.result.text),
    )
    for number, (picture, title, words) in enumerate(panels):
        x = GAP + number * (SIDE + GAP)
        image.paste(picture, (x, TOP))
        y = write(pen, (x, TOP + SIDE + 12), title, 22, INK)
        y = write(pen, (x, y), words, 22, SOFT)
    y = write(pen, (x := GAP + 2 * (SIDE + GAP), y + 6), said(record.steps[-1].call), 22, INK)
    write(pen, (x, y), f"{chosen}: {outcome}", 22, GOOD if outcome == "right" else BAD)
    out.parent.mkdir(parents=True, exist_ok=True)
    image.save(out, quality=88)
    print(f"{outcome}; {out} is {image.width} x {image.height}, {out.stat().st_size // 1024} KB")


if __name__ == "__main__":
    tyro.cli(main)
