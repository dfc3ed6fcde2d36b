"""What is seen and heard of the game, and the keys."""
