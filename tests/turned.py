# SPDX-License-Identifier: GPL-2.0-or-later
"""Transform the record of a run into a record of the same scene in a different orientation in the
lab frame."""

import re
import shutil
from itertools import product

import netCDF4
import numpy as np
from fuzz.pose import Pose

ABOUT_AXIS = {"ring_spin", "ring_angle", "ring_torque", "bearing_cage_speed"}
PLACES = ("ring_origin_", "ball_", "cage_")
VECTORS = [
    *(f"{atoms}_{kind}" for atoms, kind in product(("ball", "cage"), ("", "v", "omega"))),
    *(f"ring_{kind}" for kind in ("origin_", "", "v", "f", "m", "a")),
]


def own_frame(pose):
    """Return the `Pose` in the frame of the bearing, whose axis is z, for a `Pose` in the lab
    frame."""
    return Pose(tuple((lab - pose.axis - 1) % 3 for lab in pose.axes), pose.signs)


def wrapped(angle):
    """Return `angle` wrapped to the range from -pi to pi."""
    return np.mod(angle + np.pi, 2 * np.pi) - np.pi


def write(source, folder, pose):
    """Write the run in `source`, whose axis is z, to `folder` in the orientation `pose`, without
    checksums."""
    folder.mkdir(parents=True)
    text = (source / "run.yaml").read_text()
    text = re.sub("(load_azimuth_rad|axial_N): .*\n", "", text)  # they are stored in the record
    (folder / "run.yaml").write_text(text.replace("axis: z", f"axis: {'xyz'[pose.axis]}"))
    for name in ("restart", "restart.deck"):
        if (source / name).exists():
            shutil.copy(source / name, folder)
    with (
        netCDF4.Dataset(source / "record.nc") as old,
        netCDF4.Dataset(folder / "record.nc", "w", format="NETCDF3_64BIT_OFFSET") as new,
    ):
        old.set_auto_maskandscale(False)
        new.set_auto_maskandscale(False)
        new.set_fill_off()
        attributes = {name: old.getncattr(name) for name in old.ncattrs() if name != "checksum"}
        attributes["axis"] = "xyz"[pose.axis]
        if "load_azimuth_rad" in attributes:
            attributes["load_azimuth_rad"] = _azimuth(attributes["load_azimuth_rad"], pose)
        if "axial_N" in attributes:
            attributes["axial_N"] *= pose.signs[2]
        new.setncatts(attributes)
        for name, size in old.dimensions.items():
            new.createDimension(name, None if size.isunlimited() else len(size))
        values = _turned(old, pose)
        for name, variable in old.variables.items():
            if name == "checksum":
                continue
            made = new.createVariable(name, variable.dtype, variable.dimensions)
            made.setncatts({key: variable.getncattr(key) for key in variable.ncattrs()})
        for name, variable in new.variables.items():
            variable[...] = values.get(name, old[name][...])
    return folder


def _azimuth(own, pose):
    if pose.sense == 1 and not pose.azimuth(0):
        return own  # bitwise identical
    return wrapped(pose.sense * own + pose.azimuth(0))


def _turned(old, pose):
    values = {}
    for stem in (stem for stem in VECTORS if f"{stem}x" in old.variables):
        own = np.stack([old[f"{stem}{x}"][...] for x in "xyz"])
        hand = pose.hand if stem.endswith(("omega", "_m")) else 1
        for lab, x in enumerate("xyz"):
            from_ = pose.axes.index(lab)
            found = hand * pose.signs[from_] * own[from_]
            values[f"{stem}{x}"] = found + pose.centre[lab] if stem in PLACES else found
    for name in ABOUT_AXIS & set(old.variables):
        values[name] = pose.sense * old[name][...]
    inside = own_frame(pose)
    for k in (0, 1):  # the tilts are about the two axes that follow the bearing's axis
        own = inside.axes.index(k)
        values[f"ring_tilt_{k + 1}"] = (
            inside.hand * inside.signs[own] * old[f"ring_tilt_{own + 1}"][...]
        )
    if "azimuth" in old.variables:
        values["azimuth"] = _azimuth(old["azimuth"][...], pose)
        values["angle"] = pose.signs[2] * old["angle"][...]
        if pose.signs[2] < 0 and old["azimuth"].shape[1] == 4:  # swap the two grooves
            for name, variable in old.variables.items():
                if variable.dimensions == ("time", "raceway", "ball"):
                    values[name] = values.get(name, variable[...])[:, [1, 0, 3, 2]]
    return values
