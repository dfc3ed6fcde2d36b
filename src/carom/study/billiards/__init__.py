"""Billiards as dynamical systems: closed tables, and what is measured in them with ensembles of orbits."""
