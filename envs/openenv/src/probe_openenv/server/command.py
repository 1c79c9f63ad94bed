"""`probe-openenv`: serve an environment."""

from __future__ import annotations

import argparse
import os
from pathlib import Path

import uvicorn

from probe.errors import BadData
from probe_openenv.server.settings import Settings


def main() -> None:
    """Serve until Ctrl-C. What isn't said comes from the variables of the environment."""
    parser = argparse.ArgumentParser(prog="probe-openenv", description=main.__doc__)
    parser.add_argument("--suite", type=Path, help="tasks for training (PROBE_SUITE)")
    parser.add_argument("--tables", type=int, help="episodes at once (PROBE_TABLES, 8)")
    parser.add_argument("--out", type=Path, help="folder for the records (PROBE_OUT)")
    parser.add_argument("--host", default="127.0.0.1")
    parser.add_argument("--port", type=int, default=8000)
    said = parser.parse_args()
    given = {"PROBE_SUITE": said.suite, "PROBE_TABLES": said.tables, "PROBE_OUT": said.out}
    told = {name: str(it) for name, it in given.items() if it is not None}
    try:  # now, so that an error doesn't come from within the server
        settings = Settings.of_environment({**os.environ, **told})
    except BadData as error:
        parser.error(str(error))
    os.environ.update(settings.variables())
    uvicorn.run("probe_openenv.server.app:app", host=said.host, port=said.port)
