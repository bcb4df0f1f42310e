# SPDX-License-Identifier: GPL-2.0-or-later
"""Run the decks of a case in a separate folder, and report how each run ended."""

import re
import subprocess
from dataclasses import dataclass
from pathlib import Path

from fuzz import figures
from fuzz.deck import deck
from fuzz.pose import UPRIGHT
from host import deck_file, run

HOSTS = {"liggghts": "liggghts", "lammps": "lammps", "plugin": "wheel", "sanitized": "sanitized"}
# limit for runs that take 0.1 s on an idle machine but up to a hundred times as long on a busy one
SECONDS = 600
CRASH = re.compile(
    r"Segmentation|Aborted|Traceback|terminate called|AddressSanitizer|runtime error|stack smashing"
)

# errors that the physics may cause if a run is longer or slightly different
LATER = re.compile(
    r"on the far side of the groove|overlapping balls: atoms"
    r"|bearing/timestep: step \S+ s exceeds what|it has left its pocket"
)

# stack frames of crashes that also occur in the host when the package is not installed
HOSTS_OWN = re.compile(r"DumpLocal10init_style|DumpCustom10init_style")


class Finding(Exception):
    """A failure found by a case."""


class Refused(Exception):
    """Raised if the first deck of a case is rejected; this ends the case."""


@dataclass
class Lab:
    """A folder, a host, and the decks that have been run so far."""

    folder: Path
    host: str = "liggghts"
    runs: int = 0

    def start(self, text, name="run", ranks=1, host=None):
        """Run a deck and return its outcome. A crash, a hang, or a failure without a message is a
        finding."""
        self.runs += 1
        file = deck_file(self.folder, text, f"in.{name}")
        try:
            end = run(
                file,
                host=HOSTS[host or self.host],
                ranks=ranks,
                timeout=SECONDS,
                cwd=self.folder,
                out=self.folder / name,
            )
        except subprocess.TimeoutExpired:
            raise Finding(f"hang: {name} runs for more than {SECONDS} s") from None
        if (end.code < 0 or end.code > 128 or CRASH.search(end.text)) and not HOSTS_OWN.search(
            end.text
        ):
            raise Finding(f"crash: {name}, exit code {end.code}: {end.text[-400:]}")
        if end.code > 0 and not end.error:
            raise Finding(f"no message: {name}, exit code {end.code}: {end.text[-400:]}")
        return end

    def figures(self, scene, name="first", pose=UPRIGHT, ranks=1, host=None, text=None, **options):
        """Return the results of a run of a scene, in the frame of the scene."""
        end = self.start(text or deck(scene, pose, **options), name, ranks, host)
        if end.code:
            message = end.error.splitlines()[0]
            if name == "first" or LATER.search(message):
                raise Refused(message)
            raise Finding(f"only run {name} is rejected: {message}")
        values = figures.read(self.folder / name, scene, pose)
        if bad := figures.finite(values):
            raise Finding(f"not finite: {name}: {', '.join(bad[:8])}")
        return values


def same(first, second, tolerance, what):
    """Check that the results of two runs agree."""
    if found := figures.differences(first, second, tolerance):
        words = "; ".join(
            f"{table} {column} differs by {share:.2g} at sample {sample}"
            for share, table, column, sample in found[:6]
        )
        raise Finding(f"{what}: {words}")
