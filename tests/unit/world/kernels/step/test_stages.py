"""How stages of a step follow each other, and are left where room runs out."""

from carom.rows.state import PAIRS
from carom.world.kernels.step.stages import enter_stage, lacks_room
from tests.kernel_calls import ball_rows, state_row


def test_a_stage_begins_at_its_beginning() -> None:
    state = state_row(ball_rows([]), "grid", 6)
    state["cursor"], state["stage_entered"] = 7, 1
    enter_stage(state, PAIRS)
    assert [state[name] for name in ("stage", "cursor", "stage_entered")] == [PAIRS, 0, 0]


def test_where_room_runs_out_it_is_said_for_what_and_where_to_go_on() -> None:
    state = state_row(ball_rows([]), "grid", 6)
    state["hits"], state["relations"] = 5, 3
    # The upper half of the relations is for a copy.
    assert not lacks_room(state, 9, 14, 2, 4)
    assert (state["cursor"], state["wanted_hits"]) == (0, 0)
    for hits, relations in ((8, 14), (9, 13)):
        assert lacks_room(state, hits, relations, 2, 4)
        assert [state[name] for name in ("cursor", "wanted_hits", "wanted_relations")] == [2, 9, 7]
        state["cursor"] = 0
