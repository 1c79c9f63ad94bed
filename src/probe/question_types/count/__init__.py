"""Count: how many were on the table at the start?"""
