"""What each control and each figure of the panel means, in a sentence for the strip below the table."""

from __future__ import annotations

from collections.abc import Mapping
from types import MappingProxyType

#: Sentences by the names of rows, figures and buttons; those of a choice's buttons by name and value.
SENTENCES: Mapping[str | tuple[str, object], str] = MappingProxyType(
    {
        "load": "How long the work of a frame takes, of the 16.7 ms that it has: green below half of it.",
        "launched": "Balls that were put onto the table since it was last cleared; behind a plus, those that wait.",
        "in play": "Balls that are on the table now.",
        "asleep": "Balls that rest so long that they are no longer moved; what touches them wakes them.",
        "strays": "Balls that got out of the table: they were so fast that a step took them past a wall.",
        "overlaps": "Balls that lie in a shape or in each other after the last iteration, not yet set apart.",
        "size": "The radius of the next ball. A ball is as heavy as its area says.",
        "speed": "The speed of the next ball, in units a second; the room is 32 units wide.",
        "count": "How many balls 'launch n' sends up, one after the other as soon as the lane is free.",
        "launch": "Send one ball up the lane at the right.",
        "launch many": "Send as many balls up the lane as the slider above says.",
        "clear": "Take all balls away and count anew; the shapes stay.",
        "help": "All keys, over the table.",
        "quit": "Close the toy.",
        "box tests once": "Pairs of boxes that one iteration compares: what the broad phase leaves to be looked at.",
        "box tests": "Pairs of boxes compared a second. Boxes that do not overlap hold nothing that touches.",
        "full tests": "Pairs a second whose boxes overlap, so that the exact distance was worked out.",
        "collisions": "Pairs a second that really touched, and were answered.",
        "broad_phase": "How pairs that may touch are found, before anything exact is worked out.",
        ("broad_phase", "brute"): "Brute force: every ball is compared with every shape and every other ball.",
        ("broad_phase", "quadtree"): "Quadtree: the room is halved both ways, again and again, where there is much.",
        ("broad_phase", "grid"): "Grid: the room is cut into equal cells, and only what shares one is compared.",
        "levels": "How many times the quadtree may halve the room: a leaf of level n has 1 / 2^n of its sides. More "
        "levels mean fewer shapes in a leaf and more leaves; the grid and brute force have none.",
        "nodes": "Nodes of the quadtree: all its boxes, large and small.",
        "leaves": "Leaves of the quadtree, or cells of the grid that hold something.",
        "leaf size": "The smallest leaf or cell that holds something, in units.",
        "most": "The most shapes in one leaf or cell: so many a ball there is compared with.",
        "motion": "Motion iterations: into how many parts the motion of a step is cut. After each part overlaps are "
        "looked for, so a ball is missed only where one part takes it right through a wall.",
        "collision": "Collision iterations: how often, at most, a part of the motion sets overlaps right. One may push "
        "a ball into its neighbour, which the next one finds; it ends early when nothing overlaps.",
        "detection": "How collisions are found: after the motion, or before it.",
        ("detection", "discrete"): "Discrete: move the balls, then look for overlaps and set them right. Quick, but "
        "what is fast and small can be through a wall before anybody looks.",
        ("detection", "continuous"): "Continuous: work out when the next impact will be, and go exactly there. Nothing "
        "gets through a wall, at any speed.",
        ("detection", "both"): "Side by side: two tables that are given the same launches, one of each kind.",
        "restitution": "What elasticity acts on when a ball bounces.",
        ("restitution", "normal"): "Normal restitution: elasticity scales the part of the velocity along the normal; "
        "along the surface the ball keeps its speed. That is how balls bounce.",
        ("restitution", "total"): "Total restitution: elasticity scales the whole velocity, so that a bounce of 0.9 "
        "slows a ball to 0.9 of its speed however it grazes the wall. Simple, and a little sticky.",
        "gravity": "How fast falling balls gain speed downwards, in units a second, each second.",
        "friction": "How fast every ball loses speed, in units a second, each second, as on a pool table.",
        "sleep": "Balls slower than this fall asleep after a while; 0 keeps all awake.",
        "tunnelling": "Two tables, one motion iteration, 30 balls at speed 150: see who goes through the walls.",
        "save": "Keep the table as it stands, shapes and balls, as a scene file for 'carom run' and 'carom show'.",
        "pace": "How fast time goes by: slow motion makes shorter steps, so it is smooth and finds more.",
        ("pace", 1): "Real time: a second of the world in a second.",
        ("pace", 4): "A quarter of real time.",
        ("pace", 10): "A tenth of real time.",
        "paused": "Let time stand still, and go on again.",
        "step": "Stop time, and let one step of 1/60 s go by.",
        "rotating": "Turn the blue parts: paddle, cup and crescent.",
        "muted": "No sound, and sound again.",
        "editing": "Change the table while time stands still: drag a shape to move it, turn it by the wheel, click "
        "where there is none to add one, take one away with the right button.",
        "kind": "What a click adds to the table while it is edited.",
        ("kind", "segment"): "A click on a free place of the table that is edited adds a straight wall.",
        ("kind", "arc"): "A click on a free place of the table that is edited adds half a circle, open below.",
        ("kind", "circle"): "A click on a free place of the table that is edited adds a solid disc.",
        ("kind", "point"): "A click on a free place of the table that is edited adds a post without any width.",
        ("kind", "ball"): "A click on a free place of the table that is edited adds a ball of the next size.",
        "hit points": "Where balls bounced in the last 1.5 s; the harder, the larger.",
        "tracks": "The ways of the first balls in the last 1.5 s.",
        "tangents": "The surface's direction at the latest impacts: what the ball keeps of its velocity lies along it.",
        "boxes": "The boxes that the broad phase compares, and its cells, the darker the more is in them.",
        "reticles": "A ring round each of the latest impacts, which turns as fast as the impact was.",
        "velocity": "An arrow for each ball that moves, as long as the ball is fast.",
        "sectors": "The sectors of arcs: a ball outside of one meets the arc's ends at most.",
        "lights": "Shapes that were hit a moment ago glow.",
    }
)
