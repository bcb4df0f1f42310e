# SPDX-License-Identifier: GPL-2.0-or-later
"""Write the pages of `make bench`, with tables and a description of the machine."""

import platform
import re
import statistics
import subprocess
import sys
import tempfile
from datetime import date
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PAGES = ROOT / "build" / "bench"
YARDSTICK = Path(__file__).with_name("yardstick.cpp")


def bench_file(name):
    """Return the path of a page or picture, after creating its folder if that does not exist."""
    PAGES.mkdir(parents=True, exist_ok=True)
    return PAGES / name


def publish(title, text, name=None, /, **parts):
    """Print a page and, unless the command line has the word --print, write it to build/bench under
    a name, by default that of the script. `parts` replace the names in braces in `text`; a list is
    joined to lines. {machine} is the description of the machine."""
    script = Path(sys.argv[0])
    if "{machine}" in text:
        parts["machine"] = [f"- {fact}" for fact in machine()]
    joined = {k: "\n".join(one) if isinstance(one, list) else one for k, one in parts.items()}
    head = [
        title,
        "=" * len(title),
        "",
        f"Written by ``tests/{script.resolve().parent.name}/{script.name}``, {date.today()}.",
    ]
    page = "\n".join([*head, "", text.format(**joined)])
    print(page)
    if "--print" not in sys.argv:
        bench_file(f"{name or script.stem}.rst").write_text(page)


def words_asked():
    """Return the words on the command line other than --print, which any bench accepts."""
    return [word for word in sys.argv[1:] if word != "--print"]


def count_asked(usual):
    """Return the number on the command line, or `usual` if there is none."""
    return int(next(iter(words_asked()), usual))


def spread(values, form=".3g"):
    """Return the median and the range of the values as text."""
    ends = (statistics.median(values), min(values), max(values))
    return "{} ({} to {})".format(*(f"{one:{form}}" for one in ends))


def yardstick(rounds=9):
    """Return the times (s) of `rounds` repetitions of the fixed work in yardstick.cpp."""
    with tempfile.TemporaryDirectory() as folder:
        program = Path(folder) / "yardstick"
        subprocess.run(["g++", "-std=c++17", "-O2", YARDSTICK, "-o", program], check=True)
        return [
            float(subprocess.run([program], capture_output=True, check=True).stdout.split()[0])
            for _ in range(rounds)
        ]


def csv_table(head, rows):
    """Return the lines of a csv-table with the heading `head`, one line per row."""

    def cell(value):
        text = str(value)
        return '"' + text.replace('"', '""') + '"' if not text or {*',"'} & {*text} else text

    lines = ["   " + ", ".join(map(cell, row)) for row in (head, *rows)]
    return [".. csv-table::", "   :header-rows: 1", "", *lines, ""]


def machine():
    """Return lines that state the processor, the versions of compiler and hosts, and the time of
    the yardstick."""
    cpu = re.search(r"model name\s*:\s*(.+)", Path("/proc/cpuinfo").read_text()).group(1)
    gcc = subprocess.run(
        ["g++", "--version"], capture_output=True, text=True, check=True
    ).stdout.splitlines()[0]
    package = subprocess.run(
        ["dpkg-query", "-W", "-f", "${Version}", "liggghts"],
        capture_output=True,
        text=True,
        check=True,
    ).stdout
    return [
        f"processor: {cpu}, one core used; the machine was shared with other work",
        f"compiler: {gcc}",
        f"host: LIGGGHTS {package} (Debian)",
        f"system: {platform.platform(terse=True)}",
        f"yardstick (fixed work, tests/bench/yardstick.cpp), seconds: {spread(yardstick(), '.3f')}",
    ]
