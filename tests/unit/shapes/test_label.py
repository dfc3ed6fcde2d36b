"""Every shape and ball has something to call it."""

import carom
from carom.shapes.label import label_of, name_of


def test_a_part_has_the_name_of_its_compound_unless_it_has_its_own() -> None:
    own, unnamed = carom.Point((0, 0), name="tip"), carom.Point((3, 1))
    carom.Compound([own, unnamed], pivot=(0, 0), name="flipper")
    assert (name_of(own), name_of(unnamed)) == ("tip", "flipper")
    assert label_of(carom.Segment((0, 0), (3, 1))) == "segment at (1.5, 0.5)"


def test_a_ball_has_its_name_or_its_number() -> None:
    world = carom.World()
    named, nameless = world.add(carom.Ball((0, 0), 1, name="cue"), carom.Ball((3, 0), 1))
    assert (label_of(named), label_of(nameless)) == ("cue", f"ball {nameless.id}")
