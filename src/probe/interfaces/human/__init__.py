"""The human seat: a local web page with what agents see and what they can do, no more."""
