# SPDX-License-Identifier: GPL-2.0-or-later
"""Sphinx: one page for each room of the Python package, from its docstrings.

The pages are written into docs/api before the build; git ignores them.
"""

from pathlib import Path

import raceway

FOLDER = Path(__file__).resolve().parent / "api"
ROOMS = {
    "": "Package",
    "theory": "Theory of bearings",
    "runs": "Runs and their records",
    "electric": "Capacitance and circuits",
    "recordings": "Recordings of real bearings",
}


def page(title, modules):
    """Text of a page that documents `modules`."""
    lines = [title, "=" * len(title), ""]
    for module in modules:
        name = f"raceway.{module.rsplit('.', 1)[-1]}"
        lines += [f"``{name}``", "-" * (len(name) + 4), "", f".. automodule:: raceway.{module}"]
        lines += ["   :members:", "   :undoc-members:", "   :member-order: bysource", ""]
    return "\n".join(lines)


def write(app):
    """Writes a page only when its text has changed, so that Sphinx reads it again only then."""
    FOLDER.mkdir(exist_ok=True)
    for room, title in ROOMS.items():
        modules = [
            home
            for name, home in raceway.NAMES.items()
            if home.rpartition(".")[0] == room and name not in raceway.CLASSES
        ]
        path = FOLDER / f"{room or 'package'}.rst"
        text = page(title, modules)
        if not path.exists() or path.read_text() != text:
            path.write_text(text)


def escape_bars(app, what, name, thing, options, lines):
    """Bars in docstrings are absolute values, not substitutions of reStructuredText."""
    lines[:] = [
        line if line.lstrip().startswith((">>>", "...")) else line.replace("|", r"\|")
        for line in lines
    ]


def setup(app):
    app.connect("builder-inited", write)
    app.connect("autodoc-process-docstring", escape_bars)
    return {"parallel_read_safe": True}
