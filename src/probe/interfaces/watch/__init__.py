"""The page of a person who watches a run: what agents see, call and are told, as it happens."""
