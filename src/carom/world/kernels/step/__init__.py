"""The discrete step, and what both modes share."""
