"""Small drawings for tests."""

from pathlib import Path

import carom

HEAD = (
    '<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" '
    'xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape"'
)


def svg(inside: str, root: str = 'width="100" height="100"') -> str:
    """The text of an SVG drawing, whose lines are drawn and whose areas are not filled unless they say so."""
    return f'{HEAD} {root} fill="none" stroke="black">\n{inside}\n</svg>\n'


def loaded(folder: Path, text: str, ending: str = ".svg", tolerance: float | None = None) -> carom.Scene:
    """The scene of a drawing with this text."""
    path = folder / f"drawing{ending}"
    path.write_text(text, encoding="utf-8")
    return carom.Scene.load(path, tolerance)


def drawn(folder: Path, inside: str, root: str = 'width="100" height="100"') -> carom.Scene:
    """The scene of an SVG drawing that holds some elements."""
    return loaded(folder, svg(inside, root))


def refusal(folder: Path, inside: str, root: str = 'width="100" height="100"') -> str:
    """What is said of an SVG drawing that is refused."""
    try:
        drawn(folder, inside, root)
    except carom.SceneError as error:
        return str(error)
    raise AssertionError("the drawing was taken")
