# SPDX-License-Identifier: GPL-2.0-or-later
"""The glossary in docs/design.rst and the layout in README.md match the tree, and no line contains
a phrase that is always wrong (docs/notes/language)."""

import csv
import importlib.util
import re
import subprocess

from host import ROOT

PHRASES = (
    "could not be" + " had",
    "held" + " against",
    "of one's" + " own",
    "un" + "asked",
    "is no " + "number",
    "as it" + " were",
    "goes" + " on",
    "go" + " on from",
)


def glossary():
    """Return the glossary as {term: its keys in outputs}, after checking that it lists each term
    once."""
    text = (ROOT / "docs/design.rst").read_text().split(".. _glossary:")[1]
    block = re.search(r":widths:.*\n\n((?:   .+\n)+)", text)[1]
    lines = re.sub("^   ", "", block, flags=re.M).splitlines(keepends=True)
    _, *rows = csv.reader(lines, skipinitialspace=True)
    terms = {row[0]: re.findall(r"``(\w+)``", row[2]) for row in rows}
    assert len(rows) == len(terms) > 30
    return terms


def test_terms_and_keys_stand_once_in_the_glossary():
    keys = [key for found in glossary().values() for key in found]
    assert len(keys) > 20 and len(set(keys)) == len(keys)


def test_readme_names_every_folder():
    files = subprocess.run(
        ["git", "ls-files"], cwd=ROOT, capture_output=True, text=True, check=True
    ).stdout.splitlines()
    folders = {name.split("/")[0] for name in files if "/" in name}
    for parent in ("src-package", "inputs", "docs"):
        folders |= {"/".join(name.split("/")[:2]) for name in files if name.startswith(f"{parent}/")
                    and name.count("/") > 1}  # fmt: skip
    layout = (ROOT / "README.md").read_text().split("## Layout")[1]
    assert not {folder for folder in folders - {"src-package"} if f"`{folder}`" not in layout}


def headings(page):
    """Return the headings of a page."""
    lines = (ROOT / "docs" / f"{page}.rst").read_text().splitlines()
    return [one for one, line in zip(lines, lines[1:]) if one and set(line) in ({"="}, {"-"})]


def test_references_to_headings_of_pages():
    """If a comment cites `docs/PAGE, Heading`, the page has this heading."""
    names = subprocess.run(
        ["git", "ls-files", "*.h", "*.cpp", "*.py"], cwd=ROOT, capture_output=True, text=True
    ).stdout.split()
    pages = {page.stem for page in (ROOT / "docs").glob("*.rst")}
    found = []
    for name in names:
        text = re.sub(r"\n *(?://|#)? *", " ", (ROOT / name).read_text())
        for page, cited in re.findall(r"docs/(\w+), ([A-Z][a-z]*(?: \w+)*)", text):
            if page in pages:
                found.append((name, page, cited, headings(page)))
    assert len(found) > 10
    wrong = [
        (name, page, cited)
        for name, page, cited, known in found
        if not any(f"{cited} ".startswith(f"{one} ") for one in known)
    ]
    assert not wrong


def test_no_phrase_that_is_always_wrong():
    spec = importlib.util.spec_from_file_location("random_lines", ROOT / "docs/random_lines.py")
    random_lines = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(random_lines)
    wrong = re.compile(rf"\b({'|'.join(PHRASES)})\b")
    found = [f"{place}: {text}" for place, text in random_lines.lines() if wrong.search(text)]
    assert not found, "\n".join(found)
