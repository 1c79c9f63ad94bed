"""Budgeted: five covers, three manipulations; what under them is so long?"""
