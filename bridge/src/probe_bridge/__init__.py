"""A small server on a robot's computer: frames go out, checked motions come in. Knows no tasks."""

from __future__ import annotations

__version__ = "0.1.0"
