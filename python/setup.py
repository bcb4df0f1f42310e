# SPDX-License-Identifier: GPL-2.0-or-later
"""Build the library of laws (src-package/core/interface) into the package. If RACEWAY_PLUGIN names
a folder, the wheel also contains the LAMMPS plugin from that folder. All other settings are in
pyproject.toml."""

import os
import re
import shutil
import subprocess
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext
from setuptools.command.build_py import build_py
from setuptools.errors import CCompilerError

try:
    from setuptools.command.bdist_wheel import bdist_wheel
except ImportError:  # setuptools before 70.1 does not build wheels itself
    bdist_wheel = None

HERE = Path(__file__).resolve().parent
CORE = HERE / "core"  # a link to src-package/core, or a copy of it in a source distribution
VERSION = re.search(r'"(.+)"', (CORE / "settings" / "raceway_version.h").read_text())[1]
PLUGIN = ("raceway_plugin.so", "libraceway_lammps.so")
INTERFACE = CORE / "interface"
# sources of the tables, which are also compiled into the simulation programs
TABLES = [CORE / name for name in (INTERFACE / "tables.txt").read_text().split()]
BUILT = HERE / "src" / "raceway" / "core" / "lib" / "libraceway_core.so"


class Core(build_ext):
    """Build a plain shared library, which needs a C++ compiler but neither the headers of Python
    nor numpy."""

    def get_ext_filename(self, name):
        return name.replace(".", os.sep) + ".so"

    def build_extension(self, extension):
        target = Path(self.get_ext_fullpath(extension.name)).resolve()
        target.parent.mkdir(parents=True, exist_ok=True)
        if up_to_date(BUILT):
            if BUILT != target:
                shutil.copy2(BUILT, target)
            return
        build(target, Path(self.build_temp).resolve())


def up_to_date(library):
    made = library.stat().st_mtime if library.exists() else 0.0
    sources = [*CORE.glob("*/*.h"), *INTERFACE.iterdir(), *TABLES]
    return all(path.stat().st_mtime <= made for path in sources)


def build(target, folder):
    """Compile the library to `target`, with object files in `folder`. Raises `CCompilerError` if
    there is no compiler, or with the compiler's output if compilation fails."""
    compiler = os.environ.get("CXX") or next(filter(shutil.which, ("g++", "clang++", "c++")), None)
    if compiler is None:
        raise CCompilerError("raceway needs a C++ compiler for its laws: install g++, or set CXX")
    flags = (INTERFACE / "compile_flags.txt").read_text().split()
    folder.mkdir(parents=True, exist_ok=True)

    def run(*arguments):
        done = subprocess.run([*compiler.split(), *arguments], capture_output=True, text=True)
        if done.returncode:
            raise CCompilerError(f"{' '.join(map(str, arguments))}\n{done.stderr}")

    def compiled(unit):
        name, sources = unit
        source, made = folder / f"{name}.cpp", folder / f"{name}.o"
        source.write_text("".join(f'#include "{path}"\n' for path in sources))
        run(*flags, "-c", source, "-o", made)
        return made

    # two units read the headers only twice and take less than half the time of separate sources
    units = {"interface": sorted(INTERFACE.glob("*.cpp")), "tables": TABLES}
    with ThreadPoolExecutor() as pool:
        objects = list(pool.map(compiled, units.items()))
    run("-shared", *objects, "-o", target)


class Package(build_py):
    """Install the Python files and, if requested, the plugin."""

    def run(self):
        super().run()
        if folder := os.environ.get("RACEWAY_PLUGIN"):
            target = Path(self.build_lib) / "raceway" / "host"
            target.mkdir(parents=True, exist_ok=True)
            for name in PLUGIN:
                shutil.copy2(Path(folder) / name, target / name)


commands = {"build_ext": Core, "build_py": Package}
if bdist_wheel:

    class Wheel(bdist_wheel):
        """Build a wheel for any version of Python, because the libraries do not use it. They need
        the C library with which they were built or a later one, which the tag states according to
        PEP 600."""

        def get_tag(self):
            library, version = os.confstr("CS_GNU_LIBC_VERSION").split()
            _, _, platform = super().get_tag()
            assert library == "glibc" and platform.startswith("linux_")
            system = f"manylinux_{version.replace('.', '_')}_{platform.removeprefix('linux_')}"
            return "py3", "none", system

    commands["bdist_wheel"] = Wheel


setup(
    version=VERSION,
    ext_modules=[Extension("raceway.core.lib.libraceway_core", [])],
    cmdclass=commands,
)
