# SPDX-License-Identifier: GPL-2.0-or-later
"""Sphinx configuration. `make docs` writes build/docs, and treats warnings as errors."""

import sys
from pathlib import Path

import raceway

sys.path.insert(0, str(Path(__file__).resolve().parent))

project = "Raceway"
author = "the Raceway authors"
copyright = "the Raceway authors, GPL-2.0-or-later"
version = release = raceway.__version__
extensions = [
    "sphinx.ext.autodoc",
    "sphinx.ext.mathjax",
    "api_pages",
    "column_table",
    "room_table",
    "statement_table",
]
highlight_language = "none"
exclude_patterns = ["decks", "packaging"]
html_theme = "alabaster"
html_theme_options = {
    "description": "Ball bearings under EHD lubrication, in LIGGGHTS",
    "page_width": "1080px",
    "sidebar_width": "250px",
    "fixed_sidebar": True,
}
html_show_sourcelink = False
# names in docstrings are in single backticks
default_role = "code"
autodoc_typehints = "signature"
autodoc_default_options = {"exclude-members": "__init__"}
