"""Painters: of SVG files and of pixels."""
