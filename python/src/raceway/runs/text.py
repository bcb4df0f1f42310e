# SPDX-License-Identifier: GPL-2.0-or-later
"""The text files that a run writes in place of a record, or beside it."""

from pathlib import Path

from raceway.errors import RunError

FILES = {"contacts": "contacts.dump", "balls": "balls.dump", "rings": "rings.dat"}


def need_text(folder: Path) -> None:
    """Raise `RunError` where `folder` has none of them; it has no record either."""
    if not any((folder / name).exists() for name in FILES.values()):
        raise RunError(
            f"{folder} holds neither record.nc nor {', '.join(FILES.values())}: its run recorded"
            " nothing, or they are gone; -var record all makes a record"
        )
