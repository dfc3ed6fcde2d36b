"""What a user holds: shapes, balls, boxes and the contacts between them; each is a view of a row."""
