# SPDX-License-Identifier: GPL-2.0-or-later
"""What a measurement ran on, for the pages of docs/performance."""

import platform
import re
import subprocess
from pathlib import Path


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
