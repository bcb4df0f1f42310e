# SPDX-License-Identifier: GPL-2.0-or-later
"""Datasets whose variables are all available as attributes, for example `run.contacts.Q`."""

import xarray as xr

# `d.load` and `d.shift` are methods of a dataset, and `lambda` is a Python keyword
ALIASES = {"Q": "load", "lambda_ratio": "lambda", "radial_displacement": "shift"}


class NamedDataset(xr.Dataset):
    """A dataset with second names for variables that cannot be attributes in Python.

    They are `Q` for `load` (N), `lambda_ratio` for `lambda` and `radial_displacement` for `shift`
    (m). Both names work as keys, also in datasets that xarray derives from this one by selection,
    reduction or arithmetic.
    """

    __slots__ = ()

    def __getattr__(self, name):
        if name in ALIASES and self._own(name) in self.variables:
            return self[name]
        return super().__getattr__(name)

    def __getitem__(self, key):
        if isinstance(key, str):
            return super().__getitem__(self._own(key))
        if isinstance(key, list):
            return super().__getitem__([self._own(name) for name in key])
        return super().__getitem__(key)

    def __dir__(self):
        return [*super().__dir__(), *(k for k, own in ALIASES.items() if own in self.variables)]

    def _own(self, name):
        """Return the name of the variable that `name` refers to."""
        own = ALIASES.get(name, name) if isinstance(name, str) else name
        return own if name not in self.variables and own in self.variables else name
