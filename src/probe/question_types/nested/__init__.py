"""Nested: what lies under the thing that a cover hides?"""
