"""The server's application, as the environment's variables say: see `settings.py`."""

from __future__ import annotations

from probe_openenv.server.making import application
from probe_openenv.server.settings import Settings

app = application(Settings.of_environment())
