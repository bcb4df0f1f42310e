# SPDX-License-Identifier: GPL-2.0-or-later
"""Spack package with the plugin for the LAMMPS of the same spec, and the Python package.

Put this file into packages/raceway of your own repository, put the archive of `make dist` there,
and run `spack install raceway`.
"""

import os

from spack.package import *
from spack_repo.builtin.build_systems.cmake import CMakePackage
from spack_repo.builtin.build_systems.python import PythonExtension


class Raceway(CMakePackage, PythonExtension):
    """Ball bearings under elastohydrodynamic lubrication: styles for LAMMPS, and a Python package
    that runs bearings and reads and plots the results."""

    url = f"file://{os.path.dirname(__file__)}/raceway-1.0.0-full.tar.gz"

    license("GPL-2.0-or-later")

    # `make dist` does not print a checksum, since the archive is your own: use --no-checksum
    version("1.0.0")

    root_cmakelists_dir = "src-package/host"
    extends("python@3.11:")

    depends_on("cxx", type="build")
    depends_on("cmake@3.16:", type="build")
    depends_on("mpi")
    # the interface of the host is stable from 4 May 2022 on
    depends_on("lammps@20220504: +mpi +lib +plugin", type=("build", "link", "run"))

    depends_on("py-pip", type="build")
    depends_on("py-setuptools@70.1:", type="build")
    with default_args(type="run"):
        depends_on("py-numpy@1.24.2:")
        depends_on("py-scipy@1.10.1:")
        depends_on("py-pandas@1.5.3:")
        depends_on("py-matplotlib@3.6.3:")
        depends_on("py-pillow@9.4:")
        depends_on("py-pyyaml@6.0:")
        depends_on("py-xarray@2023.1:")
        depends_on("py-tqdm@4.64.1:")

    def cmake_args(self):
        return [self.define("LAMMPS", self.spec["lammps"].prefix)]

    @run_after("install")
    def python_package(self):
        pip("install", "--no-deps", "--no-build-isolation", f"--prefix={self.prefix}", "./python")

    def setup_run_environment(self, env):
        env.prepend_path("LAMMPS_PLUGIN_PATH", self.prefix.lib.lammps.plugins)
