# SPDX-License-Identifier: GPL-2.0-or-later
"""HTML page that is assembled from parts and written as one file."""

import json
import math
from collections.abc import Iterable, Mapping, Sequence
from html import escape
from importlib.resources import files as resources
from pathlib import Path
from typing import Any

from raceway import files
from raceway.files import FilePath

POLICY = "default-src 'none'; style-src 'unsafe-inline'; script-src 'unsafe-inline'; img-src data:"


class Page:
    """A page with a title. Parts are added in order, and `write` writes the file."""

    def __init__(self, title: str) -> None:
        self.title = title
        self._parts: list[str] = []
        self._charts = 0

    def heading(self, text: str) -> None:
        """Add a heading."""
        self._parts.append(f"<h2>{escape(text)}</h2>")

    def text(self, text: str, kind: str = "note") -> None:
        """Add a paragraph; `kind` is a class of the style sheet: note or warning."""
        self._parts.append(f'<p class="{kind}">{escape(text)}</p>')

    def code(self, text: str) -> None:
        """Add preformatted text."""
        self._parts.append(f"<pre>{escape(text)}</pre>")

    def table(
        self, rows: Iterable[Sequence[str]], kinds: Sequence[str], head: Sequence[str] = ()
    ) -> None:
        """Add a table; `kinds` are the classes of the columns. A row with one cell is a heading."""
        lines = ['<div class="wide"><table>']
        if head:
            cells = (f'<th class="{kind}">{escape(one)}</th>' for kind, one in zip(kinds, head))
            lines.append("<tr>" + "".join(cells) + "</tr>")
        for row in rows:
            if len(row) == 1:
                lines.append(f'<tr><th colspan="{len(kinds)}">{escape(row[0])}</th></tr>')
                continue
            cells = (f'<td class="{kind}">{escape(cell)}</td>' for kind, cell in zip(kinds, row))
            lines.append("<tr>" + "".join(cells) + "</tr>")
        self._parts.append("\n".join([*lines, "</table></div>"]))

    def chart(self, title: str, chart: Mapping[str, Any]) -> None:
        """Add a chart for `charts.js`; values that are not finite numbers become gaps."""
        self._charts += 1
        name = f"chart{self._charts}"
        # Escape "<" so that no text can close the script element.
        data = json.dumps(_plain(chart), ensure_ascii=False, allow_nan=False).replace(
            "<", "\\u003c"
        )
        self._parts.append(
            f"<h3>{escape(title)}</h3>"
            f'<script type="application/json" id="{name}">{data}</script>'
            f'<div data-chart="{name}"></div>'
        )

    def picture(self, png: bytes, meaning: str) -> None:
        """Add a PNG, which is embedded in the page."""
        from base64 import b64encode

        source = "data:image/png;base64," + b64encode(png).decode()
        self._parts.append(f'<img src="{source}" alt="{escape(meaning)}">')

    def write(self, path: FilePath) -> Path:
        """Write the page to `path`; raise `RunError` if this fails."""
        own = resources("raceway") / "report"
        text = "\n".join(
            [
                "<!doctype html>",
                '<html lang="en"><head><meta charset="utf-8">',
                f'<meta http-equiv="Content-Security-Policy" content="{POLICY}">',
                f"<title>{escape(self.title)}</title>",
                f"<style>\n{(own / 'page.css').read_text()}</style></head><body>",
                f"<h1>{escape(self.title)}</h1>",
                *self._parts,
                f"<script>\n{(own / 'charts.js').read_text()}</script>",
                "</body></html>",
                "",
            ]
        )
        return files.text(path, text)


def _plain(value):
    if isinstance(value, Mapping):
        return {key: _plain(one) for key, one in value.items()}
    if isinstance(value, str | bool) or value is None:
        return value
    if isinstance(value, Iterable):
        return [_plain(one) for one in value]
    return float(f"{value:.6g}") if math.isfinite(value) else None
