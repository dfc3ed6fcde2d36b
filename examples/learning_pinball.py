"""A policy that learns pinball by evolution.
============================================

A net of 8, 12 and 2 numbers looks at the ball and the flippers sixty times a second and says which flippers are up.
Many such nets play at once, each on tables of its own; the best quarter makes the next generation, spread as they were
(the cross-entropy method). With LEARN="25 32 4 40" in the environment, 25 generations of 32 nets play 4 games of up to
40 seconds each; as it stands, this is a short run, which learns little.
"""

import os

import matplotlib.pyplot as plt
import numpy as np

import carom.rl

GENERATIONS, NETS, GAMES, SECONDS = (int(word) for word in os.environ.get("LEARN", "3 8 1 2").split())
WEIGHTS = 9 * 12 + 13 * 2
random = np.random.default_rng(1)


def decided(nets, seen):
    """Which flippers are up, (nets, games, 2), by nets of shape (nets, WEIGHTS) that have seen (nets, games, 8)."""
    first, second = nets[:, : 9 * 12].reshape(-1, 9, 12), nets[:, 9 * 12 :].reshape(-1, 13, 2)
    inner = np.tanh(seen @ first[:, :8] + first[:, 8:])
    return inner @ second[:, :12] + second[:, 12:] > 0.0


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


middle, spread, means = np.zeros(WEIGHTS), np.ones(WEIGHTS), []
for generation in range(GENERATIONS):
    nets = middle + spread * random.normal(size=(NETS, WEIGHTS))
    scores = played(lambda seen, nets=nets: decided(nets, seen), NETS, GAMES, SECONDS, 1000 * generation)
    best = nets[np.argsort(scores)[-NETS // 4 :]]
    middle, spread = best.mean(axis=0), best.std(axis=0) + 0.05
    means.append(scores.mean())

plt.plot(means)
plt.xlabel("generation")
plt.ylabel("points a game")
plt.show()
# Games that none of them has seen; beside them who never moves a flipper, and who moves them by chance.
for name, player in (
    ("learnt", lambda seen: decided(middle[None], seen)),
    ("at rest", lambda seen: np.zeros((*seen.shape[:2], 2))),
    ("by chance", lambda seen: random.integers(0, 2, (*seen.shape[:2], 2))),
):
    print(f"{name}: {played(player, 1, 16 * GAMES, 2 * SECONDS, 10**6)[0]:.1f} points a game")
