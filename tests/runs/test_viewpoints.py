"""Light and renderer of an episode: those of its task, or what its conditions say."""

from dataclasses import replace

from probe.episodes.conditions import AS_FROZEN, Conditions
from probe.runs.viewpoints import viewpoint_of
from probe.scene.lighting import AMBIENT, lighting_of
from probe.scene.setup import ROOM_TABLE
from probe.tasks.suite_file import demo_suite

OLD = demo_suite().tasks[0]
NEW = replace(OLD, scene=replace(OLD.scene, setup=replace(ROOM_TABLE, renderer="blender")))


def test_a_task_is_seen_as_it_was_frozen():
    assert viewpoint_of(OLD, AS_FROZEN, None) == OLD.viewpoint
    assert (OLD.viewpoint.lighting, OLD.viewpoint.renderer) == (AMBIENT, "filament")
    assert viewpoint_of(NEW, AS_FROZEN, None) == NEW.viewpoint
    light = lighting_of("day_room", NEW.scene.table)
    assert (NEW.viewpoint.lighting, NEW.viewpoint.renderer) == (light, "blender")


def test_conditions_choose_another_renderer():
    assert viewpoint_of(OLD, Conditions(renderer="blender"), None).renderer == "blender"
    assert viewpoint_of(NEW, Conditions(renderer="filament"), None).renderer == "filament"


def test_the_rooms_of_new_scenes_are_no_other_light():
    drawn = {
        viewpoint_of(replace(OLD, seed=n), Conditions(lighting="hdri"), None).lighting.name
        for n in range(200)
    }
    assert len(drawn) == 15
    assert not any(name.startswith("day_room") for name in drawn)
