"""A user's program full of mistakes: type checkers must find one on every line that says so, and nowhere else."""

import numpy as np

import carom

ball = carom.Ball((0, 0), 1)
wall = carom.Segment((0, 0), (1, 0))
world = carom.World()

# -- words -------------------------------------------------------------------------------------------------------------

carom.World(detection="continous")  # wrong
carom.World(broad_phase="tree")  # wrong
carom.World(restitution="Total")  # wrong
world.detection = "continous"  # wrong
world.broad_phase = "octree"  # wrong
world.restitution = "all"  # wrong
wall.motion = "dynamic"  # wrong
carom.Segment((0, 0), (1, 0), motion="moving")  # wrong

# -- names -------------------------------------------------------------------------------------------------------------

carom.World(gravty=(0, -1))  # wrong
carom.Segment((0, 0), (1, 0), friction=0.3)  # wrong
carom.Ball((0, 0), radios=1)  # wrong
world.gravty = 3  # wrong
ball.velocty = (1, 2)  # wrong
wall.elastisity = 1.0  # wrong
carom.Compound([], (0, 0)).pivt = (0, 0)  # wrong
world.add_balls([(0, 0)], radii=1)  # wrong
world.ray_cast((0, 0), (1, 1), mask=1)  # wrong
carom.guard_points([wall], tol=1)  # wrong
print(carom.draw.pictures)  # wrong
print(carom.study.plots.energies)  # wrong
print(carom.Sphere)  # wrong

# -- values ------------------------------------------------------------------------------------------------------------

ball.position = 3  # wrong
ball.position = (1, 2, 3)  # wrong
ball.position = "ab"  # wrong
ball.position = ("1", "2")  # wrong
ball.radius = "1"  # wrong
ball.kind = "ball"  # wrong
ball.asleep = True  # wrong
carom.Ball((1, 2, 3), 1)  # wrong
carom.Segment((0, 0), 1)  # wrong
carom.Circle((0, 0), "1")  # wrong
world.gravity = -9.8  # wrong
world.substeps = 0.5  # wrong
world.bounds = 10  # wrong
wall.turn_limits = 1.0  # wrong
world.add(3)  # wrong
world.time = 0.0  # wrong

# -- what comes back ---------------------------------------------------------------------------------------------------

hits = world.step(1 / 60)
hits[0].spede  # wrong
hits["speed"].ball  # wrong
hits[:3].speed  # wrong
name: str = hits[0].time  # wrong
world.ray_cast((0, 0), (1, 1)).point  # wrong
world.ray_cast((0, 0), np.zeros((3, 2))).point  # wrong
world.contacts()[0].shap  # wrong
world.step()  # wrong
