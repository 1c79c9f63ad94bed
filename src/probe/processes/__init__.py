"""Starts worker processes, listens to them, ends them, and says how one died.

What is done when one dies is the callers' business, and so is what is said.
"""
