# SPDX-License-Identifier: GPL-2.0-or-later
"""`raceway decks`: list and copy the decks, bearings and lubricants of the package."""

import argparse

HELP = "list or copy the decks and data files that come with raceway"
DESCRIPTION = """\
Without NAME, lists the decks, bearings and lubricants of the package. With names, copies them into
DIR. A deck is copied together with the folder `inputs` of data files, so that a host started in DIR
can run it. A bearing or lubricant is copied as a file that can be edited."""
EXAMPLES = """\
examples:
  raceway decks
  raceway decks in.6208                 then: lmp -in in.6208
  raceway decks in.axial vg46 --to trial

Existing files with the same content are left unchanged.
Exit codes: 0 done, 1 no such name or a file exists with different content, 2 wrong command line."""


def add(one: argparse.ArgumentParser) -> None:
    one.add_argument("names", nargs="*", metavar="NAME", help="deck, bearing or lubricant")
    one.add_argument("--to", metavar="DIR", default=".", help="folder to copy to (default: .)")


def run(arguments: argparse.Namespace) -> None:
    from raceway import decks

    for name in arguments.names:
        written = decks.copy(name, arguments.to)
        more = f" and {len(written) - 1} files in inputs" if len(written) > 1 else ""
        print(f"{written[0]}{more}" if written else f"{name}: already exists")
    if arguments.names:
        return
    for kind, found in (("Decks", decks.decks()), ("Lubricants", decks.lubricants())):
        print(f"{kind}:")
        for name, title in found.items():
            print(f"  {name:<12}  {title}")
    print(f"Bearings: {len(decks.bearings())}, listed by `raceway catalogue`")
