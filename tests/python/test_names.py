# SPDX-License-Identifier: GPL-2.0-or-later
"""Messages about wrong names and files state how to correct them."""

import pytest
import raceway
from raceway import inputs, static
from raceway.errors import InputError
from raceway.sweeps.host_run import complaint


def test_public_names():
    """Only public names are offered for completion, and the error message for a wrong name suggests
    the most similar name."""
    assert {name for name in dir(raceway) if not name.startswith("__")} == {
        name for name in raceway.__all__ if not name.startswith("__")
    }
    with pytest.raises(AttributeError, match="no attribute 'simulte'; did you mean simulate"):
        _ = raceway.simulte


def test_a_name_is_not_a_bearing():
    with pytest.raises(TypeError, match=r"must be a Bearing, such as raceway\.inputs\.bearing"):
        static.equilibrium("6208", 1000.0)


def test_an_oil_without_viscosity(tmp_path):
    (tmp_path / "oil").write_text("variable viscosity_40 index 52\nvariable density index 830\n")
    with pytest.raises(InputError, match="kinematic_viscosity_40.* it has viscosity_40, density"):
        inputs.fluid(tmp_path / "oil")


def test_the_last_words_of_a_host(tmp_path):
    """If there is no error line, the message is the last line that is not a rule."""
    (tmp_path / "log").write_text("mpirun cannot run as root\n\n-------\n  ====\n")
    assert complaint(tmp_path / "log", 1) == "exit code 1; last line: mpirun cannot run as root"
