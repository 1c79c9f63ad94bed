"""Makes the application, and closes its tables when the server ends."""

from __future__ import annotations

from fastapi import FastAPI
from openenv.core.env_server.http_server import create_fastapi_app

import probe
from probe.interfaces.training.tables import TrainingTables
from probe_openenv.models import TableReply, ToolCall
from probe_openenv.server.environment import Seats
from probe_openenv.server.settings import Settings

_SEATLESS = ("/reset", "/step", "/state")


def application(settings: Settings) -> FastAPI:
    """The application of a server.

    Raises:
        BadData, NotForTraining: As probe.training_tables.
    """
    suite = probe.load_suite(settings.suite)
    return serving(probe.training_tables(suite, tables=settings.tables, out=settings.out))


def serving(tables: TrainingTables) -> FastAPI:
    """An application with a seat for each connection, at these tables."""
    seats = Seats(tables)
    made = create_fastapi_app(seats, ToolCall, TableReply, max_concurrent_envs=tables.most)
    # Without a connection there is no seat: whoever resets by a request would take one for good.
    made.router.routes[:] = [it for it in made.routes if getattr(it, "path", "") not in _SEATLESS]
    made.router.add_event_handler("shutdown", tables.close)
    return made
