"""Three windows on the library: the Collision Math Toy, the Pinball Game, the Pool End Game.

They show how to build a game on carom: `window` is the loop, `controls` makes actions of keys and controllers, `sound`
makes sounds, `letters` writes words; each game is a folder of its own. They use the public names of carom alone.
"""
