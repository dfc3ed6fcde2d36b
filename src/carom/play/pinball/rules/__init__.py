"""The game: its table, its balls, its rules and its scores."""
