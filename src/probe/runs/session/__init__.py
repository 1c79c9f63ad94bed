"""A session on a robot: agents compared on tables that a person lays; its log, and its check."""
