"""The tests of carom."""
