"""PROBE's table as an environment for OpenEnv."""

from probe_openenv.client import ProbeTable
from probe_openenv.models import TableReply, ToolCall

__version__ = "0.1.0"
__all__ = ["ProbeTable", "TableReply", "ToolCall"]
