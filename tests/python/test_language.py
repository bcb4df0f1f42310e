# SPDX-License-Identifier: GPL-2.0-or-later
"""The pages and the output speak the glossary of docs/design.rst, in short sentences."""

import json
import subprocess
from pathlib import Path

import prose
import pytest
from raceway import columns


@pytest.fixture(scope="module")
def documents():
    return prose.doctrees()


@pytest.fixture(scope="module")
def terms(documents):
    return prose.glossary(documents)


@pytest.fixture(scope="module")
def blocks(documents):
    return prose.pages(documents)


def meanings():
    """(table and column, meaning) of every output column, in Python's tables and in the file that
    they may come from."""
    for table, content in vars(columns).items():
        if isinstance(content, dict) and not table.startswith("_"):
            for name, column in content.items():
                if isinstance(column, columns.Column):
                    yield f"{table} {name}", column.meaning
    source = Path(columns.__file__).with_name("columns.json")
    for table, rows in json.loads(source.read_text()).items():
        if table in ("law", "validity"):  # parts, keywords and rules, no columns
            continue
        for row in rows:
            yield f"{source.name} {table} {row['name']}", row["meaning"]


def test_the_glossary_has_its_terms(terms):
    names = [term.name for term in terms]
    assert len(names) >= 25 and len(set(names)) == len(names)
    for name in ("radial displacement", "load distribution factor", "cage speed", "contact"):
        assert name in names
    words = [word for term in terms for word in term.forbidden]
    assert all(term.forbidden for term in terms) and len(set(words)) == len(words)
    assert not set(words) & set(names)


def test_every_page_is_read(blocks):
    read = {block.page for block in blocks}
    pages = prose.DOCS.rglob("*.rst")
    assert read == {path.relative_to(prose.ROOT).as_posix() for path in (*pages, *prose.MARKDOWN)}


def test_pages_use_the_words_of_the_glossary(blocks, terms):
    faults = [
        f"{block.page}:{block.line}: '{word}' for '{term}': {block.text[:90]}"
        for block in blocks
        for word, term in prose.forbidden_words(block.text, terms)
    ]
    assert not faults, "\n".join(faults)


def test_sentences_are_short(blocks):
    faults = [
        f"{block.page}:{block.line}: {len(prose.words(sentence))} words: {sentence}"
        for block in blocks
        for sentence in prose.too_long(block)
    ]
    assert not faults, "\n".join(faults)


def test_columns_use_the_words_of_the_glossary(terms):
    found = list(meanings())
    assert len(found) > 50
    faults = [
        f"{column}: '{word}' for '{term}': {meaning}"
        for column, meaning in found
        for word, term in prose.forbidden_words(meaning, terms)
    ]
    assert not faults, "\n".join(faults)


def test_readme_names_every_folder():
    files = subprocess.run(
        ["git", "ls-files"], cwd=prose.ROOT, capture_output=True, text=True, check=True
    ).stdout.splitlines()
    folders = {name.split("/")[0] for name in files if "/" in name}
    for parent in ("src-package", "inputs", "docs"):
        folders |= {"/".join(name.split("/")[:2]) for name in files if name.startswith(f"{parent}/")
                    and name.count("/") > 1}  # fmt: skip
    layout = (prose.ROOT / "README.md").read_text().split("## Layout")[1]
    assert not {folder for folder in folders - {"src-package"} if f"`{folder}`" not in layout}


# ---- the reader itself -------------------------------------------------------------------------
PAGE = """\
A page
======

.. _here:

The *orbital speed* of :doc:`other` is ``orbital speed`` and :math:`x : y`; see [Ref]_
on 3.5 µm. Second one?

::

   touch nothing here

.. code-block:: python

   touch = 1

.. list-table::

   * - a cell with a penetration
     - {long}

* {long}.

.. comment: touch

.. [Ref] {long}
"""
LONG = " ".join(["word"] * 26)


@pytest.fixture(scope="module")
def page(tmp_path_factory):
    docs = tmp_path_factory.mktemp("docs")
    (docs / "conf.py").write_text("project = 'x'\nextensions = ['sphinx.ext.mathjax']\n")
    (docs / "index.rst").write_text(PAGE.format(long=LONG))
    (docs / "other.rst").write_text(":orphan:\n\nOther\n=====\n")
    documents = dict(prose.doctrees(docs))
    return list(prose.blocks("index", documents["docs0/index.rst"]))


def test_reader_leaves_out_code_and_formulas(page):
    text = " ".join(block.text for block in page)
    assert "orbital speed of other is" in text and "a cell with a penetration" in text
    assert text.count("orbital speed") == 1 and "touch" not in text and "x : y" not in text


def test_reader_finds_long_sentences_outside_tables_only(page):
    found = [sentence for block in page for sentence in prose.too_long(block)]
    assert found == [f"{LONG}."]
    (paragraph,) = [block for block in page if "orbital" in block.text]
    assert [len(prose.words(one)) for one in prose.sentences(paragraph.text)] == [8, 4, 2]


def test_reader_finds_forbidden_words():
    terms = [prose.Term("contact", ("touch", "touching")), prose.Term("overlap", ("indentation",))]
    found = prose.forbidden_words("It touches; Touching indentations, untouched, touch-free", terms)
    assert found == [("touch", "contact"), ("touching", "contact"), ("indentation", "overlap")]


def test_reader_reads_markdown():
    text = (
        f"# A title\n\nSome `touch` and [a link](http://touch)\nover lines.\n\n    touch x\n\n"
        f"```python\ntouch\n```\n\n| a | touch |\n|---|---|\n| {LONG} | b |\n\n- {LONG}\n- item\n"
    )
    found = list(prose.markdown_blocks("page", text))
    assert [block.text for block in found if not block.in_table][:2] == [
        "A title",
        f"Some {prose.LITERAL} and a link over lines.",
    ]
    assert [block.text for block in found if block.in_table][:2] == ["a", "touch"]
    assert sum(len(prose.too_long(block)) for block in found) == 1
