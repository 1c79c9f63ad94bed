"""Forward kinematics of a URDF, apart from the product's."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
from scipy.spatial.transform import Rotation

from probe.types import Array


@dataclass(frozen=True)
class Joint:
    name: str
    parent: str
    origin: Array
    axis: Array | None  # None where it is fixed

    def transform(self, angle: float) -> Array:
        if self.axis is None:
            return self.origin
        matrix = self.origin.copy()
        matrix[:3, :3] @= Rotation.from_rotvec(self.axis * angle).as_matrix()
        return matrix


@dataclass(frozen=True)
class Urdf:
    by_child: dict[str, Joint]

    @staticmethod
    def read(path: Path) -> Urdf:
        elements = ElementTree.parse(path).getroot().findall("joint")
        return Urdf({_attribute(e, "child", "link"): _joint(e) for e in elements})

    def forward(self, base: str, tip: str, joints: dict[str, float]) -> Array:
        """base_from_tip, shape (4, 4); joints that are not named stay at zero."""
        return np.linalg.inv(self._root_from(base, joints)) @ self._root_from(tip, joints)

    def _root_from(self, link: str, joints: dict[str, float]) -> Array:
        matrix = np.eye(4)
        while link in self.by_child:
            joint = self.by_child[link]
            matrix = joint.transform(joints.get(joint.name, 0.0)) @ matrix
            link = joint.parent
        return matrix


def _attribute(element: ElementTree.Element, tag: str, name: str) -> str:
    child = element.find(tag)
    assert child is not None
    return child.attrib[name]


def _joint(element: ElementTree.Element) -> Joint:
    origin = np.eye(4)
    if element.find("origin") is not None:
        origin[:3, 3] = _numbers(_attribute(element, "origin", "xyz"))
        rpy = _numbers(_attribute(element, "origin", "rpy"))
        origin[:3, :3] = Rotation.from_euler("xyz", rpy).as_matrix()
    turns = element.attrib["type"] in ("revolute", "continuous")
    axis = _numbers(_attribute(element, "axis", "xyz")) if turns else None
    return Joint(element.attrib["name"], _attribute(element, "parent", "link"), origin, axis)


def _numbers(text: str) -> Array:
    return np.array([float(value) for value in text.split()])
