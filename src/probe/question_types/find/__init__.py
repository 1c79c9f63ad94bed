"""Find: which of these is on the table, and where?"""
