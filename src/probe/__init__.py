"""PROBE: questions about a cluttered table that only moving things can answer."""

__version__ = "0.1.0"
