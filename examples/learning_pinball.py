"""A player that learns pinball by evolution.
============================================

Fifteen numbers say when a flipper is up: where a polynomial of the ball's place and velocity, seen from between the
flippers, is above 0; the right flipper sees the mirror image. Many players try at once, each on tables of its own, and
the best quarter makes the next generation, spread as they were (the cross-entropy method). As it stands this is a short
run, which learns little; LEARN="12 32 8 30" in the environment: 12 generations of 32 players, 8 games of 30 s for each.
"""

import os

import matplotlib.pyplot as plt
import numpy as np

import carom.rl

GENERATIONS, PLAYERS, GAMES, SECONDS = (int(word) for word in os.environ.get("LEARN", "3 8 1 2").split())
ORIGIN, SCALE = np.array([-0.07, -0.62, 0.0, 0.0]), np.array([3.0, 5.0, 2.0, 2.0])
ROW, COLUMN = np.triu_indices(5)
random = np.random.default_rng(1)


def decided(players, seen):
    """Which flippers are up, (players, games, 2), by players of shape (players, 15)."""
    ball = np.concatenate([(seen[:, :, :4] - ORIGIN) * SCALE, np.ones((*seen.shape[:2], 1))], axis=2)
    views = [ball, ball * (-1, 1, -1, 1, 1)]
    return np.concatenate([(v[:, :, ROW] * v[:, :, COLUMN]) @ players[:, :, None] > 0.0 for v in views], axis=2)


def played(decide, players, games, seconds, seed):
    """The mean score of each player, all of them in games that start alike."""
    env = carom.rl.TaskVectorEnv("pinball", players * games)
    seen, _ = env.reset(seed=[seed + game for _ in range(players) for game in range(games)])
    score, playing = np.zeros(env.num_envs), np.ones(env.num_envs, bool)
    for _ in range(60 * seconds):
        actions = decide(seen.reshape(players, games, 8)).reshape(-1, 2).astype(int)
        seen, reward, terminated, truncated, _ = env.step(actions)
        score += reward * playing
        playing &= ~(terminated | truncated)
    return score.reshape(players, games).mean(axis=1)


middle, spread, means = np.zeros(15), np.ones(15), []
for generation in range(GENERATIONS):
    tried = middle + spread * random.normal(size=(PLAYERS, 15))
    scores = played(lambda seen, tried=tried: decided(tried, seen), PLAYERS, GAMES, SECONDS, 1000 * generation)
    best = tried[np.argsort(scores)[-PLAYERS // 4 :]]
    middle, spread = best.mean(axis=0), best.std(axis=0) + 0.05
    means.append(scores.mean())
    print(f"generation {generation}: {means[-1]:.1f} points a game")
plt.axes(xlabel="generation", ylabel="points a game").plot(means)
plt.show()
# Games that none of them has seen; beside them who never moves a flipper, and who moves them by chance.
for name, player in (
    ("learnt", lambda seen: decided(middle[None], seen)),
    ("at rest", lambda seen: np.zeros((*seen.shape[:2], 2))),
    ("by chance", lambda seen: random.integers(0, 2, (*seen.shape[:2], 2))),
):
    print(f"{name}: {played(player, 1, 16 * GAMES, 2 * SECONDS, 10**6)[0]:.1f} points a game")
