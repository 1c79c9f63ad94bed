"""Ranked: three covers look the same; which of the three things beneath them is the longest?"""
