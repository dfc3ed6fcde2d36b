"""What pictures show of the past: the ways of balls, and where they were hit."""
