# SPDX-License-Identifier: GPL-2.0-or-later
"""Install Raceway in the source tree of a host, and remove it again."""

from host import call


def contents(tree):
    """Return all files and folders in a tree."""
    return {
        str(path.relative_to(tree)): path.read_bytes() if path.is_file() else None
        for path in tree.rglob("*")
    }


class Installer:
    """`make install-tree` and `make uninstall-tree` for the source trees of one host."""

    def __init__(self, host):
        self.host = host

    def make(self, what, tree):
        """Install or uninstall, and return (exit code, output)."""
        done = call(["make", "-s", f"{what}-tree", f"{self.host}={tree}"])
        return done.returncode, done.stdout + done.stderr

    def refused(self, tree, says, what="install"):
        """Check that the tree is rejected with a message and left unchanged."""
        before = contents(tree)
        code, text = self.make(what, tree)
        assert code != 0 and "Refused: " in text and says in text, text
        assert "Traceback" not in text
        assert contents(tree) == before

    def in_and_out(self, tree):
        """Check that the tree must be named, that it is as before after Raceway has been installed
        and removed, and return what it contained before and in between."""
        self.refused(tree, "has no Raceway", what="uninstall")
        code, text = self.make("install", "")
        assert code != 0 and "make install-tree LIGGGHTS=" in text
        before = contents(tree)
        code, text = self.make("install", tree)
        assert code == 0, text
        after = contents(tree)
        self.refused(tree, "already contains Raceway")
        code, text = self.make("uninstall", tree)
        assert code == 0, text
        assert contents(tree) == before
        return before, after
