"""The five tools as an agent sees them. Knows no questions, no answers, no truth."""
