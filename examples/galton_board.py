"""A board of pegs draws the bell curve.
=====================================

Balls fall through ten rows of pegs. At each one they go left or right, about evenly, so the bin that a ball ends in
counts its rights: a binomial distribution, which is nearly a bell.
"""

from math import comb
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

import carom
from carom import draw

ROWS, BALLS = 10, 400

world = carom.scenes.galton(rows=ROWS, balls=BALLS).build()
world.run(seconds=14)
picture = draw.picture_of(world, "Galton's board", size=760)
Path("galton_board.svg").write_text(draw.svg(picture), encoding="utf-8")

# %%
# The bins are one unit wide, and there is one more of them than rows.

bins = np.clip(np.floor(world.balls.position[:, 0] + (ROWS + 1) / 2), 0, ROWS).astype(int)
counts = np.bincount(bins, minlength=ROWS + 1)
expected = [len(bins) * comb(ROWS, k) / 2**ROWS for k in range(ROWS + 1)]

_, axes = plt.subplots(figsize=(7, 3.6), layout="constrained")
axes.bar(range(ROWS + 1), counts, color="#1f8aa8", label="balls")
axes.plot(range(ROWS + 1), expected, "o-", color="#d9480f", label="binomial")
axes.set(xlabel="bin", ylabel="balls")
axes.legend(frameon=False)
print(
    f"mean bin {bins.mean():.2f} of 0 to {ROWS}, spread {bins.std():.2f}; binomial: {ROWS / 2} and {ROWS**0.5 / 2:.2f}"
)
plt.show()
