"""Names without labels: things are known by their looks, which an operator showed beforehand."""
