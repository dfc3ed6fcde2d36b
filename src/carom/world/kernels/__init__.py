"""All of a world that is compiled: plain functions of floats and rows."""
