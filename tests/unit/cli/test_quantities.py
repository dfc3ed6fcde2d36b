"""Numbers on the command line: plain ones and fractions, everything else refused."""

import pytest

from carom.cli.mistakes import Mistake
from carom.cli.quantities import non_negative, number, positive


@pytest.mark.parametrize(
    ("text", "value"), [("10", 10.0), ("0.25", 0.25), ("1/60", 1 / 60), ("1e-3", 1e-3), (" 3/4 ", 0.75), ("-2", -2.0)]
)
def test_numbers_and_fractions_are_read(text: str, value: float) -> None:
    assert number("--dt", text) == value


@pytest.mark.parametrize("text", ["", "ten", "1/0", "1/60/2", "nan", "inf", "1e999", "1e999/1e999", "0x10", "1,5", "/"])
def test_what_is_no_finite_number_is_refused_by_the_option_s_name(text: str) -> None:
    with pytest.raises(Mistake, match=r"^--dt "):
        number("--dt", text)


@pytest.mark.parametrize("text", ["0", "-1", "-1/60", "1e-999"])
def test_a_length_of_time_that_must_be_positive_is_positive(text: str) -> None:
    with pytest.raises(Mistake, match="must be above 0"):
        positive("--dt", text)


def test_zero_is_not_negative() -> None:
    assert non_negative("--seconds", "0") == 0.0
    with pytest.raises(Mistake, match="must not be below 0"):
        non_negative("--seconds", "-1/60")
