"""Whether a generator's tasks can be answered by less than acting: rules, classifiers, verdicts."""
