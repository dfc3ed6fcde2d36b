"""Style sheets: what is filled and what is seen."""

import pytest

from carom.scene.drawings.sheets import Sheet, declarations, is_painted
from carom.scene.drawings.tree import read_tree
from tests.clock import soon


def fill_of(inside: str) -> str | None:
    """The fill of the last element in a drawing."""
    root = read_tree(f"<svg>{inside}</svg>".encode())
    return Sheet(root).properties_of(root.children[-1]).get("fill")


@pytest.mark.parametrize(
    ("inside", "fill"),
    [
        ('<rect fill="red"/>', "red"),
        ('<rect fill="red" style="fill: none ; stroke:blue"/>', "none"),
        ('<style>.a{fill:none;stroke:#000}</style><rect class="b a" fill="red"/>', "none"),
        ("<style>rect{fill:none}</style><rect/>", "none"),
        ("<style>circle{fill:none}</style><rect/>", None),
        ("<style>rect.a, circle{fill:none} </style><rect class='a'/>", "none"),
        ("<style>rect.a{fill:none}</style><rect/>", None),
        ("<style>*{fill:none}</style><rect/>", "none"),
        ("<style>.a{fill:red} #b{fill:none}</style><rect class='a' id='b'/>", "none"),
        ("<style>/* .a{fill:red} */ .a{fill:none}</style><rect class='a'/>", "none"),
        ("<style>@media print{.a{fill:red}} .b{fill:none}</style><rect class='a b'/>", "none"),
        ("<style><![CDATA[.a{fill:none !important}]]></style><rect class='a'/>", "none"),
    ],
)
def test_the_fill_is_that_of_the_rule_that_holds(inside: str, fill: str | None) -> None:
    assert fill_of(inside) == fill


def test_only_what_is_read_is_kept() -> None:
    assert declarations("fill:none;opacity:1;display:none;;x") == {"fill": "none", "display": "none"}


def test_nothing_is_painted_with_none() -> None:
    assert not is_painted("none")
    assert is_painted("url(#gradient)")


@pytest.mark.parametrize("text", ["/*" * 300_000, "{" * 300_000, "a" * 500_000, "}" * 300_000, ".a{" * 100_000])
def test_hostile_sheets_take_no_time(text: str) -> None:
    with soon():
        fill_of(f"<style>{text}</style><rect/>")
