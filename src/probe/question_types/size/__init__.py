"""Size: which of two marked things is longer, larger or smaller?"""
