"""What Rerun's viewer shows of a recording at first."""

from __future__ import annotations

from collections.abc import Sequence
from importlib import import_module
from typing import Any

import numpy as np

from probe.film.recording.plans import PLAN
from probe.film.recording.stream import STEP, TIME
from probe.scene.setup import Setup
from probe.stage.cameras import AWAY, whole_view
from probe.types import Array

_ASIDE = ("untried", "touching", "no_hold", "unchecked", "target")
"""What the first view leaves to the second one, unless one switches it on."""


def layout(setup: Setup) -> Any:
    """A blueprint of Rerun's: the table with the arm, what the tools saw, the texts."""
    views: Any = import_module("rerun.blueprint")
    whole = whole_view(setup, 16, 9)
    forward = whole.world_from_camera.rotation[:, 2]
    middle = np.array(whole.world_from_camera.position) + AWAY * forward
    table = views.Spatial3DView(
        name="Table",
        contents=["+ /world/**", "- /world/seen/**"],
        overrides=_hidden(views, _ASIDE),
        eye_controls=_eye(views, middle, 0.65 * AWAY * forward),
    )
    thought = views.Spatial3DView(
        name="What the tools saw and considered",
        contents=["+ /world/seen/**", f"+ /{PLAN}/**"],
        overrides=_hidden(views, ("path", "unchecked")),
        eye_controls=_eye(views, np.array([0.0, 0.0, 0.05]), 0.38 * AWAY * forward),
    )
    pictures = views.Tabs(
        views.Spatial2DView(name="What the agent saw last", origin="agent/picture"),
        views.Spatial2DView(name="Things that the tools tell apart", origin="tools"),
    )
    grasps = views.TextDocumentView(name="Grasps considered", origin="grasps")
    log = views.TextLogView(
        name="Log",
        origin="log",
        columns=views.TextLogColumns(
            timeline_columns=[TIME, STEP], text_log_columns=["loglevel", "body"]
        ),
    )
    return views.Blueprint(
        views.Vertical(
            views.Horizontal(
                table, thought, views.Vertical(pictures, grasps), column_shares=[3, 3, 2]
            ),
            log,
            row_shares=[3, 1],
        ),
        views.BlueprintPanel(state="collapsed"),
        views.SelectionPanel(state="collapsed"),
        views.TimePanel(state="collapsed", timeline=TIME),
    )


def _hidden(views: Any, names: Sequence[str]) -> Any:
    """Parts of a plan that are there but not shown at first."""
    return {f"/{PLAN}/{name}": views.EntityBehavior(visible=False) for name in names}


def _eye(views: Any, target: Array, way: Array) -> Any:
    """At the beginning of a way to a target, world, metres, each of shape (3,)."""
    return views.EyeControls3D(position=target - way, look_target=target, eye_up=(0.0, 0.0, 1.0))
