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
#: Curves, with those that stand in a drawing more than once counted each time: each takes two arcs at least.
MOST_CURVES = 125_000
#: Curves that a stretch of a spline counts as which is no cubic Bézier curve: so many times as long it takes to follow.
SLOW = 12
#: About how many curves are looked at first where there are many more, and how many times too many arcs they must say
#: before all are believed to be too many.
SAMPLE = 6_000
SURE = 1.05
#: Faults of a drawing with which its reading ends: some are told, and to find all of a hundred thousand takes seconds.
ENOUGH_FAULTS = 1000
#: Characters of an outline for each that is no digit: a number with more digits than this is none.
LONGEST_NUMBER = 1000
