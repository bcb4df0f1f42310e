# SPDX-License-Identifier: GPL-2.0-or-later
"""Where `make bench` writes its pages, and what a measurement ran on."""

import platform
import re
import subprocess
from pathlib import Path

PAGES = Path(__file__).resolve().parents[2] / "build" / "bench"


def bench_file(name):
    """The path of one of its pages or pictures, in a folder that is there."""
    PAGES.mkdir(parents=True, exist_ok=True)
    return PAGES / name


def machine():
    """Processor, compiler and host versions, in one line each."""
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
        f"processor: {cpu}, one core used, machine shared with other work",
        f"compiler: {gcc}",
        f"host: LIGGGHTS {package} (Debian)",
        f"system: {platform.platform(terse=True)}",
    ]
