"""Relation: three covers in a ring; what lies under the next one after that of a named thing?"""
