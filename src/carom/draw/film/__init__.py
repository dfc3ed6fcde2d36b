"""Recordings as moving pixels, and as files."""
