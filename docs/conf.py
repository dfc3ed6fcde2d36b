"""Settings of the documentation site: `sphinx-build -W --keep-going docs docs/_build/html`.

Nothing is taken from a network, neither while the site is built nor while it is read: formulas are MathML, figures are
drawn by the library while the site is built, examples are run.
"""

import sys
import warnings
from pathlib import Path

DOCS = Path(__file__).resolve().parent
sys.path[:0] = [str(DOCS.parent), str(DOCS.parent / "src"), str(DOCS / "extensions")]

import carom  # noqa: E402 - after the path to it

project = "carom"
author = copyright = "the carom authors"
version = release = carom.__version__

extensions = [
    "sphinx.ext.autodoc",
    "sphinx.ext.napoleon",
    "myst_nb",
    "sphinx_gallery.gen_gallery",
    "mathml",  # the five of docs/extensions
    "drawings",
    "pages",
    "runs",
    "themes",
]
exclude_patterns = ["_build", "pictures/README.md", "gallery/*.ipynb", "gallery/*.py"]
default_role = "code"
html_math_renderer = "mathml"

# -- Markdown and notebooks ----------------------------------------------------------------------------------------
myst_enable_extensions = ["dollarmath", "attrs_inline", "colon_fence"]
myst_heading_anchors = 3
nb_execution_mode = "force"
nb_execution_timeout = 120
nb_execution_raise_on_error = True
nb_ipywidgets_js: dict[str, dict[str, str]] = {}

# -- the API -------------------------------------------------------------------------------------------------------
napoleon_attr_annotations = napoleon_numpy_docstring = False
autodoc_member_order = "bysource"
autodoc_typehints = "signature"
autodoc_typehints_format = "short"
autodoc_default_options = {
    "members": True,
    "show-inheritance": True,
    "inherited-members": "BaseModel, Exception, IntEnum, StrEnum, ValueError, int, ndarray, tuple",
}
python_use_unqualified_type_names = True
python_maximum_signature_line_length = 100
add_module_names = False

# -- the gallery ---------------------------------------------------------------------------------------------------
sphinx_gallery_conf = {
    "examples_dirs": str(DOCS.parent / "examples"),
    "gallery_dirs": "gallery",
    "filename_pattern": r"\.py$",
    "ignore_pattern": r"__init__\.py$",
    "image_scrapers": ("themes.plot_scraper", "pages.svg_scraper"),
    "within_subsection_order": "pages.ReadingOrder",
    "capture_repr": (),
    "download_all_examples": False,
    "show_signature": False,
    "show_memory": False,
    "min_reported_time": 10_000,
    "write_computation_times": False,
    "remove_config_comments": True,
    "plot_gallery": "True",
    "abort_on_example_error": True,
    "thumbnail_size": (480, 330),
}
warnings.filterwarnings("ignore", category=UserWarning, message="FigureCanvasAgg is non-interactive")

# -- looks ---------------------------------------------------------------------------------------------------------
html_theme = "furo"
html_title = "carom"
html_static_path = ["static"]
html_css_files = ["carom.css"]
html_show_sourcelink = False
html_copy_source = False
html_show_sphinx = False
html_theme_options = {
    "light_css_variables": {"color-brand-primary": "#1f68d1", "color-brand-content": "#1f68d1"},
    "dark_css_variables": {"color-brand-primary": "#6cb2ff", "color-brand-content": "#6cb2ff"},
}
