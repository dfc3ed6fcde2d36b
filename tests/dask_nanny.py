"""The command `dask worker`, whose processes are forked from one that has imported what they need.

A worker that was killed is there again in tenths of a second, so that tests can kill many.
"""

import multiprocessing

import dask
from distributed import utils
from distributed.cli.dask_worker import main

if __name__ == "__main__":
    dask.config.set({"distributed.worker.multiprocessing-method": "forkserver"})
    multiprocessing.get_context("forkserver").set_forkserver_preload(["distributed", "tests.sweeping"])
    utils._forkserver_preload_set = True
    main()
