# SPDX-License-Identifier: GPL-2.0-or-later
"""Reader that opens a run in MDAnalysis (optional: `pip install raceway[mdanalysis]`).

MDAnalysis stores positions and velocities in single precision. For a 6208 the resolution is 2 nm,
which is as large as the overlap of an unloaded ball or one per cent of a film, so these values are
accurate enough only for pictures and neighbour searches. Every frame also has double-precision
values in `trajectory.ts.data`:

- `position`, `velocity` (m, m/s), `spin` (rad/s): (atoms, 3)
- every column of the contacts for the inner and the outer raceway, `load_inner`, `h_min_outer` ...,
  or `load_inner_0` ... for two grooves per ring, in SI units: (atoms,), with 0 or NaN for an atom
  without such a contact, as in `Run.contacts`
- `step`, `time` (s), `sample`

Lengths are in metres and times in seconds, regardless of the units that MDAnalysis states. There is
no box. Vectors are given in the frame of the bearings (`runs.frame`), as in the datasets of a run.
"""

from typing import Any

import numpy as np

from raceway.errors import RunError
from raceway.runs import record_tables
from raceway.runs.columns import CONTACT
from raceway.runs.tables import RunTables

try:
    import MDAnalysis
    from MDAnalysis.coordinates.base import ReaderBase
    from MDAnalysis.lib.util import store_init_arguments
except ImportError:
    raise RunError("MDAnalysis is not installed: pip install 'raceway[mdanalysis]'") from None

# names by atom type, i.e. by the type of the part, which is the same for all bearings
NAMES = {1: "ball", 2: "cage", 3: "inner", 4: "outer", 5: "cage_ring"}
# number of atoms in consecutive frames that are read together, because an analysis usually
# continues with the next frame
ROWS = 5000
FEW = 8  # reading a single frame takes about 1/FEW of the time for a block


class RunReader(ReaderBase):
    """The trajectory of a run with random access to frames.

    It needs a few MB of memory for a run of any size. `first` and `stop` select a range of samples.
    """

    format = "RACEWAY"
    units = {"time": None, "length": None, "velocity": None}

    @store_init_arguments
    def __init__(
        self,
        filename: str,
        first: int = 0,
        stop: int | None = None,
        bearing: int | None = None,
        **kwargs: Any,
    ) -> None:
        self._tables = RunTables(filename, slice(first, stop), bearing)
        super().__init__(
            filename, **{"convert_units": False, "dt": self._tables.settings["sample_s"], **kwargs}
        )
        self.n_frames = self._tables.last - first
        self._loaded, self._asked = (0, 0), 0
        atoms = self._atoms_of(0, 1)
        self.ids, self.types = atoms["id"].to_numpy(int), atoms["type"].to_numpy(int)
        self.n_atoms = len(atoms)
        self._together = max(1, ROWS // self.n_atoms)
        self._reopen()
        self._read_next_timestep()

    def close(self) -> None:
        """Do nothing, because no file stays open between frames."""

    def _reopen(self):
        self.ts = self._Timestep(self.n_atoms, velocities=True, **self._ts_kwargs)
        self.ts.frame = -1

    def _read_frame(self, frame):
        self.ts.frame = frame - 1
        return self._read_next_timestep()

    def _read_next_timestep(self):
        frame = self.ts.frame + 1
        if not 0 <= frame < self.n_frames:
            # MDAnalysis ends an iteration when it receives this error.
            raise OSError(f"no frame {frame} of {self.n_frames}")
        data = self.ts.data
        if not self._loaded[0] <= frame < self._loaded[1]:
            self._load(*self._together_with(frame))
        self._asked = self.ts.frame = frame
        here = frame - self._loaded[0]
        for name, values in self._atoms.items():
            data[name] = values[here]
        data["sample"] = self._tables.first + frame
        data["step"], data["time"] = (
            self._steps[here],
            data["sample"] * self._tables.settings["sample_s"],
        )
        self.ts.positions, self.ts.velocities = data["position"], data["velocity"]
        return self.ts

    def _atoms_of(self, start, stop):
        """Return a table of the atoms in frames `start` to `stop`, sorted by sample and atom."""
        first = self._tables.first
        table = record_tables.atoms(self._tables.record, first + start, first + stop)
        return table.sort_values(["sample", "id"])

    def _together_with(self, frame):
        """Return (start, stop) of the frames to read together with `frame`.

        They include its neighbours, unless access is scattered.
        """
        if abs(frame - self._asked) > max(1, self._together // FEW):
            return frame, frame + 1
        start = frame // self._together * self._together
        return start, min(start + self._together, self.n_frames)

    def _load(self, start, stop):
        record, first = self._tables.record, self._tables.first
        self._steps = record.read(["step"], first + start, first + stop)["step"].astype(int)
        table = self._atoms_of(start, stop)
        self._atoms = {
            name: table[columns.split()].to_numpy().reshape(stop - start, self.n_atoms, 3)
            for name, columns in (
                ("position", "x y z"),
                ("velocity", "vx vy vz"),
                ("spin", "omegax omegay omegaz"),
            )
        }
        contacts = record_tables.contacts(record, first + start, first + stop)
        frame = contacts["sample"].to_numpy() - first - start
        atom = np.searchsorted(self.ids, contacts["ball"])
        sides = self._tables.by_raceway(contacts)
        places = {word: (frame[there], atom[there]) for word, there in sides.items()}
        for name in contacts:
            if name in ("ball", "raceway", "groove", "sample"):
                continue
            column = contacts[name].to_numpy()
            absent = CONTACT[name].absent if name in CONTACT else np.nan
            for word, there in sides.items():
                values = np.full((stop - start, self.n_atoms), absent)
                values[places[word]] = column[there]
                self._atoms[f"{name}_{word}"] = values
        self._loaded = start, stop


def universe(tables: RunTables) -> MDAnalysis.Universe:
    """Return an MDAnalysis `Universe` for the run `tables`.

    Its atoms are named ball, cage, inner, outer and cage_ring (a one-piece cage), and have the ids
    and types of the host. The trajectory is a `RunReader`. Raises `RunError` if a file is broken or
    if MDAnalysis is not installed.
    """
    reader = RunReader(str(tables.folder), tables.first, tables.stop, tables.record.bearing)
    result = MDAnalysis.Universe.empty(reader.n_atoms)
    result.add_TopologyAttr("names", [NAMES.get(kind, str(kind)) for kind in reader.types])
    result.add_TopologyAttr("types", [str(kind) for kind in reader.types])
    result.add_TopologyAttr("ids", reader.ids)
    result.trajectory = reader
    return result
