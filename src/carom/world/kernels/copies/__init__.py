"""Many copies of a world, stepped one after the other on the tables of one."""
