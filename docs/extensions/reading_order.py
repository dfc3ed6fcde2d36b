"""The order of the gallery."""

#: The examples by their files' names: first what the library is about, then what can be done with it.
EXAMPLES = (
    "arc_room", "galton_board", "newtons_cradle", "classroom", "galperin_pi", "maxwell_gas", "common_tangents",
    "guard_points", "rounded_room", "drawn_table", "two_modes", "stadium_chaos", "boundary_map", "phase_portrait",
    "sinai_billiard", "bowl", "flipper", "pool_line", "lidar", "breakout", "pinball_hits", "learning_pinball",
    "snapshots", "layers",
)  # fmt: skip
