"""PROBE: questions about a cluttered table that an agent answers after moving something.

The names below are the public API; `docs/reference/api.md` lists them. They are imported when they
are first used.
"""

import os as _os
import sys as _sys
from importlib import import_module as _import_module
from platform import machine as _machine
from typing import TYPE_CHECKING

_binding = {
    # With AVX-512, OpenBLAS and NumPy (2.4's names) round otherwise than without it, and piles fall
    # another way. Both look when NumPy is first imported: whoever needs the same, imports us first.
    "OPENBLAS_CORETYPE": "Haswell",
    "NPY_DISABLE_CPU_FEATURES": "X86_V4 AVX512_ICL AVX512_SPR",
}
_here = _machine() in {"x86_64", "AMD64"}
_late = "numpy" in _sys.modules and not _binding.items() <= _os.environ.items()

if _here:
    for _name, _value in _binding.items():
        _os.environ.setdefault(_name, _value)

SUMS_BOUND = not _here or (not _late and _binding.items() <= _os.environ.items())
"""Whether this process's sums come out as on other machines: not if NumPy was there before us, nor
if the environment says otherwise."""

__version__ = "0.1.0"

if TYPE_CHECKING:
    from probe.agents.reading import Graph, Seen, read_graph, read_handle
    from probe.api.agents import builtin_agent
    from probe.api.episodes import OpenEpisode, open_episode, play, replay, score
    from probe.api.models import model_behind
    from probe.api.reports import WrittenReport, rescore, write_report
    from probe.api.runs import read_records, run
    from probe.api.scenes import make_scene, photograph, visibility
    from probe.api.suites import build_suite, load_suite, open_library
    from probe.api.training import training_tables
    from probe.assets.library import Library
    from probe.episodes.noise import Noise
    from probe.episodes.record import EpisodeRecord
    from probe.episodes.turns import Agent, Call, Question, Turn
    from probe.errors import ProbeError
    from probe.interfaces.training.environment import ProbeEnv
    from probe.interfaces.training.tables import TrainingTables
    from probe.interfaces.training.thousandths import ProbeEnvThousandths
    from probe.perception.choice import Perceiver, Perception, enrolled, pointing, segmented
    from probe.perception.dials import Dials
    from probe.perception.things import Thing, Words
    from probe.render.renderer import Renderer
    from probe.scene.scene import Scene
    from probe.scene.setup import Setup
    from probe.scene.setup_file import read_setup
    from probe.scores.summary import Scores
    from probe.tasks.grading import Score
    from probe.tasks.headline import HeadlineErrors
    from probe.tasks.suite import Suite
    from probe.tasks.task import Task
    from probe.toolshed.result import ToolResult
    from probe.types import Camera, Frame, Pose

_HOMES = {
    "agents.reading": ("Graph", "Seen", "read_graph", "read_handle"),
    "api.agents": ("builtin_agent",),
    "api.episodes": ("OpenEpisode", "open_episode", "play", "replay", "score"),
    "api.models": ("model_behind",),
    "api.reports": ("WrittenReport", "rescore", "write_report"),
    "api.runs": ("read_records", "run"),
    "api.scenes": ("make_scene", "photograph", "visibility"),
    "api.suites": ("build_suite", "load_suite", "open_library"),
    "api.training": ("training_tables",),
    "assets.library": ("Library",),
    "episodes.noise": ("Noise",),
    "episodes.record": ("EpisodeRecord",),
    "episodes.turns": ("Agent", "Call", "Question", "Turn"),
    "errors": ("ProbeError",),
    "interfaces.training.environment": ("ProbeEnv",),
    "interfaces.training.tables": ("TrainingTables",),
    "interfaces.training.thousandths": ("ProbeEnvThousandths",),
    "perception.choice": ("Perceiver", "Perception", "enrolled", "pointing", "segmented"),
    "perception.dials": ("Dials",),
    "perception.things": ("Thing", "Words"),
    "render.renderer": ("Renderer",),
    "scene.scene": ("Scene",),
    "scene.setup": ("Setup",),
    "scene.setup_file": ("read_setup",),
    "scores.summary": ("Scores",),
    "tasks.grading": ("Score",),
    "tasks.headline": ("HeadlineErrors",),
    "tasks.suite": ("Suite",),
    "tasks.task": ("Task",),
    "toolshed.result": ("ToolResult",),
    "types": ("Camera", "Frame", "Pose"),
}
_HOME_OF = {name: home for home, names in _HOMES.items() for name in names}

__all__ = [
    "SUMS_BOUND",
    "Agent",
    "Call",
    "Camera",
    "Dials",
    "EpisodeRecord",
    "Frame",
    "Graph",
    "HeadlineErrors",
    "Library",
    "Noise",
    "OpenEpisode",
    "Perceiver",
    "Perception",
    "Pose",
    "ProbeEnv",
    "ProbeEnvThousandths",
    "ProbeError",
    "Question",
    "Renderer",
    "Scene",
    "Setup",
    "Score",
    "Scores",
    "Seen",
    "Suite",
    "Task",
    "Thing",
    "ToolResult",
    "TrainingTables",
    "Turn",
    "Words",
    "WrittenReport",
    "__version__",
    "build_suite",
    "builtin_agent",
    "enrolled",
    "load_suite",
    "make_scene",
    "model_behind",
    "open_episode",
    "open_library",
    "photograph",
    "pointing",
    "play",
    "read_graph",
    "read_handle",
    "read_records",
    "read_setup",
    "replay",
    "rescore",
    "run",
    "score",
    "segmented",
    "training_tables",
    "visibility",
    "write_report",
]


def __getattr__(name: str) -> object:
    """A public name, imported when it is first used."""
    if name not in _HOME_OF:
        raise AttributeError(f"module 'probe' has no attribute {name!r}")
    found: object = getattr(_import_module(f"probe.{_HOME_OF[name]}"), name)
    globals()[name] = found
    return found


def __dir__() -> list[str]:
    return __all__
