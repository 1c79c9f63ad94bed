"""Blender's Python API, as far as it is used; it makes its types at run time."""

from typing import Any, TypeAlias

context: Any
data: Any
ops: Any

class types:  # noqa: N801
    Material: TypeAlias = Any
    Mesh: TypeAlias = Any
    Object: TypeAlias = Any
    World: TypeAlias = Any
