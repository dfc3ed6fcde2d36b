"""Limits of what a world and a file may ask for: beyond them it is a slip or an attack, and is refused at once."""

#: Substeps in a step, collision iterations in a substep, levels of the quadtree, impacts of a ball in a substep.
MOST_SUBSTEPS = 1000
MOST_ITERATIONS = 1000
MOST_LEVELS = 16
MOST_IMPACTS = 1_000_000

#: Why there is a limit to a setting, and what to do beyond it.
REASONS = {
    "substeps": "a step would take too long; for more make the steps shorter",
    "iterations": "a step would take too long; for more make substeps of it",
    "levels": "the cells would be too small to tell apart",
    "max_impacts": "a step that does not end would take too long to be seen",
}

#: Bytes of a scene file, and of what a recording says in words. Half a million balls fit; at worst, reading takes 40
#: times as much memory.
LONGEST_FILE = 2**26
#: Levels of lists and tables in a file, and parts of a name with dots. A compound's part's position is six levels deep.
DEEPEST = 16
#: Names in a table, of which the largest that there is has less than 30.
MOST_NAMES = 100
#: Different names and headings in a TOML file; its reader takes a thousand bytes for each.
MOST_KEYS = 1000
#: Faults of a scene that are told; of the others there is the number.
MOST_FAULTS = 40

#: Bytes of a recording in memory; reading and writing take four times as much.
LARGEST_RECORDING = 8 * 10**9
#: Bytes of the list of what is in a recording's file.
LONGEST_LISTING = 2**17
