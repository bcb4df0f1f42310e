# SPDX-License-Identifier: GPL-2.0-or-later
"""A test library as it describes itself (exports.h): its functions are called and its records
filled and read by names, and a name that one side does not know is an error that says it."""

import ctypes
import re
from types import SimpleNamespace
from typing import NamedTuple

import numpy as np

PARAMETER = re.compile(r"(const )?(\w+) (\*?) ?(\w+)(\[\d*\])?$")
FIELD = re.compile(r"(\w+)(?:\[(\d+)\])?$")
NUMBERS = {"double": (ctypes.c_double, np.float64), "int": (ctypes.c_int, np.int32)}
FEW = 2  # parameters that may be given without their names


class Parameter(NamedTuple):
    """One parameter of a function; `size` is None of a single value, 0 of an array of any size."""

    name: str
    kind: str  # double, int, the name of a record, or that of a struct only C++ knows
    constant: bool
    size: int | None


class Function(NamedTuple):
    """A function of the library."""

    result: str
    parameters: tuple[Parameter, ...]


class Library:
    """The library at `path`: `call` a function, `record` makes one. Raises `TypeError` for names
    that the library does not have."""

    def __init__(self, path):
        self.path, self.plain = path, ctypes.CDLL(str(path))
        self.plain.exports.restype = ctypes.c_char_p
        self.functions, self.records = {}, {}
        for line in self.plain.exports().decode().splitlines():
            what, *rest = line.split("|")
            if what == "record":
                self.records[rest[0]] = structure(*rest)
            else:
                result, name, parameters = rest
                self.functions[name] = Function(result, read_parameters(name, parameters))

    def record(self, name, values):
        """The record `name` with the fields `values`, a mapping: all of them and no others."""
        made = self.records[name]()
        compare(f"record {name}", [field for field, _ in made._fields_], values)
        for field, value in values.items():
            if isinstance(getattr(made, field), ctypes.Array):
                getattr(made, field)[:] = value
            else:
                setattr(made, field, value)
        return made

    def call(self, name, *few, **named):
        """What the function `name` returns and the records and arrays of known size it fills, in
        its order, alone or as a tuple; those that are given by name are filled in place."""
        function = self.functions[name]
        outputs = [p for p in function.parameters if self.fills(p) and p.name not in named]
        inputs = [p.name for p in function.parameters if p not in outputs]
        if few and len(inputs) > FEW:
            raise TypeError(f"{name} takes {', '.join(inputs)} by their names")
        named |= dict(zip(inputs, few, strict=True)) if few else {}
        compare(f"function {name}", inputs, named)
        made = {p.name: self.empty(p) for p in outputs}
        arguments = [
            self.argument(p, made.get(p.name, named.get(p.name))) for p in function.parameters
        ]
        symbol = self.plain[name]
        symbol.restype = result_type(function.result)
        result = symbol(*arguments)
        results = [result] if function.result != "void" else []
        results += [read_record(one) for one in made.values()]
        return results[0] if len(results) == 1 else tuple(results) or None

    def fills(self, parameter):
        """Whether the function fills this one and its size is known."""
        known = parameter.kind in self.records or parameter.kind in NUMBERS and parameter.size
        return bool(known) and not parameter.constant and parameter.size is not None

    def empty(self, parameter):
        if parameter.kind in self.records:
            return self.records[parameter.kind]()
        return np.full(parameter.size, np.nan)

    def argument(self, parameter, value):
        name, kind, constant, size = parameter
        if kind in self.records:
            given = isinstance(value, ctypes.Structure)  # one of `call` itself, to be filled
            fields = vars(value) if isinstance(value, Record) else value
            return ctypes.byref(value if given else self.record(kind, fields))
        if kind not in NUMBERS:  # what only C++ knows
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


def structure(name, size, declarations):
    """The `ctypes.Structure` of a record from its declarations, `double x, y; double u[3];`."""
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
        raise TypeError(f"record {name} has {size} bytes, its fields {ctypes.sizeof(made)}")
    return made


def read_record(made):
    """A record with its vectors as arrays; anything else as it is."""
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


def read_parameters(name, text):
    """The `Parameter`s of a C parameter list in parentheses."""
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


def result_type(text):
    """The ctypes type of a C result."""
    known = {"void": None, "double": ctypes.c_double, "int": ctypes.c_int}
    return (known | {"const char *": ctypes.c_char_p}).get(text, ctypes.c_void_p)


def compare(what, wanted, given):
    """Raise `TypeError` with the names that are missing or not known."""
    missing = [name for name in wanted if name not in given]
    unknown = [name for name in given if name not in wanted]
    if missing or unknown:
        said = [
            f"{word} {', '.join(names)}"
            for word, names in (("has no value for", missing), ("does not know", unknown))
            if names
        ]
        raise TypeError(f"{what} {' and '.join(said)}")
