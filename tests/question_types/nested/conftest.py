"""One render worker and one library for all tests of a module."""

from one_renderer import library, renderer

__all__ = ["library", "renderer"]
