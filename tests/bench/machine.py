# SPDX-License-Identifier: GPL-2.0-or-later
"""Provide the folder for the pages that `make bench` writes, and a description of the machine."""

import platform
import re
import statistics
import subprocess
import sys
import tempfile
from pathlib import Path

PAGES = Path(__file__).resolve().parents[2] / "build" / "bench"
YARDSTICK = Path(__file__).with_name("yardstick.cpp")


def bench_file(name):
    """Return the path of a page or picture, after creating its folder if that does not exist."""
    PAGES.mkdir(parents=True, exist_ok=True)
    return PAGES / name


def publish(name, page):
    """Write a page, or print it if the command line has the word --print."""
    print(page) if "--print" in sys.argv else bench_file(name).write_text(page)


def yardstick(rounds=9):
    """Return the median, smallest and largest time (s) of `rounds` repetitions of the fixed work in
    yardstick.cpp."""
    with tempfile.TemporaryDirectory() as folder:
        program = Path(folder) / "yardstick"
        subprocess.run(["g++", "-std=c++17", "-O2", YARDSTICK, "-o", program], check=True)
        seconds = [
            float(subprocess.run([program], capture_output=True, check=True).stdout.split()[0])
            for _ in range(rounds)
        ]
    return statistics.median(seconds), min(seconds), max(seconds)


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
        "yardstick (fixed work, tests/bench/yardstick.cpp): {:.3f} s ({:.3f} to {:.3f})".format(
            *yardstick()
        ),
    ]
