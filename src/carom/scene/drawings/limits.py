"""Limits of what a drawing may hold: beyond them it is a slip or an attack, and is refused before it is read."""

#: Elements of a drawing, with those that stand in it more than once by reference counted each time.
MOST_ELEMENTS = 150_000
#: Levels of groups in groups, and of references to what holds references.
DEEPEST = 100
#: Characters that are no digits in the outlines of a drawing, all taken together: a number has one to three with it. A
#: million points have more.
MOST_MARKS = 1_900_000
#: Characters that the entities of an XML file may stand for, all taken together.
MOST_EXPANDED = 2_000_000
#: Characters of an entity: the names of namespaces that Illustrator writes are shorter.
LONGEST_ENTITY = 1000
#: Lengths: a drawing that is larger is a slip, and its squares would not fit.
FARTHEST = 1e100
#: Arcs that curves become, all taken together, as they are estimated beforehand: each takes a kilobyte and a half.
MOST_ARCS = 250_000
