"""A renderer of formulas for Sphinx: MathML, which browsers draw themselves, so pages load no script for it."""

from __future__ import annotations

import re
from itertools import count
from typing import TYPE_CHECKING, Any

from docutils.nodes import SkipNode
from docutils.utils.math.latex2mathml import tex2mathml

if TYPE_CHECKING:
    from docutils import nodes
    from sphinx.application import Sphinx


BAR = re.compile(r'<mo (stretchy="false"|maxsize="[^"]*" minsize="[^"]*" symmetric="true")>\|</mo>')


def mathml(formula: str, *, as_block: bool = False) -> str:
    """A formula as MathML; bars, which open and close in turn, stand close to what is between them."""
    turns = {True: count(), False: count()}

    def bar(found: re.Match[str]) -> str:
        turn = next(turns["stretchy" in found[1]])
        form = "postfix" if turn % 2 else "prefix"
        return f'<mo {found[1]} form="{form}" lspace="0" rspace="0">|</mo>'

    return BAR.sub(bar, tex2mathml(formula, as_block=as_block))


def visit_math(self: Any, node: nodes.math) -> None:
    """Write a formula in a line."""
    self.body.append(mathml(node.astext()))
    raise SkipNode


def visit_math_block(self: Any, node: nodes.math_block) -> None:
    """Write a formula on lines of its own."""
    self.body.append(f'<div class="math">{mathml(node.astext(), as_block=True)}</div>')
    raise SkipNode


def setup(app: Sphinx) -> dict[str, bool]:
    """Add the renderer under the name `mathml`."""
    app.add_html_math_renderer("mathml", (visit_math, None), (visit_math_block, None))
    return {"parallel_read_safe": True, "parallel_write_safe": True}
