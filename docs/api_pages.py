# SPDX-License-Identifier: GPL-2.0-or-later
"""Sphinx extension that writes a page for each subpackage of the Python package from its
docstrings.

The pages are written to docs/api before the build and are ignored by git.
"""

import inspect
import re
from importlib import import_module
from pathlib import Path

import raceway
from numpy.typing import ArrayLike
from raceway.arrays import Floats, Numbers
from sphinx.util.typing import stringify_annotation

FOLDER = Path(__file__).resolve().parent / "api"
ROOMS = {
    "": "Package",
    "theory": "Theory of bearings",
    "runs": "Runs and their records",
    "electric": "Capacitance and circuits",
    "recordings": "Recordings of real bearings",
}
# aliases that Sphinx would otherwise write out in full; the longest alias comes first
TYPES = {
    stringify_annotation(alias, mode): name
    for mode in ("smart", "fully-qualified")
    for name, alias in (("ArrayLike", ArrayLike), ("Numbers", Numbers), ("Floats", Floats))
}


def page(title, modules):
    """Return the text of a page that documents `modules`."""
    lines = [title, "=" * len(title), ""]
    for module in modules:
        name = f"raceway.{module.rsplit('.', 1)[-1]}"
        lines += [f"``{name}``", "-" * (len(name) + 4), "", f".. automodule:: raceway.{module}"]
        lines += ["   :members:", "   :undoc-members:", "   :member-order: bysource", ""]
    return "\n".join(lines)


def write(app):
    """Write only those pages whose text has changed, because Sphinx reads every rewritten page
    again."""
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


def field_comment(full_name):
    """Return the comment at the end of the line that declares a field of a class, or "" if none."""
    module, owner, field = full_name.rsplit(".", 2)
    try:
        source = inspect.getsource(getattr(import_module(module), owner))
    except (AttributeError, TypeError, OSError):
        return ""
    found = re.search(rf"^    {field}: [^#\n]*#\s*(.+)$", source, re.MULTILINE)
    return found.group(1) if found else ""


def docstring(app, what, name, thing, options, lines):
    """Use the comments of fields as their documentation, and treat bars as absolute values instead
    of substitutions."""
    if what == "attribute":
        lines[:] = [field_comment(name)]
    lines[:] = [
        line if line.lstrip().startswith((">>>", "...")) else line.replace("|", r"\|")
        for line in lines
    ]


def signature(app, what, name, thing, options, arguments, result):
    """Write the types in a signature with the aliases that the package defines."""
    return short(arguments), short(result)


def short(text):
    for long, name in sorted(TYPES.items(), key=lambda one: -len(one[0])):
        text = text and text.replace(long, name)
    return text


def setup(app):
    app.connect("builder-inited", write)
    app.connect("autodoc-process-docstring", docstring)
    app.connect("autodoc-process-signature", signature)
    return {"parallel_read_safe": True}
