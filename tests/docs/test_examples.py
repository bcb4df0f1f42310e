# SPDX-License-Identifier: GPL-2.0-or-later
"""Run the examples in the documentation: the decks in docs/decks, every block under the heading
"Examples", and every Python or console block, in the order in which they appear on their page.

A block under "Examples" is tried in docs/decks/in.ehd, where it replaces the lines with the same
commands. If the block contains commands for named bearings, it is tried in inputs/in.6208 with one
ball pass instead. The Python and console blocks of a page are run in a folder that looks like a
built tree after `make run`, whose run the blocks may use.
"""

import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
import warm_python
from host import HOSTS, ROOT

DOCS = ROOT / "docs"
PROGRAM = HOSTS["liggghts"][0]
FILM_ONLY = (
    "fix cap ",
    "compute contact ",
    "dump ",
    "dump_modify ",
    "variable out ",
    "shell mkdir ",
)
NAMED = ("bearing ", "run_bearing ", "bearing_dump ", "pair_style bearing ")
SHORT = {"out": "out", "settle": 1, "passes": 1, "lubricant": "vg46"}
MAIN = Path("build/run/6208")
# pages that do not need the main run
APART = ("tutorial_twin.rst", "sweep.rst")
UNDERLINE = re.compile(r"^([=\-~^\"])\1{3,}$")


def joined(text):
    """Return the commands of a deck, with continued lines joined, and without comments and blank
    lines."""
    text = re.sub(r"&\s*\n\s*", "", text)
    return [
        line
        for line in (re.sub(r"\s#.*|^#.*", "", line).strip() for line in text.splitlines())
        if line
    ]


def blocks(page):
    """Return the literal blocks in those sections of a page that have the heading Examples."""
    lines, inside, block = page.read_text().splitlines(), False, []
    for here, below in zip(lines, lines[1:] + [""]):
        if UNDERLINE.match(below):
            inside = here.strip() == "Examples"
        if inside and here.startswith("   "):
            block.append(here)
        elif block and here.strip():
            yield "\n".join(block)
            block = []
    if block:
        yield "\n".join(block)


def session(page):
    """Return the Python and console blocks of a page, in order, as a list of (type, text). Blocks
    are fenced in Markdown and indented in reStructuredText."""
    text = page.read_text()
    pattern = (
        r"^```(python|console)\n((?:(?!```).*\n)*)```$"
        if page.suffix == ".md"
        else r"^\.\. code-block:: (python|console)\n\n((?:(?:   .*)?\n)+)"
    )
    for kind, block in re.findall(pattern, text, flags=re.MULTILINE):
        yield (
            kind,
            "\n".join(
                line.removeprefix("   ") if page.suffix == ".rst" else line
                for line in block.splitlines()
            ),
        )


def not_printed(block, output):
    """Return a message with the first line of a transcript that is missing from the output, or an
    empty string if no line is missing."""
    printed = (line.rstrip() for line in output.splitlines())
    for line in block.splitlines():
        if line.strip() in ("", "...") or line.startswith("$ "):
            continue
        if line.rstrip() not in printed:
            return f"{block}\nnot printed: {line}"
    return None


def run_session(page, folder):
    """Run the blocks of a page in `folder`, and yield one string for each block: a message if the
    block failed, otherwise an empty string.

    Console lines that begin with "$ " are commands; the lines that follow must appear in the output
    of these commands, in this order. Commands that show no output must succeed.
    """
    # containers run as root, which Open MPI rejects unless these environment variables are set
    root = ("OMPI_ALLOW_RUN_AS_ROOT", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM")
    paths = os.environ | dict.fromkeys(root, "1")
    for number, (kind, block) in enumerate(session(page), 1):
        transcript = block.startswith("$ ")
        if kind == "python":
            code, printed = warm_python.run(block, folder, paths)
        else:
            commands = (
                "\n".join(line[2:] for line in block.splitlines() if line.startswith("$ "))
                if transcript
                else block
            )
            code, printed = run_console(commands, folder, paths)
        shown = transcript and any(line[:2] != "$ " for line in block.splitlines() if line.strip())
        failed = not_printed(block, printed) if shown else code != 0 and block
        yield failed and f"{kind} block {number}:\n{failed}\n{printed[-1200:]}"


def run_console(commands, folder, paths):
    """Run shell commands until one of them fails, and return (exit code, output)."""
    printed = ""
    for command in warm_python.split(commands):
        if plain := warm_python.words(command):
            code, text = warm_python.run(plain, folder, paths)
        else:
            done = subprocess.run(
                ["bash", "-ec", command],
                cwd=folder,
                env=paths,
                stdout=subprocess.PIPE,
                stderr=subprocess.STDOUT,
                text=True,
                errors="replace",
            )
            code, text = done.returncode, done.stdout
        printed += text
        if code:
            break
    return code, printed


def key(line):
    """Return the key of a line; lines with equal keys are assumed to be the same command."""
    word = line.split()
    if word[0] in ("pair_style", "create_bearing", "timestep", "run", "bearing", "run_bearing"):
        return word[0]
    if word[0] in ("pair_coeff", "variable"):
        return tuple(word[:3] if word[0] == "pair_coeff" else word[:2])
    if word[0] in ("fix", "compute"):
        style = "nve/sphere" if word[3] == "bearing/implicit" else word[3]  # both move the balls
        if style in ("bearing/ring", "bearing/shaft"):  # both move the rings
            return word[0], word[2]
        return word[0], style
    return line


def base_of(block):
    """Return the lines of the deck in which a block is tried."""
    if not any(line.startswith(NAMED) or " bearing/heat" in line for line in block):
        return joined((DOCS / "decks/in.ehd").read_text())
    short = [f"variable {name} index {value}" for name, value in SHORT.items()]
    return short + joined((ROOT / "inputs/in.6208").read_text())


def deck(base, block):
    """Return the lines of `base`, where the lines of `block` replace those with the same
    commands."""
    if any("bearing/hertz" in line for line in block):
        base = [
            line.replace(" f_cap", "").replace(" c_total[6] c_total[7]", "")
            for line in base
            if not line.startswith(FILM_ONLY)
        ]
    if any(
        "bearing/contact" in line for line in block
    ):  # such a compute does not have the columns that the dump writes
        base = [line for line in base if not line.startswith(("dump ", "dump_modify "))]
    if any("axis x" in line for line in block):
        base = [line.replace("x free y free", "y free z free") for line in base]
    given = {key(line): line for line in block}
    rest = [line for line in block if key(line) not in {key(line) for line in base}]
    result = []
    for line in base:
        if line.startswith(("create_bearing", "timestep", "run_bearing")):
            early = [
                new
                for new in rest
                if new.startswith(("pair_coeff", "variable")) == line.startswith("create_bearing")
            ]
            result += early
        result.append("run 100" if line.startswith("run ") else given.get(key(line), line))
    return result


PAGES = {
    page: count
    for page in [ROOT / "README.md", *DOCS.glob("*.rst")]
    if (count := len(list(session(page))))
}
BLOCKS = {
    f"{page.stem} {number}": joined(block)
    for page in sorted(DOCS.glob("*.rst"))
    for number, block in enumerate(blocks(page), 1)
}


@pytest.fixture(scope="session")
def main_run(tmp_path_factory):
    folder = tmp_path_factory.mktemp("main")
    (folder / "inputs").symlink_to(ROOT / "inputs")
    command = [PROGRAM, "-in", "inputs/in.6208", "-log", "none"]
    subprocess.run(command, cwd=folder, capture_output=True, check=True)
    return folder / MAIN


@pytest.mark.parametrize("page", sorted(PAGES, key=PAGES.get, reverse=True), ids=lambda p: p.stem)
def test_page(page, tmp_path, request):
    """The commands and Python blocks of a page run in order, and their output contains what the
    page shows."""
    for folder in ("inputs", "docs/decks"):
        shutil.copytree(ROOT / folder, tmp_path / folder)
    (tmp_path / "build").mkdir()
    (tmp_path / "build/liggghts").symlink_to(PROGRAM)
    (tmp_path / ".venv").symlink_to(ROOT / ".venv")
    if page.name not in APART:
        shutil.copytree(request.getfixturevalue("main_run"), tmp_path / MAIN)
    failed = [trouble for trouble in run_session(page, tmp_path) if trouble]
    assert not failed, "\n\n".join(failed)


def test_commands_run_without_an_activated_environment():
    lines = [
        f"{page.stem}: {line}"
        for page in PAGES
        for kind, block in session(page)
        if kind == "console"
        for line in block.splitlines()
    ]
    assert len(lines) > 100
    assert not [line for line in lines if re.search(r": (\$ )?(raceway|python) ", line)]


@pytest.mark.parametrize("script", sorted(DOCS.glob("decks/*.py")), ids=lambda path: path.stem)
def test_script(script):
    done = subprocess.run(
        [sys.executable, script], cwd=ROOT, capture_output=True, text=True, errors="replace"
    )
    assert done.returncode == 0, done.stdout[-400:] + done.stderr[-800:]


def try_deck(lines, folder):
    (folder / "in.deck").write_text("\n".join(lines) + "\n")
    done = subprocess.run(
        [PROGRAM, "-in", "in.deck", "-log", "none"],
        cwd=folder,
        capture_output=True,
        text=True,
        errors="replace",
    )
    told = [*lines, done.stdout[-800:], done.stderr[-400:]]
    assert done.returncode == 0, "\n".join(told)


@pytest.fixture
def beside_inputs(tmp_path):
    (tmp_path / "inputs").symlink_to(ROOT / "inputs")
    return tmp_path


def test_decks(beside_inputs):
    """The decks run one after another in one folder, because some of them read files that earlier
    ones wrote."""
    gallery = (DOCS / "gallery.rst").read_text()  # its test runs the decks that it mentions
    for path in sorted(DOCS.glob("decks/in.*")):
        if f"docs/decks/{path.name}" not in gallery:
            try_deck(joined(path.read_text()), beside_inputs)


@pytest.mark.parametrize("lines", BLOCKS.values(), ids=BLOCKS)
def test_block(lines, beside_inputs):
    """Each block under the heading "Examples" runs as part of its deck."""
    try_deck(deck(base_of(lines), lines), beside_inputs)
