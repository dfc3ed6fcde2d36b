"""Which balls and shapes are near each other."""
