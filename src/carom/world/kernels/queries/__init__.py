"""What a world is asked: rays, neighbours, boxes, overlaps, aim."""
