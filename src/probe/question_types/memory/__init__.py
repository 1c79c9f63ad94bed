"""Memory: remove three covers and nothing else; what was under which?"""
