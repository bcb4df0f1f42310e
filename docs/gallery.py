# SPDX-License-Identifier: GPL-2.0-or-later
"""Make the pictures of docs/gallery.rst by the commands that page shows.

    .venv/bin/python docs/gallery.py            into docs/gallery
    .venv/bin/python docs/gallery.py --check    compare with what is there

With --check, exit code 1 when a picture differs.
"""

import re
import shutil
import sys
from pathlib import Path

import numpy as np
from PIL import Image
from try_examples import run_session
from workspace import workspace

DOCS = Path(__file__).resolve().parent
PAGE = DOCS / "gallery.rst"
LARGEST = 300_000  # bytes of a picture
# grey levels of 255, mean: room for another processor's rounding at the edges of lines, none for
# another picture
SAME = 0.5


def shown():
    """The names of the page's pictures."""
    return re.findall(r"^\.\. image:: gallery/(\S+)$", PAGE.read_text(), flags=re.MULTILINE)


def difference(one, other):
    """Mean difference of two pictures, or the largest of their frames', in grey levels of 255;
    infinite when of unlike size."""
    with Image.open(one) as a, Image.open(other) as b:
        if a.size != b.size or getattr(a, "n_frames", 1) != getattr(b, "n_frames", 1):
            return np.inf
        worst = 0.0
        for k in range(getattr(a, "n_frames", 1)):
            a.seek(k)
            b.seek(k)
            worst = max(
                worst,
                np.abs(
                    np.asarray(a.convert("RGB"), float) - np.asarray(b.convert("RGB"), float)
                ).mean(),
            )
        return worst


def troubles(folder):
    """What is wrong with the pictures that the page's commands left in `folder`, a line each."""
    for name in shown():
        made, kept = folder / "build/gallery" / name, DOCS / "gallery" / name
        if not made.exists() or not kept.exists():
            yield f"{name}: " + ("not made by the page" if kept.exists() else "not in docs/gallery")
        elif made.stat().st_size > LARGEST:
            yield f"{name}: {made.stat().st_size} bytes, more than {LARGEST}"
        elif (apart := difference(made, kept)) > SAME:
            yield (
                f"{name}: {apart:.2g} grey levels from what the page's commands give: run"
                " docs/gallery.py"
            )


def main():
    failed = False
    with workspace() as folder:
        for name, trouble in run_session(PAGE, folder):
            print(f"{'FAILED' if trouble else 'ok    '} {name}", trouble or "")
            failed |= bool(trouble)
        if not failed and "--check" not in sys.argv:
            (DOCS / "gallery").mkdir(exist_ok=True)
            for name in shown():
                shutil.copyfile(folder / "build/gallery" / name, DOCS / "gallery" / name)
        for trouble in troubles(folder) if not failed else ():
            print("FAILED", trouble)
            failed = True
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
