"""Processes that work for us: started, heard, ended, and their deaths told in words.

What is done when one dies is the callers' business, and so is what is said.
"""
