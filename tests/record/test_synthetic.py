# SPDX-License-Identifier: GPL-2.0-or-later
"""The synthetic record used in the tests of the reader has the same layout as a real record."""

import pytest
import synthetic
import xarray as xr
from host import succeed


def layout(folder):
    """Return the layout without the checksums, which synthetic records do not contain: (dimensions
    except time, {variable: (dimensions, type, attributes)}, {attribute: type})."""
    with xr.open_dataset(folder / "record.nc", engine="scipy", decode_cf=False) as data:
        data = data.drop_vars("checksum", errors="ignore")
        sizes = {name: size for name, size in data.sizes.items() if name != "time"}
        variables = {
            name: (one.dims, one.dtype.str, one.attrs) for name, one in data.variables.items()
        }
        return sizes, variables, {name: type(value) for name, value in data.attrs.items()}


@pytest.mark.parametrize("lubricant", ["mineral", "dry"])
def test_layout(lubricant, tmp_path):
    scene = {"passes": 1, "samples": 20, "models": "paper", "lubricant": lubricant}
    succeed("inputs/in.6208", out=tmp_path / "real", **scene)
    oil = synthetic.OIL if lubricant != "dry" else None
    synthetic.write(tmp_path / "made", synthetic.run(oil=oil, passes=1, samples_per_pass=20))
    real, made = layout(tmp_path / "real"), layout(tmp_path / "made")
    assert made[0] == real[0]
    assert made[1] == real[1]
    assert made[2].items() <= real[2].items()
