"""First looks that are kept, with the words that they were drawn with."""

from __future__ import annotations

from dataclasses import replace
from importlib import import_module

import pytest

from probe.assets.library import Library, open_library
from probe.generation.first_look import FirstLook
from probe.render.renderers import Renderers
from probe.shortcuts.looks import examples_of
from probe.tasks.suite import part
from probe.tasks.suite_file import demo_suite

DEMO = demo_suite()
SUITE = part(DEMO, DEMO.tasks[0])


@pytest.fixture
def drawn(monkeypatch):
    """Ids of what was drawn, in turn; drawing itself takes seconds and is tried elsewhere."""
    found = list[str]()

    def look(task, library, renderer):
        found.append(task.id)
        return FirstLook((), (), {})

    monkeypatch.setattr(import_module("probe.shortcuts.looks"), "look_at", look)
    monkeypatch.setattr(import_module("probe.shortcuts.looks"), "example_of", lambda *both: both)
    return found


def renamed(library: Library) -> Library:
    shown = {placed.object_id for placed in SUITE.tasks[0].scene.objects}
    specs = tuple(
        replace(it, name=f"odd {it.name}") if it.id in shown else it for it in library.specs
    )
    return replace(library, specs=specs)


def test_a_look_is_drawn_once_until_a_name_changes_or_its_file_breaks(drawn, cache, tmp_path):
    library = open_library("procedural", None, cache)
    for _ in range(2):
        list(examples_of([SUITE], library, tmp_path))
    assert len(drawn) == 1
    list(examples_of([SUITE], renamed(library), tmp_path))
    assert len(drawn) == 2, "another name is another look"
    for file in (tmp_path / "looks").rglob("*.json"):
        file.write_text('{"half')
    list(examples_of([SUITE], library, tmp_path))
    assert len(drawn) == 3


def test_a_suite_is_looked_at_as_its_pictures_were_drawn(drawn, cache, tmp_path, monkeypatch):
    asked = list[str]()
    monkeypatch.setattr(Renderers, "__getitem__", lambda _, name: asked.append(name))
    library = open_library("procedural", None, cache)
    (task,) = SUITE.tasks
    scene = replace(task.scene, setup=replace(task.setup, renderer="blender"))
    painted = replace(task, scene=scene)
    for suite in (SUITE, replace(SUITE, tasks=(painted,))):
        list(examples_of([suite], library, tmp_path))
    assert asked == ["filament", "blender"], "and what one has drawn isn't the other's"
