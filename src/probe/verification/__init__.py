"""Checks frozen tasks anew, from nothing but what a suite says of them."""
