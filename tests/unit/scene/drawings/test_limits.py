"""Limits of drawings leave room for what they must let through, and none for what they must not."""

from carom.scene.drawings import limits


def test_a_hundred_thousand_elements_pass_and_a_million_nodes_do_not() -> None:
    assert 100_000 < limits.MOST_ELEMENTS < 1_000_000
    # A node is two numbers, each of which has at least one character beside its digits.
    assert limits.MOST_MARKS < 2 * 1_000_000
    # A short path has about ten.
    assert limits.MOST_MARKS > 10 * 100_000
