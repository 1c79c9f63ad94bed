"""An episode on a robot: tools over a real bridge, and a record of pictures."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from probe.agents.reading import read_graph
from probe.api.resources import everything
from probe.episodes.files import line_of, record_of
from probe.episodes.film import DEPTH_STEP
from probe.episodes.motion_pictures import motions_of
from probe.episodes.real import open_real_episode
from probe.episodes.record import EpisodeRecord
from probe.episodes.turns import Call
from probe.errors import RobotLost
from probe.perception.choice import segmented
from probe.render.renderer import Renderer
from probe.station.remote import RobotStation, connected
from probe.tasks.suite_file import demo_suite
from probe.twin.flaws import Flaws
from probe.twin.serving import TwinSettings, listening, twin_of
from probe.types import Array

TOKEN = "a token for nobody else"


@pytest.mark.slow
def test_what_an_agent_does_on_a_robot_is_kept_in_pictures(tmp_path: Path) -> None:
    task, things = demo_suite().tasks[0], everything()
    settings = TwinSettings(Flaws(), haste=2.0, views=("top",))
    with (
        Renderer(things.light_cache) as renderer,
        twin_of(task.scene, things, renderer, settings) as robot,
        listening(robot, TOKEN, "127.0.0.1", 0) as address,
    ):
        client = connected(address, TOKEN)
        station = RobotStation(client, task.setup, "top")
        episode = open_real_episode(
            task, "somebody", station, segmented, tmp_path, film=station.film
        )
        graph = episode.step(Call.of("perceive_scene")).result.text
        known = read_graph(graph).objects
        assert len(known) > 5
        handle = known[0].object_id
        took = episode.step(Call.of("grasp_and_remove", {"object_id": handle})).result
        assert took.status in ("done", "failed")
        client.close()
        gone = episode.step(Call.of("perceive_scene"))
    assert gone.result.ended and episode.record.end == "fault"
    record = episode.record
    assert record.fault is not None and record.fault.startswith(RobotLost.__name__)
    assert record.perception.kind == "segmenter" and record_of(line_of(record)) == record
    assert all(scene.objects == () for scene in record.scenes)
    assert len(record.frames) == len(record.steps) + 1 == 3
    for name in record.frames:
        with Image.open(tmp_path / f"{name}.depth.png") as image:
            depth = np.asarray(image) * DEPTH_STEP
        # The table's middle, by a camera that stands 2 mm and half a degree off.
        assert np.median(depth[depth > 0]) == pytest.approx(1.18, abs=0.05)
        with Image.open(tmp_path / f"{name}.jpg") as image:
            assert image.size == (1024, 1024)
    _check_motions(record, tmp_path, np.array(task.setup.mount.parked))


def _check_motions(record: EpisodeRecord, folder: Path, parked: Array) -> None:
    """The grasp was photographed, and what moves in its pictures is the arm."""
    seen = motions_of(record, folder)
    assert len(seen) >= 3 and {each.step for each in seen} == {1}
    stamps = [each.stamp for each in seen]
    assert stamps == sorted(stamps)
    away = [float(np.abs(np.subtract(each.joints, parked)).max()) for each in seen]
    assert max(away) > 0.5
    start = np.asarray(Image.open(folder / f"{record.frames[1]}.jpg").resize((512, 512)), float)
    changed = [
        float((np.abs(np.asarray(Image.open(each.path), float) - start) > 60).mean())
        for each in seen
    ]
    assert max(changed) > 0.01
