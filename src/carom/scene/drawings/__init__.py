"""Scenes out of drawings: SVG and DXF files."""
