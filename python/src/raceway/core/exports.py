# SPDX-License-Identifier: GPL-2.0-or-later
"""Call the functions and create the records of a self-describing C++ library by name
(src-package/core/interface/exports.h). It is an error if a name is missing on either side."""

import ctypes
import math
import re
from collections import namedtuple
from collections.abc import Mapping
from os import PathLike
from types import SimpleNamespace
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

PARAMETER = re.compile(r"(const )?(\w+) (\*?) ?(\w+)(\[\d*\])?$")
FIELD = re.compile(r"(\w+)(?:\[(\d+)\])?$")
NUMBERS = {"double": (ctypes.c_double, np.float64), "int": (ctypes.c_int, np.int32)}
FEW = 2  # largest number of parameters that may be passed by position


class Parameter(NamedTuple):
    """A parameter of a function. `size` is None for a single value and 0 for an array of any
    size."""

    name: str
    kind: str  # double, int, or the name of a record or of a struct internal to C++
    constant: bool
    size: int | None


class Function(NamedTuple):
    """Signature of a function in the library."""

    result: str
    parameters: tuple[Parameter, ...]


class Formula:
    """A function of scalars that also accepts arrays, which are broadcast. Arguments are passed by
    position or by name. The result is a scalar or an array, or a named tuple of these; xarray
    arguments give xarray results. Raises `TypeError` for a wrong number of arguments or an unknown
    name."""

    def __init__(
        self, name: str, symbol: Any, parameters: tuple[str, ...], record: type | None
    ) -> None:
        self.name, self.parameters = name, parameters
        self._record, self._symbol = record, symbol
        self._outputs = len(record._fields) if record else 1
        symbol.restype = None
        symbol.argtypes = [ctypes.c_long, ctypes.c_void_p, ctypes.c_void_p]

    def __call__(self, *values: ArrayLike, **named: ArrayLike) -> Any:
        if named:
            values += tuple(named.pop(p) for p in self.parameters[len(values) :] if p in named)
        if named or len(values) != len(self.parameters):
            raise TypeError(f"{self.name} takes {', '.join(self.parameters)}")
        if any(hasattr(value, "dims") for value in values):
            return self._labelled(values)
        shape = np.broadcast(*values).shape if values else ()
        inputs = np.empty((len(values), *shape))
        for k, value in enumerate(values):
            inputs[k] = value
        outputs = np.empty((self._outputs, *shape))
        self._symbol(math.prod(shape), inputs.ctypes.data, outputs.ctypes.data)
        return self._record(*outputs) if self._record else outputs[0]

    def _labelled(self, values):
        import xarray  # imported here because it takes longer than evaluating most formulas

        found = xarray.apply_ufunc(self, *values, output_core_dims=[[]] * self._outputs)
        return self._record(*found) if self._record else found


class Library:
    """The library at `path`. `call` runs a function, `formula` returns a function that accepts
    arrays, and `record` creates a record. Raises `TypeError` for a declaration that cannot be read
    and for arguments that do not match a declaration."""

    def __init__(self, path: str | PathLike[str]) -> None:
        self.path, self.plain = path, ctypes.CDLL(str(path))
        self.plain.exports.restype = ctypes.c_char_p
        self.functions, self.records, self.formulas = {}, {}, {}
        for line in self.plain.exports().decode().splitlines():
            what, *rest = line.split("|")
            if what == "record":
                self.records[rest[0]] = _structure(*rest)
            else:
                result, name, parameters = rest
                kept = self.formulas if what == "formula" else self.functions
                kept[name] = Function(result, _read_parameters(name, parameters))

    def formula(self, name: str) -> Formula:
        """Return the `Formula` with that name."""
        if name not in self.formulas:
            raise AttributeError(f"{self.path} has no formula {name}")
        result, parameters = self.formulas[name]
        record = None
        if result in self.records:
            record = namedtuple(result, [field for field, _ in self.records[result]._fields_])
        return Formula(name, self.plain[name], tuple(p.name for p in parameters), record)

    def record(self, name: str, values: Mapping[str, Any]) -> ctypes.Structure:
        """Create the record `name` from `values`, a mapping that must contain exactly the fields of
        the record."""
        made = self.records[name]()
        _compare(f"record {name}", [field for field, _ in made._fields_], values)
        for field, value in values.items():
            if isinstance(getattr(made, field), ctypes.Array):
                getattr(made, field)[:] = value
            else:
                setattr(made, field, value)
        return made

    def call(self, name: str, *few: Any, **named: Any) -> Any:
        """Call the function `name` and return its result, the records and the fixed-size arrays
        that it fills, in the order of the parameters, as a tuple unless there is only one. Records
        and arrays that are passed by name are filled in place."""
        function = self.functions[name]
        outputs = [p for p in function.parameters if self._fills(p) and p.name not in named]
        inputs = [p.name for p in function.parameters if p not in outputs]
        if few and len(inputs) > FEW:
            raise TypeError(f"{name} takes {', '.join(inputs)} as keyword arguments")
        named |= dict(zip(inputs, few, strict=True)) if few else {}
        _compare(f"function {name}", inputs, named)
        made = {p.name: self._empty(p) for p in outputs}
        arguments = [
            self._argument(p, made.get(p.name, named.get(p.name))) for p in function.parameters
        ]
        symbol = self.plain[name]
        symbol.restype = _result_type(function.result)
        result = symbol(*arguments)
        results = [result] if function.result != "void" else []
        results += [_read_record(one) for one in made.values()]
        return results[0] if len(results) == 1 else tuple(results) or None

    def _fills(self, parameter):
        """Return True if `call` provides the parameter, because it is an output of fixed size."""
        known = parameter.kind in self.records or parameter.kind in NUMBERS and parameter.size
        return bool(known) and not parameter.constant and parameter.size is not None

    def _empty(self, parameter):
        if parameter.kind in self.records:
            return self.records[parameter.kind]()
        return np.full(parameter.size, np.nan)

    def _argument(self, parameter, value):
        name, kind, constant, size = parameter
        if kind in self.records:
            # either an output that `call` has allocated, or the fields of an input
            given = isinstance(value, ctypes.Structure)
            fields = vars(value) if isinstance(value, Record) else value
            return ctypes.byref(value if given else self.record(kind, fields))
        if kind not in NUMBERS:  # internal to C++
            return ctypes.c_void_p(value)
        number, dtype = NUMBERS[kind]
        if size is None:
            return number(value)
        if constant:
            value = np.ascontiguousarray(value, dtype)
        elif not (
            isinstance(value, np.ndarray) and value.dtype == dtype and value.flags.c_contiguous
        ):
            raise TypeError(f"{name} is filled in place: it must be an array of {kind}")
        if size and value.size != size:
            raise TypeError(f"{name} has {value.size} numbers, not {size}")
        return value.ctypes.data_as(ctypes.POINTER(number))


def _structure(name, size, declarations):
    """Create the `ctypes.Structure` for a record with declarations such as `double x, y, u[3];`."""
    fields = []
    for declaration in filter(None, (part.strip() for part in declarations.split(";"))):
        kind, _, names = declaration.partition(" ")
        for field in re.split(r",\s*", names):
            match = FIELD.match(field)
            if kind != "double" or not match:
                raise TypeError(f"record {name}: cannot read '{declaration}'")
            number = ctypes.c_double
            fields.append((match[1], number * int(match[2]) if match[2] else number))
    made = type(name, (ctypes.Structure,), {"_fields_": fields})
    if ctypes.sizeof(made) != int(size):
        raise TypeError(f"record {name} has {size} bytes, but its fields {ctypes.sizeof(made)}")
    return made


def _read_record(made):
    """Convert a record to a `Record` whose vectors are arrays; return anything else unchanged."""
    if not isinstance(made, ctypes.Structure):
        return made
    values = ((field, getattr(made, field)) for field, _ in made._fields_)
    return Record(
        **{
            field: np.array(value) if isinstance(value, ctypes.Array) else value
            for field, value in values
        }
    )


class Record(SimpleNamespace):
    """The fields of a record as attributes."""


def _read_parameters(name, text):
    """Parse a C parameter list in parentheses into `Parameter` objects."""
    words = " ".join(text.strip().removeprefix("(").removesuffix(")").split())
    found = []
    for one in filter(None, (part.strip() for part in words.split(","))):
        match = PARAMETER.match(one)
        if not match:
            raise TypeError(f"function {name}: cannot read the parameter '{one}'")
        constant, kind, star, label, dims = match.groups()
        size = int(dims[1:-1] or 0) if dims else 0 if star else None
        found.append(Parameter(label, kind, bool(constant), size))
    return tuple(found)


def _result_type(text):
    """Return the ctypes type that corresponds to a C result type."""
    known = {"void": None, "double": ctypes.c_double, "int": ctypes.c_int}
    return (known | {"const char *": ctypes.c_char_p}).get(text, ctypes.c_void_p)


def _compare(what, wanted, given):
    """Raise `TypeError` with the missing and the unknown names if there are any."""
    missing = [name for name in wanted if name not in given]
    unknown = [name for name in given if name not in wanted]
    if missing or unknown:
        said = [
            f"{word} {', '.join(names)}"
            for word, names in (("has no value for", missing), ("has nothing named", unknown))
            if names
        ]
        raise TypeError(f"{what} {' and '.join(said)}")
