"""The toy's table has all that the toy has."""

from carom import scenes
from tests.unit.scene.shipped.joints import distance_of_guard_points


def test_the_toys_table_has_all_that_the_toy_has() -> None:
    scene = scenes.toy()
    (pocket,) = [shape for shape in scene.shapes if shape.name == "pocket"]
    (bumper,) = [shape for shape in scene.shapes if shape.name == "bumper"]
    assert pocket.elasticity > 1.0
    assert bumper.elasticity > 1.0
    assert bumper.solid
    assert [shape.kind for shape in scene.shapes].count("gate") == 1
    resting = [shape for shape in scene.shapes if shape.kind == "compound"]
    assert len(resting) == 3
    assert all(not shape.rotating and shape.angular_velocity != 0.0 for shape in resting)
    boxes = [shape.aabb for shape in scene.build().shapes]
    assert min(box.left for box in boxes) == 0.0
    assert max(box.right for box in boxes) == 32.0
    assert max(box.top for box in boxes) == 24.0


def test_the_corner_goes_over_into_its_walls() -> None:
    assert distance_of_guard_points(scenes.toy(), "corner") > 1e-3
