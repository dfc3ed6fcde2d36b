"""How a step goes from one stage to the next, and leaves one where room runs out."""

from __future__ import annotations

from carom.rows.state import StateRow


def enter_stage(state: StateRow, stage: int) -> None:
    """Go on with a stage from its beginning."""
    state["stage"] = stage
    state["cursor"] = 0
    state["stage_entered"] = 0


def lacks_room(state: StateRow, hits: int, relations: int, cursor: int, most: int) -> bool:
    """True if tables of such lengths lack room for so much more; then the stage is to go on at the cursor with more."""
    if hits - state["hits"] >= most and relations // 2 - state["relations"] >= most:
        return False
    state["cursor"] = cursor
    state["wanted_hits"] = state["hits"] + most
    state["wanted_relations"] = state["relations"] + most
    return True
