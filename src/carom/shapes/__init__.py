"""What a user holds: shapes, balls, boxes and the contacts between them; each is a view of a row."""

from carom.rows.shape import ARC, CIRCLE, GATE, POINT, SEGMENT
from carom.shapes.arc import Arc
from carom.shapes.circle import Circle
from carom.shapes.gate import Gate
from carom.shapes.point import Point
from carom.shapes.segment import Segment
from carom.shapes.shape import Shape

#: The class of the object for a row of each kind.
SHAPE_CLASSES: dict[int, type[Shape]] = {POINT: Point, SEGMENT: Segment, GATE: Gate, CIRCLE: Circle, ARC: Arc}
