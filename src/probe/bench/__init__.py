"""Models at the table through Inspect AI; the only folder that knows that harness."""
