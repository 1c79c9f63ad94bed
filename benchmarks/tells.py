"""What the height of a cover tells in Size and Reduce: `python benchmarks/tells.py`; seconds.

From the true poses and the catalogue's sizes, as a depth camera could measure them; no answer is
looked at before a rule has given its own. The built-in objects are enough.
"""

from __future__ import annotations

from collections import Counter
from typing import Annotated, Any

import numpy as np
import tyro
from numpy.typing import NDArray
from scipy.spatial import ConvexHull

import probe

Array = NDArray[Any]

ROUND = 0.97
"""Ratio of a cover's two longer sides from which on it counts as round."""

OVER = 0.3
"""Share of the hidden thing's footprint over which a named thing must lie to tell of it."""

_GRID = 60


class Table:
    """A task's table: where each vertex of each thing is, and what lies over what."""

    def __init__(self, task: probe.Task, things: probe.Library) -> None:
        self._things = things
        self._camera = task.scene.setup.camera()
        self._placed = {placed.instance: placed for placed in task.scene.objects}
        self.points = {number: self._points(number) for number in self._placed}

    def cover_of(self, number: int) -> int:
        """Of the things that reach higher, the one that lies over most of a thing."""
        top = self.top(number)
        higher = [other for other in self.points if other != number and self.top(other) > top]
        return max(higher, key=lambda other: self.over(other, number))

    def over(self, cover: int, number: int) -> float:
        """Share of a thing's footprint, seen from above, within that of another."""
        flat = self.points[number][:, :2]
        steps = np.linspace(flat.min(axis=0), flat.max(axis=0), _GRID)
        grid = np.stack(np.meshgrid(*steps.T), axis=-1).reshape(-1, 2)
        inner = grid[_within(grid, flat)]
        return float(_within(inner, self.points[cover][:, :2]).mean())

    def top(self, number: int) -> float:
        """Height of its highest point, metres."""
        return float(self.points[number][:, 2].max())

    def low(self, number: int) -> float:
        """Height of its lowest point, metres."""
        return float(self.points[number][:, 2].min())

    def middle(self, number: int) -> float:
        """Height half way between its lowest and its highest point, metres."""
        return (self.low(number) + self.top(number)) / 2

    def is_round(self, number: int) -> bool:
        """Whether its outline is a circle from above, when it lies flat."""
        _, middle, longest = self._size(number)
        return middle > ROUND * longest

    def by_outline(self, number: int) -> float:
        """How high a round thing seems to be by its width in the picture, metres."""
        camera = self._camera
        pixels = camera.project(self.points[number])
        rim = pixels[ConvexHull(pixels).vertices]
        width_px = np.linalg.norm(rim[:, None] - rim[None], axis=2).max()
        away = camera.focal_px * self._size(number)[2] / width_px
        return float(camera.world_from_camera.position[2] - away)

    def underside(self, number: int, place: Array) -> float:
        """Height of a flat thing's lower side above a place (x, y) on the table, metres."""
        thickness = self._size(number)[0]
        mesh = np.asarray(self._things.body(self._placed[number].object_id).mesh.vertices, float)
        thin = int(np.argmin(np.ptp(mesh, axis=0)))
        normal = self._placed[number].pose.rotation[:, thin]
        normal = normal * np.sign(normal[2])
        steep = max(float(normal[2]), 0.2)
        middle = self.points[number].mean(axis=0)
        rise = normal[:2] @ (place - middle[:2])
        return float(middle[2] - rise / steep - thickness / 2 / steep)

    def _points(self, number: int) -> Array:
        placed = self._placed[number]
        mesh = self._things.body(placed.object_id).mesh
        return placed.pose.apply(np.asarray(mesh.vertices, float))

    def _size(self, number: int) -> list[float]:
        return sorted(self._things[self._placed[number].object_id].size)


def _within(points: Array, outline: Array) -> Array:
    """Which points (n, 2) lie within the convex hull of others."""
    sides = ConvexHull(outline).equations
    return np.all(points @ sides[:, :2].T + sides[:, 2] <= 1e-9, axis=1)


def size_letters(task: probe.Task, table: Table) -> dict[str, str]:
    """What each rule answers to a Size question: whose cover stands higher is larger."""
    a, b = (table.cover_of(mark.instance) for mark in task.marks)

    def letter(one: float, other: float) -> str:
        return "AB"[int((other > one) != (task.form == "smaller"))]

    told = {
        "Size: whose cover's highest point is higher": letter(table.top(a), table.top(b)),
        "Size: whose cover's middle is higher": letter(table.middle(a), table.middle(b)),
        "Size: whose cover's lowest point is higher": letter(table.low(a), table.low(b)),
    }
    if table.is_round(a) and table.is_round(b):
        heights = table.by_outline(a), table.by_outline(b)
        told["Size: both covers round, whose seems higher by its outline"] = letter(*heights)
    return told


def reduce_letters(task: probe.Task, table: Table, things: probe.Library) -> dict[str, str]:
    """What each rule answers to a Reduce question: what is as high as the gap is there."""
    (target,) = task.targets
    place = table.points[target].mean(axis=0)[:2]
    heights = {spec.name: spec.size[2] for spec in reversed(things.specs)}
    lying = [number for number in task.named if table.over(number, target) > OVER]
    gap = min((table.underside(number, place) for number in lying), default=0.0)
    offered = {it.letter: heights[it.text] for it in task.options if it.text in heights}
    return {
        "Reduce: whose height fits the gap below what lies on top": min(
            offered, key=lambda letter: abs(offered[letter] - gap)
        )
    }


def main(name: Annotated[str, tyro.conf.Positional] = "v1") -> None:
    """Print how often each rule is right.

    Args:
        name: Of a suite, or a file. Tasks that a look answers are left out.
    """
    suite = probe.load_suite(name)
    things = probe.open_library(suite.pool or "procedural")
    right, asked = Counter[str](), Counter[str]()
    for task in suite.tasks:
        at_sight = task.certificate.measures.get("necessary") == 0
        if at_sight or task.question_type not in ("size", "reduce"):
            continue
        table = Table(task, things)
        size = task.question_type == "size"
        told = size_letters(task, table) if size else reduce_letters(task, table, things)
        for rule, letter in told.items():
            asked[rule] += 1
            right[rule] += letter == task.answer
    for rule, n in asked.items():
        print(f"{rule}: {right[rule]} of {n}")


if __name__ == "__main__":
    tyro.cli(main)
