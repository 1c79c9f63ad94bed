"""Exact: remove these and nothing else; which was hidden under them?"""
