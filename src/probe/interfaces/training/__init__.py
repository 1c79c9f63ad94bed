"""A place at our tables for trainers that learn from rewards. Imports no trainer."""
