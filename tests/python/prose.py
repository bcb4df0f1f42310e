# SPDX-License-Identifier: GPL-2.0-or-later
"""The prose of the pages, taken out of their markup, for `test_language.py`.

    .venv/bin/python tests/python/prose.py [PAGE ...]

prints the faults of all pages, or of pages whose path contains one of the words given.
"""

import logging
import re
import sys
import tempfile
from pathlib import Path
from typing import NamedTuple

from docutils import nodes
from sphinx.addnodes import pending_xref
from sphinx.application import Sphinx

ROOT = Path(__file__).resolve().parents[2]
DOCS = ROOT / "docs"
MARKDOWN = (ROOT / "README.md", ROOT / "python/README.md")
LONGEST = 25  # words of a sentence
LITERAL = "<literal>"
UNREAD = (
    nodes.literal_block,
    nodes.doctest_block,
    nodes.math_block,
    nodes.math,
    nodes.comment,
    nodes.image,
    nodes.raw,
    nodes.citation_reference,
    nodes.footnote_reference,
    nodes.label,
)


class Block(NamedTuple):
    """A paragraph, heading, caption, term or table cell. A literal is one placeholder word, a
    formula none."""

    page: str
    line: int
    text: str
    in_table: bool


class Term(NamedTuple):
    """A line of the glossary: the words that may not stand for `name`."""

    name: str
    forbidden: tuple[str, ...]


def doctrees(docs=DOCS):
    """Every page below `docs` as (path relative to the root, docutils document), parsed by
    Sphinx."""
    with tempfile.TemporaryDirectory() as out:
        app = Sphinx(docs, docs, out, out, "dummy", status=None, warning=None, freshenv=True)
        try:
            app.build()
            return [
                (f"{docs.name}/{name}.rst", app.env.get_doctree(name))
                for name in sorted(app.env.found_docs)
            ]
        finally:
            logging.getLogger("sphinx").handlers.clear()


def read(node):
    """The text of a node as a reader meets it."""
    if isinstance(node, nodes.Text):
        return node.astext()
    if isinstance(node, UNREAD):
        return " "
    if isinstance(node, pending_xref) and node["refdomain"] == "citation":
        return " "
    if isinstance(node, nodes.literal):
        return LITERAL
    return "".join(read(child) for child in node.children)


def blocks(page, document):
    """The blocks of one document, without entries of citations and the glossary's last column."""
    table = glossary_table(document)
    last_cells = [row.children[-1] for row in table.findall(nodes.row)] if table else []
    for node in document.findall(nodes.TextElement):
        if isinstance(node, (nodes.Inline, *UNREAD)) or isinstance(node.parent, nodes.TextElement):
            continue
        above, tables, skip = node, False, False
        while above is not None:
            tables |= isinstance(above, nodes.table)
            skip |= isinstance(above, nodes.citation)
            skip |= isinstance(above, nodes.entry) and above in last_cells
            above = above.parent
        text = " ".join(read(node).split())
        if text and not skip:
            line = next((n.line for n in (node, node.parent) if n is not None and n.line), 0)
            yield Block(page, line, text, tables)


def markdown_blocks(page, text):
    """The blocks of a Markdown page: fenced and indented code left out."""
    paragraph, start, fenced, before_blank = [], 0, False, True

    def done():
        joined = " ".join(paragraph)
        joined = re.sub(r"`[^`]+`", LITERAL, joined)
        joined = re.sub(r"!?\[([^\]]*)\]\([^)]*\)", r"\1", joined)
        joined = " ".join(re.sub(r"[*#]+", "", joined).split())
        paragraph.clear()
        return joined

    for number, line in enumerate([*text.splitlines(), ""], 1):
        if line.startswith("```"):
            fenced = not fenced
        code = fenced or line.startswith("```") or (before_blank and line.startswith("    "))
        table = line.startswith("|")
        if code or table or not line.strip() or line.startswith(("#", "- ", "* ", "![")):
            if joined := done():
                yield Block(page, start, joined, False)
        if table:
            for cell in line.strip().strip("|").split("|"):
                paragraph.append(cell)
                if joined := done():
                    yield Block(page, number, joined, True)
        elif not code and line.strip():
            if not paragraph:
                start = number
            paragraph.append(line.lstrip("-* ") if line.startswith(("- ", "* ")) else line)
        before_blank = not line.strip() or (before_blank and code)


def pages(documents):
    """The blocks of every page: those of the documentation, `documents`, and of Markdown."""
    found = [block for page, document in documents for block in blocks(page, document)]
    for path in MARKDOWN:
        name = path.relative_to(ROOT).as_posix()
        found += markdown_blocks(name, path.read_text())
    return found


def sentences(text):
    """`text` split after . : ; ? and ! where white space follows."""
    return [part for part in re.split(r"(?<=[.:;?!])[\"')\]]*\s+", text) if part]


def words(sentence):
    """The words of a sentence: what holds a letter or a digit."""
    return [word for word in sentence.split() if re.search(r"\w", word)]


def cells(table):
    """The texts of a table, row by row."""
    return [[read(entry).strip() for entry in row] for row in table.findall(nodes.row)]


def glossary_table(document):
    """The table of a document whose first heading is "term" and whose last is "not", or None."""
    for table in document.findall(nodes.table):
        heading = cells(table)[0]
        if (heading[0], heading[-1]) == ("term", "not"):
            return table
    return None


def glossary(documents):
    """The terms of the glossary in docs/design.rst."""
    table = glossary_table(dict(documents)["docs/design.rst"])
    return [
        Term(row[0], tuple(word.strip() for word in row[-1].split(",") if word.strip()))
        for row in cells(table)[1:]
    ]


def forbidden_words(text, terms):
    """(word, term) for each forbidden word or its plural in `text`, whatever its case."""
    return [
        (word, term.name)
        for term in terms
        for word in term.forbidden
        if re.search(rf"(?<![\w-]){re.escape(word)}(s|es)?(?![\w-])", text, re.IGNORECASE)
    ]


def too_long(block, longest=LONGEST):
    """The sentences of a block that have more words than `longest`; none in a table."""
    if block.in_table:
        return []
    return [one for one in sentences(block.text) if len(words(one)) > longest]


def main():
    documents = doctrees()
    terms = glossary(documents)
    for block in pages(documents):
        if sys.argv[1:] and not any(word in block.page for word in sys.argv[1:]):
            continue
        for sentence in too_long(block):
            print(f"{block.page}:{block.line}: {len(words(sentence))} words: {sentence}")
        for word, term in forbidden_words(block.text, terms):
            print(f"{block.page}:{block.line}: '{word}' for '{term}': {block.text[:150]}")


if __name__ == "__main__":
    main()
