"""Renderers by name: started when they are asked for, and once."""

import pytest

from probe.errors import MissingExtra
from probe.render import renderer
from probe.render.renderers import Renderers


def test_one_is_started_once():
    with Renderers() as renderers:
        assert renderers["filament"] is renderers["filament"]
        assert renderers["filament"].name == "filament"


def test_only_who_needs_blender_is_told_that_it_is_missing(monkeypatch):
    def missing():
        raise MissingExtra("Drawing with Blender", "blender")

    monkeypatch.setattr(renderer, "require_blender", missing)
    with Renderers() as renderers:
        renderers.require("own")
        with pytest.raises(MissingExtra):
            renderers.require("blender")
