# SPDX-License-Identifier: GPL-2.0-or-later
"""Run what the pages show: the decks in docs/decks, every block under a heading "Examples", and
every Python or console block, in the order of its page.

    .venv/bin/python docs/try_examples.py [build/liggghts]

A block under "Examples" stands in for the lines of decks/in.ehd that give the same command, or,
with commands of named bearings, for those of inputs/in.6208 with one ball pass; the rest of that
deck stays. Python and console blocks of a page run in a copy (workspace.py): a finished run is not
replaced by default, so none from an earlier build may be present. They may use the run of `make
run`, except on pages that make it themselves. As many pages run at a time as there are cores. Exit
code 1 when a run fails; its last lines are shown.
"""

import os
import re
import shutil
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from functools import partial
from pathlib import Path

from workspace import workspace

DOCS = Path(__file__).resolve().parent
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
# they make the main run, or need none
APART = ("tutorial.rst", "tutorial_twin.rst", "sweep.rst", "gallery.rst")
UNDERLINE = re.compile(r"^([=\-~^\"])\1{3,}$")


def joined(text):
    """The commands of a deck: no comments, no blank lines, no continuations."""
    text = re.sub(r"&\s*\n\s*", "", text)
    return [
        line
        for line in (re.sub(r"\s#.*|^#.*", "", line).strip() for line in text.splitlines())
        if line
    ]


def blocks(page):
    """The literal blocks of a page's sections called Examples."""
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
    """The Python and console blocks of a page, as (kind, text) in their order: fenced in Markdown,
    indented in rST."""
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
    """The first line of a transcript that is not in the output, in its place; or nothing."""
    printed = (line.rstrip() for line in output.splitlines())
    for line in block.splitlines():
        if line.strip() in ("", "...") or line.startswith("$ "):
            continue
        if line.rstrip() not in printed:
            return f"{block}\nnot printed: {line}"
    return None


def run_session(page, folder):
    """Run the blocks of a page in `folder`; the message of each failed one, or nothing.

    Console lines after "$ " are commands of `.venv/bin`, what follows has to be in what they print,
    in that order."""
    paths = dict(os.environ, PATH=f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}")
    # containers run as root, which Open MPI otherwise refuses
    paths |= dict.fromkeys(("OMPI_ALLOW_RUN_AS_ROOT", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM"), "1")
    for number, (kind, block) in enumerate(session(page), 1):
        transcript = block.startswith("$ ")
        commands = (
            "\n".join(line[2:] for line in block.splitlines() if line.startswith("$ "))
            if transcript
            else block
        )
        command = (
            [sys.executable, "-W", "error", "-c", block]
            if kind == "python"
            else ["bash", "-ec", commands]
        )
        done = subprocess.run(
            command,
            cwd=folder,
            env=paths,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
            errors="replace",
        )
        if transcript:
            failed = not_printed(block, done.stdout)
        else:
            failed = done.returncode != 0 and block
        yield f"{page.name} {kind} block {number}", failed and f"{failed}\n{done.stdout[-1200:]}"


def key(line):
    """Key of a line: two lines with one key are the same command."""
    word = line.split()
    if word[0] in ("pair_style", "create_bearing", "timestep", "run", "bearing", "run_bearing"):
        return word[0]
    if word[0] in ("pair_coeff", "variable"):
        return tuple(word[:3] if word[0] == "pair_coeff" else word[:2])
    if word[0] in ("fix", "compute"):
        style = "nve/sphere" if word[3] == "bearing/implicit" else word[3]  # either moves the balls
        if style in ("bearing/ring", "bearing/shaft"):  # either moves the rings
            return word[0], word[2]
        return word[0], style
    return line


def base_of(block):
    """Lines of the deck that a block is tried in."""
    if not any(line.startswith(NAMED) or " bearing/heat" in line for line in block):
        return joined((DOCS / "decks/in.ehd").read_text())
    short = [f"variable {name} index {value}" for name, value in SHORT.items()]
    return short + joined((DOCS.parent / "inputs/in.6208").read_text())


def deck(base, block):
    """`base` (lines) with the lines of `block` in their places."""
    if any("bearing/hertz" in line for line in block):
        base = [
            line.replace(" f_cap", "").replace(" c_total[6] c_total[7]", "")
            for line in base
            if not line.startswith(FILM_ONLY)
        ]
    if any(
        "bearing/contact" in line for line in block
    ):  # another compute: its columns are not the dump's
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


def of_script(script):
    """A Python script among the decks, run from the root."""
    done = subprocess.run(
        [sys.executable, script],
        cwd=DOCS.parent,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        errors="replace",
    )
    return [(script.name, done.returncode and done.stdout[-400:])]


def of_page(page, program, main_run):
    """Examples of a page, in a copy of the tree with the main run unless the page makes it."""
    with workspace(program) as folder:
        if page.name not in APART:
            shutil.copytree(main_run, folder / MAIN)
        return list(run_session(page, folder))


def of_decks(program, decks):
    """Decks (name, lines) one after the other in one folder: they read what those before them
    wrote."""
    found = []
    with tempfile.TemporaryDirectory() as top:
        folder = Path(top)
        (folder / "inputs").symlink_to(DOCS.parent / "inputs")
        path = folder / "in.deck"
        for name, lines in decks:
            path.write_text("\n".join(lines) + "\n")
            done = subprocess.run(
                [program, "-in", path, "-log", "none"],
                cwd=folder,
                capture_output=True,
                text=True,
                errors="replace",
            )
            told = "\n".join([*lines, done.stdout[-800:], done.stderr[-400:]])
            found.append((name, done.returncode and told))
    return found


def tasks(program, main_run):
    """All examples, the longest first; each returns pairs of a name and its message when it
    failed, or nothing."""
    pages = [DOCS.parent / "README.md", *DOCS.glob("*.rst")]
    blocks_of = {page: len(list(session(page))) for page in pages}
    for page in sorted(blocks_of, key=blocks_of.get, reverse=True):
        if blocks_of[page]:
            yield partial(of_page, page, program, main_run)
    for script in sorted((DOCS / "decks").glob("*.py")):
        yield partial(of_script, script)
    gallery = (DOCS / "gallery.rst").read_text()  # runs the decks that it names
    decks = [
        (path.name, joined(path.read_text()))
        for path in (DOCS / "decks").glob("in.*")
        if f"docs/decks/{path.name}" not in gallery
    ]
    yield partial(of_decks, program, sorted(decks))
    for page in sorted(DOCS.glob("*.rst")):
        for number, block in enumerate(blocks(page), 1):
            lines = joined(block)
            example = [(f"{page.name} example {number}", deck(base_of(lines), lines))]
            yield partial(of_decks, program, example)


def main():
    program = Path(sys.argv[1] if len(sys.argv) > 1 else DOCS.parent / "build/liggghts").resolve()
    failed = 0
    with workspace(program) as folder, ThreadPoolExecutor(os.cpu_count()) as pool:
        command = [program, "-in", "inputs/in.6208", "-log", "none"]
        subprocess.run(command, cwd=folder, capture_output=True, check=True)
        for found in pool.map(lambda task: task(), tasks(program, folder / MAIN)):
            for name, trouble in found:
                print(f"{'FAILED' if trouble else 'ok    '} {name}", trouble or "", flush=True)
                failed += bool(trouble)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
