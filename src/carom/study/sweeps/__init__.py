"""Sweeps: one scene run many times, on this machine or on a cluster, with a ledger of what is done."""

from carom.study.sweeps.sweep import sweep

__all__ = ["sweep"]
