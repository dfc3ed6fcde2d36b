"""The player that plays by itself."""
