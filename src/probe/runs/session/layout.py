"""How a table should lie, over how it lies now: pictures and a page for whoever lays it."""

from __future__ import annotations

import threading
from collections.abc import Generator
from contextlib import contextmanager
from pathlib import Path

import numpy as np
from PIL import Image

from probe.assets.library import Library
from probe.errors import ProbeError
from probe.files import encode, write_bytes, write_text
from probe.render.photograph import load_scene, photograph
from probe.render.renderer import Renderer
from probe.station.station import Station
from probe.tasks.task import Task
from probe.types import Array, Camera, Frame

FOLDER, PAGE = "layout", "layout.html"
_PAUSE = 1.0
"""Seconds between two looks at the table."""

_EDGE = (0, 255, 255)

_PAGE = """<!doctype html>
<html lang="en"><head><meta charset="utf-8"><meta http-equiv="refresh" content="2">
<title>Lay the table</title>
<style>body { margin: 16px; font: 15px/1.5 system-ui, sans-serif; background: #f4f4f2; }
main { display: grid; gap: 16px; grid-template-columns: repeat(auto-fit, minmax(420px, 1fr)); }
figure { margin: 0; } img { width: 100%; }</style></head>
<body><main>
<figure><img src="edges.jpg" alt=""><figcaption>Now, and the edges of how it should
lie</figcaption></figure>
<figure><img src="overlay.jpg" alt=""><figcaption>Both, half transparent</figcaption></figure>
<figure><img src="wanted.jpg" alt=""><figcaption>How it should lie</figcaption></figure>
</main></body></html>
"""


def wanted_view(task: Task, camera: Camera, things: Library, renderer: Renderer) -> Frame:
    """A task's table at the start as a robot's camera would see it.

    Args:
        task: Whose table.
        camera: The robot's, as it is calibrated.
        things: Has the task's objects.
        renderer: What was loaded in it is replaced.
    """
    load_scene(renderer, task.scene, things)
    return photograph(renderer, task.scene, camera=camera)


def overlaid(wanted: Frame, live: Array) -> tuple[Array, Array]:
    """Both pictures half transparent, and the live one with the edges of wanted things.

    Args:
        wanted: Drawn from the same camera, with labels.
        live: What the camera sees, uint8, shape (h, w, 3).
    """
    assert wanted.rgb is not None and wanted.labels is not None
    both = ((wanted.rgb.astype(np.uint16) + live) // 2).astype(np.uint8)
    edged = live.copy()
    edged[edges_of(wanted.labels)] = _EDGE
    return both, edged


def edges_of(labels: Array) -> Array:
    """Pixels beside which another thing begins, bool, shape (h, w); lines two pixels wide."""
    edge = np.zeros(labels.shape, bool)
    for one, other in (
        ((slice(1, None), slice(None)), (slice(None, -1), slice(None))),
        ((slice(None), slice(1, None)), (slice(None), slice(None, -1))),
    ):
        differs = labels[one] != labels[other]
        edge[one] |= differs
        edge[other] |= differs
    return edge


def write_layout(folder: Path, wanted: Frame, live: Array) -> None:
    """Write the pictures and their page.

    Raises:
        OutputFailed: They can't be written.
    """
    assert wanted.rgb is not None
    both, edged = overlaid(wanted, live)
    for name, picture in (("wanted", wanted.rgb), ("overlay", both), ("edges", edged)):
        write_bytes(folder / f"{name}.jpg", encode(Image.fromarray(picture), "JPEG", quality=90))
    write_text(folder / PAGE, _PAGE)


@contextmanager
def watched(folder: Path, station: Station, wanted: Frame) -> Generator[None]:
    """Keep the pictures fresh while somebody lays the table; nothing else may use the station.

    Raises:
        ProbeError: At the end, if a look failed in between.
    """
    done, failed = threading.Event(), list[ProbeError]()

    def look() -> None:
        try:
            while not done.wait(_PAUSE):
                live = station.observe(rgb=True).rgb
                assert live is not None
                write_layout(folder, wanted, live)
        except ProbeError as error:
            failed.append(error)

    thread = threading.Thread(target=look, name="layout")
    thread.start()
    try:
        yield
    finally:
        done.set()
        thread.join()
    if failed:
        raise failed[0]
