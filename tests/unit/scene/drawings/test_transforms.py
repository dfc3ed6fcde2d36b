"""Transforms in words, against their matrices."""

from math import cos, isclose, radians, sin, tan

import pytest
from hypothesis import given
from hypothesis import strategies as st

from carom.scene.drawings.pieces import Matrix
from carom.scene.drawings.transforms import transform
from tests.clock import soon

NUMBERS = st.floats(-9.0, 9.0).map(lambda x: round(x, 3))


def rotation(angle: float) -> Matrix:
    """A turn by degrees."""
    c, s = cos(radians(angle)), sin(radians(angle))
    return Matrix(c, s, -s, c)


ONES = st.one_of(
    st.tuples(NUMBERS, NUMBERS).map(lambda p: (f"translate({p[0]}, {p[1]})", Matrix(e=p[0], f=p[1]))),
    NUMBERS.map(lambda x: (f"translate({x})", Matrix(e=x))),
    NUMBERS.map(lambda x: (f"scale( {x} )", Matrix(x, 0.0, 0.0, x))),
    st.tuples(NUMBERS, NUMBERS).map(lambda p: (f"scale({p[0]} {p[1]})", Matrix(p[0], 0.0, 0.0, p[1]))),
    NUMBERS.map(lambda x: (f"rotate({x})", rotation(x))),
    st.tuples(NUMBERS, NUMBERS, NUMBERS).map(
        lambda p: (
            f"rotate({p[0]},{p[1]},{p[2]})",
            Matrix(e=p[1], f=p[2]).after(rotation(p[0])).after(Matrix(e=-p[1], f=-p[2])),
        )
    ),
    NUMBERS.map(lambda x: (f"skewX({x})", Matrix(1.0, 0.0, tan(radians(x)), 1.0))),
    NUMBERS.map(lambda x: (f"skewY({x})", Matrix(1.0, tan(radians(x)), 0.0, 1.0))),
    st.tuples(*[NUMBERS] * 6).map(lambda p: (f"matrix({','.join(map(str, p))})", Matrix(*p))),
)


@given(st.lists(ONES, min_size=1, max_size=4), st.sampled_from([" ", ",", ""]))
def test_a_list_of_transforms_does_the_last_one_first(ones: list[tuple[str, Matrix]], between: str) -> None:
    made = transform(between.join(text for text, _ in ones))
    right = Matrix()
    for _, matrix in ones:
        right = right.after(matrix)
    for place in ((0.0, 0.0), (1.0, 0.0), (0.0, 1.0)):
        for one, other in zip(made.place(place), right.place(place), strict=True):
            assert isclose(one, other, rel_tol=1e-9, abs_tol=1e-9)


def test_no_transform_leaves_all_as_it_is() -> None:
    assert transform("") == transform(" none ") == Matrix()


@pytest.mark.parametrize("text", ["foo(3)", "rotate(3", "translate(a)", "scale()", "rotate(1) x", "scale(1e999)", "1"])
def test_what_is_no_transform_is_refused(text: str) -> None:
    with pytest.raises(ValueError, match="must be"):
        transform(text)


def test_hostile_transforms_take_no_time() -> None:
    with soon():
        for text in ("scale(" + "1" * 1900 + "x", "scale(1)" * 200 + "x", "rotate(1)" * 100_000):
            with pytest.raises(ValueError):
                transform(text)
