"""All that is painted of the pinball table."""
