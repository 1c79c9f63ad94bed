"""Skills of an arm with a gripper, written once over Station. No engine, no names, no truth."""

from probe.manipulation.grasp import grasp_and_remove
from probe.manipulation.push import push

__all__ = ["grasp_and_remove", "push"]
