"""Reduce: remove these objects; which was hidden behind them?"""
