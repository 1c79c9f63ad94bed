"""One render worker for all tests of a module."""

from one_renderer import renderer

__all__ = ["renderer"]
