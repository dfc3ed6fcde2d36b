"""The toy's colours: those of the pictures' dark theme."""

from __future__ import annotations

from typing import Any

from carom.play.letters import Colour

PAPER: Colour = (18, 21, 26)
STAGE: Colour = (25, 29, 36)
RAISED: Colour = (34, 40, 49)
RULE: Colour = (53, 60, 71)
TEXT: Colour = (236, 234, 229)
MUTED: Colour = (160, 166, 175)
FAINT: Colour = (112, 119, 130)
ACCENT: Colour = (108, 178, 255)
GOOD: Colour = (95, 214, 160)
BAD: Colour = (255, 122, 168)
WARM: Colour = (255, 207, 107)


def hexed(colour: Colour) -> str:
    """A colour as `#rrggbb`."""
    return "#{:02x}{:02x}{:02x}".format(*colour)


def theme(times: int) -> dict[str, Any]:
    """The look of pygame_gui's buttons and sliders that are drawn `times` as large."""
    font = {"name": "noto_sans", "size": str(12 * times)}
    chosen = hexed((44, 84, 130))
    colours = {
        "normal_bg": hexed(RAISED),
        "hovered_bg": hexed((46, 54, 66)),
        "active_bg": chosen,
        "selected_bg": chosen,
        "disabled_bg": hexed(STAGE),
        "dark_bg": hexed(PAPER),
        "normal_text": hexed(MUTED),
        "hovered_text": hexed(TEXT),
        "active_text": hexed(TEXT),
        "selected_text": hexed(TEXT),
        "disabled_text": hexed(FAINT),
        "normal_border": hexed(RULE),
        "hovered_border": hexed(FAINT),
        "active_border": hexed(ACCENT),
        "selected_border": hexed(ACCENT),
        "disabled_border": hexed(RULE),
    }
    shape = {"shape": "rounded_rectangle", "shape_corner_radius": str(4 * times), "border_width": str(times)}
    shape["shadow_width"] = "0"
    handle = {
        "normal_bg": hexed(ACCENT),
        "hovered_bg": hexed(TEXT),
        "active_bg": hexed(TEXT),
        "selected_bg": hexed(TEXT),
    }
    return {
        "defaults": {"colours": colours, "font": font},
        "button": {"misc": shape, "font": font},
        "#danger": {"colours": {"hovered_bg": hexed((110, 44, 66)), "hovered_border": hexed(BAD)}},
        "horizontal_slider": {
            "colours": {"dark_bg": hexed(PAPER)},
            "misc": shape | {"enable_arrow_buttons": "0", "sliding_button_width": str(12 * times)},
        },
        "horizontal_slider.#sliding_button": {"colours": handle, "misc": shape | {"border_width": "0"}},
    }
