"""Decoys: three covers look the same; what lies under one of them?"""
