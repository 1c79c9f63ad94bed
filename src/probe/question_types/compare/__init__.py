"""Compare: which of two marked things has a colour?"""
