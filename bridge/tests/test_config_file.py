"""Files that describe robots: the examples are right, and what is wrong is named."""

from __future__ import annotations

import json
import math
import os
import random
import xml.etree.ElementTree as ElementTree
from pathlib import Path
from typing import Any, Callable, Dict

import pytest

from bridges import EXAMPLES, practice
from probe_bridge.config_file import load_config, read_config
from probe_bridge.errors import BridgeError
from probe_bridge.geometry import from_rpy
from ur5_figures import points


@pytest.mark.parametrize("name", ["simulated", "jaco"])
def test_the_examples_are_valid(name: str):
    assert load_config(EXAMPLES / f"{name}.json").home


def test_cameras_may_be_in_a_file_of_their_own(tmp_path: Path):
    raw, other = practice(), tmp_path / "arm.json"
    cameras = raw["cameras"]
    cameras[0]["position"] = [0.002, 0, 1.0]
    (tmp_path / "cameras.json").write_text(json.dumps(cameras))
    other.write_text(json.dumps({**raw, "cameras": "cameras.json"}))
    assert load_config(other).cameras["table"].position == (0.002, 0, 1.0)
    other.write_text(json.dumps({**raw, "cameras": "nowhere.json"}))
    with pytest.raises(BridgeError, match="nowhere.json can't be read"):
        load_config(other)


def test_the_practice_arm_is_a_ur5():
    config, rng = read_config(practice()), random.Random(3)
    for _ in range(200):
        joints = tuple(rng.uniform(-math.pi, math.pi) for _ in range(6))
        watched = config.chain.watched(joints)
        flange, pads, elbow, wrist = points(joints)
        assert watched[0] == pytest.approx(flange, abs=1e-5)
        assert watched[7] == pytest.approx(pads, abs=1e-5)
        assert watched[2] == pytest.approx(elbow, abs=1e-5)
        assert watched[4] == pytest.approx(wrist, abs=1e-5)


def test_the_jacos_joints_are_those_of_the_vendors_file():
    root = Path(os.environ.get("PROBE_ASSETS", "/nowhere"))
    file = root / "robots/kinova_j2s6s300/kinova_j2s6s300.urdf"
    if not file.exists():
        pytest.skip("PROBE_ASSETS names no folder with the Jaco's URDF")
    joints = ElementTree.parse(file).getroot().findall("joint")
    vendor = {joint.get("name"): joint for joint in joints}
    config = load_config(EXAMPLES / "jaco.json")
    for joint in config.chain.joints:
        origin, limit = vendor[joint.name].find("origin"), vendor[joint.name].find("limit")
        assert origin is not None
        assert limit is not None
        xyz, rpy = (tuple(map(float, origin.get(k, "").split())) for k in ("xyz", "rpy"))
        expected: Any = from_rpy(xyz, rpy)  # type: ignore[arg-type]
        assert joint.origin.position == pytest.approx(expected.position, abs=1e-6)
        assert joint.origin.rotation == pytest.approx(expected.rotation, abs=1e-5)
        assert joint.speed <= float(limit.get("velocity", "0"))
        assert joint.lower >= float(limit.get("lower", "-6.2832")) - 1e-4
        assert joint.upper <= float(limit.get("upper", "6.2832")) + 1e-4


def changed(change: Callable[[Dict[str, Any]], Any]) -> Dict[str, Any]:
    raw = practice()
    change(raw)
    return raw


@pytest.mark.parametrize(
    ("change", "says"),
    [
        (lambda raw: raw.pop("trail"), "config.trail is missing"),
        (lambda raw: raw.update(spead=1), "'spead' is not a field"),
        (lambda raw: raw["joints"][2].update(axis=[0, 0, 2]), "config.joints[2].axis"),
        (lambda raw: raw["joints"][1].update(lower=9), "config.joints[1].lower"),
        (lambda raw: raw["joints"][1].update(speed=0), "config.joints[1].speed"),
        (lambda raw: raw["cameras"][1].update(name="table"), "two of the same name"),
        (lambda raw: raw["cameras"][0].update(wxyz=[1, 1, 0, 0]), "config.cameras[0].wxyz"),
        (lambda raw: raw["points"][0].update(after=7), "config.points[0].after"),
        (lambda raw: raw.update(home=[0] * 5), "config.home is not a list of 6 numbers"),
        (lambda raw: raw.update(home=[0, 0, 2.9, 0, 0, 0]), "outside the limits of elbow_joint"),
        (lambda raw: raw["tool_box"].update(lower=[-0.8, -0.6, 0.7]), "config.home puts the tool"),
        (lambda raw: raw["arm_box"].update(upper=[0.5, 0.9, 0.6]), "config.home puts points["),
    ],
)
def test_a_wrong_field_is_named(change: Callable[[Dict[str, Any]], Any], says: str):
    with pytest.raises(BridgeError) as refused:
        read_config(changed(change))
    assert says in refused.value.text


def test_a_file_that_is_no_json(tmp_path: Path):
    file = tmp_path / "robot.json"
    file.write_text("{")
    with pytest.raises(BridgeError, match=r"robot\.json can't be read"):
        load_config(file)
