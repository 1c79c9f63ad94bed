"""Beneath: what is under the cover?"""
