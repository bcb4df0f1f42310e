# SPDX-License-Identifier: GPL-2.0-or-later
"""Specification of a data set, which is read from a YAML file, and the runs that it defines."""

import math
from collections.abc import Mapping
from functools import partial
from itertools import product
from typing import Any, NamedTuple

import numpy as np

from raceway import catalogue, inputs, yaml_file
from raceway.errors import RacewayError
from raceway.files import FilePath
from raceway.sweeps.points import OURS, WORD, Point
from raceway.theory import kinematics
from raceway.theory.bearing import Bearing

OVERSAMPLING = 4  # number of samples of a run per sample of the file with the highest rate
GUARD = 64  # number of samples that the filter affects at each end of the file with the lowest rate
# {parameter of a flaw: default, or None if it is required}; lists are swept
NOTCH: dict[str, Any] = {"length": None, "width": "round", "depth": 3e-4, "edge": 5e-5}
PIT = {name: default for name, default in NOTCH.items() if name != "width"}  # round
FLAWS: dict[str, dict[str, Any]] = {
    "none": {},
    "inner": NOTCH,
    "outer": {**NOTCH, "place": 6},
    "both": {**NOTCH, "place": 6},
    "ball": PIT,
    "waviness": {"amplitude": None},
}
FILES = ("mat", "parquet")  # file formats of a signal
FLAW_WORDS = ("length", "width", "depth", "edge", "place", "amplitude")
RANGES = {  # m, except for the place
    "length": (1e-5, 1e-2),
    "depth": (1e-7, 1e-2),
    "edge": (1e-6, 1e-3),
    "amplitude": (1e-10, 1e-5),
    "place": (0, 12),  # o'clock
}
# values of variables that the file does not set; other variables have the deck's defaults
USUAL = {"housing": "springs", "settle": "1"}
SET_HERE = {
    **OURS,
    **dict.fromkeys(("flaw_inner", "flaw_outer", "flaw_ball", "flawed_ball"), "set it in `flaws`"),
    **dict.fromkeys(("sampling", "oversampling", "passes", "samples"), "set it in `record`"),
    **dict.fromkeys(("integrator", "record", "dumps"), "it cannot be changed"),
    "phase": "`seed` determines it",
}


class SpecError(RacewayError):
    """Raised if the specification of a data set cannot be used; the message states the position
    and the value."""


_number = partial(yaml_file.number_within, error=SpecError)


class Spec(NamedTuple):
    """Specification of a data set."""

    title: str
    bearing: str
    deck: dict[str, str]  # variables with one value
    flaws: dict[str, dict[str, list[Any]]]
    conditions: dict[str, list[str]]  # variables that are swept
    seeds: list[int]
    seconds: float
    rates: list[int]  # Hz
    noise: float  # m/s^2
    axis: str  # x or y
    files: list[str]  # some of FILES

    @property
    def run_rate(self) -> int:
        """Sampling rate of the records of the runs in Hz."""
        return OVERSAMPLING * max(self.rates)


class Record(NamedTuple):
    """A record of the data set, i.e. a run and its label."""

    number: int  # counted from 1
    point: Point
    labels: dict[str, Any]
    rpm: float


def read_spec(path: FilePath, known: Mapping[str, str]) -> Spec:
    """Read the `Spec` from the YAML file `path`.

    `known` contains the deck's variables (`deck_variables`). Raise `SpecError` if the file cannot
    be read or contains an unknown word or value.
    """
    data = yaml_file.read(path, SpecError)
    try:
        return _spec(data, known)
    except SpecError as error:
        raise SpecError(f"{path}: {error}") from None


def _spec(data, known):
    whole = {"title", "bearing", "deck", "flaws", "conditions", "record"}
    data = _section("the file", data, whole, needed=whole - {"deck"})
    record = _section(
        "record",
        data["record"],
        {"seconds", "rates", "noise", "axis", "files"},
        {"seconds", "rates"},
    )
    for kind in (kinds := _list(record.get("files", "mat"))):
        if kind not in FILES:
            raise SpecError(f"record: files is '{kind}', must be one or more of {', '.join(FILES)}")
    rates = [int(_number(rate, "rates (Hz)", 1000, 1e5)) for rate in _list(record["rates"])]
    if any(max(rates) * OVERSAMPLING % rate for rate in rates):
        raise SpecError(f"record: rates {rates} must divide {OVERSAMPLING} times the largest")
    if (axis := record.get("axis", "y")) not in ("x", "y"):
        raise SpecError(f"record: axis is '{axis}', must be x or y")
    conditions = dict(_section("conditions", data["conditions"], None, {"load", "rpm"}))
    seeds = [int(_number(seed, "seed", 0, 2**31)) for seed in _list(conditions.pop("seed", 1))]
    swept = {name: [_word(name, one) for one in _list(v)] for name, v in conditions.items()}
    deck = {name: _word(name, v) for name, v in (data.get("deck") or {}).items()}
    for name in [*swept, *deck]:
        if name in SET_HERE or name == "bearing" or name not in known:
            why = SET_HERE.get(name, "the deck has no such variable, or it belongs elsewhere")
            raise SpecError(f"variable '{name}' cannot be set: {why}")
    if twice := set(swept) & set(deck):
        raise SpecError(f"variable '{min(twice)}' is in both deck and conditions")
    if len(set(seeds)) < len(seeds) or any(len(set(v)) < len(v) for v in swept.values()):
        raise SpecError("conditions: a value is repeated")
    for rpm in swept["rpm"]:
        _number(rpm, "rpm", 1, 1e5)
    return Spec(
        title=str(data["title"]),
        bearing=_word("bearing", data["bearing"]),
        deck={name: v for name, v in USUAL.items() if name not in swept} | deck,
        flaws=_flaws(data["flaws"]),
        conditions=swept,
        seeds=seeds,
        seconds=_number(record["seconds"], "seconds", 1e-3, 1e4),
        rates=rates,
        noise=_number(record.get("noise", 0), "noise (m/s^2)", 0, 1e4),
        axis=axis,
        files=kinds,
    )


def _flaws(given):
    if not isinstance(given, dict) or not given:
        raise SpecError("flaws: must name one or more of " + ", ".join(FLAWS))
    result = {}
    for kind, words in given.items():
        if kind not in FLAWS:
            raise SpecError(f"flaws: '{kind}' is unknown; known: {', '.join(FLAWS)}")
        words = _section(f"flaw {kind}", words or {}, set(FLAWS[kind]))
        full = {name: _list(words.get(name, usual)) for name, usual in FLAWS[kind].items()}
        for name, values in full.items():
            if values == [None]:
                raise SpecError(f"flaw {kind}: needs '{name}'")
            if name == "width":
                if set(values) - {"round", "full"}:
                    raise SpecError(f"flaw {kind}: width is {values}, must be round or full")
            else:
                full[name] = [_number(v, f"flaw {kind}: {name}", *RANGES[name]) for v in values]
        result[kind] = full
    return result


def _section(name, given, words, needed=frozenset()):
    if not isinstance(given, dict) or not all(isinstance(key, str) for key in given):
        raise SpecError(f"{name} must contain names with values")
    if words is not None and (more := set(given) - words):
        raise SpecError(f"{name}: '{min(more)}' is unknown; known: {', '.join(sorted(words))}")
    if missing := needed - set(given):
        raise SpecError(f"{name} needs '{min(missing)}'")
    return given


def _list(given):
    values = given if isinstance(given, list) else [given]
    if not values:
        raise SpecError("an empty list")
    return values


def _word(name, given):
    text = str(given)
    if not WORD.fullmatch(text):
        raise SpecError(f"{name} is '{text}', must be one word or number")
    return text


# ---- runs ------------------------------------------------------------------------------------
def records(spec: Spec) -> list[Record]:
    """Return a list of `Record` for `spec` in the order of its flaws, each under all conditions.

    A seed determines the azimuth of the first ball, the initial position of a flaw on the inner
    raceway or on a ball, the number of that ball, and the phases of waves. Raise `RacewayError` for
    an unknown bearing.
    """
    path = catalogue.find("bearings", spec.bearing)
    bearing = inputs.bearing(path)
    angle = inputs.four_point_angle(path) or inputs.nominal_angle(path)
    if "ball" in spec.flaws and len(bearing.raceways) > 2:
        raise SpecError(
            f"flaw ball: {path.name} has four-point contact, which a pit in the ball does not reach"
        )
    passes = kinematics.frequencies(bearing, angle).outer / 60  # ball passes per second, per rpm
    length = spec.seconds + 2 * GUARD / min(spec.rates)
    result = []
    for kind, words in spec.flaws.items():
        for values in product(*words.values(), *spec.conditions.values(), spec.seeds):
            flaw = dict(zip(words, values))
            given = dict(zip(spec.conditions, values[len(words) :]))
            seed, number = values[-1], len(result) + 1
            draw = np.random.default_rng([seed, number])
            phase, turned = draw.uniform(0, 2 * math.pi, 2)
            rpm = float(given["rpm"])
            variables = {
                "bearing": spec.bearing,
                **spec.deck,
                **given,
                "phase": f"{phase / bearing.balls:.9g}",
                "integrator": "vibration",
                "sampling": str(max(spec.rates)),
                "oversampling": str(OVERSAMPLING),
                "passes": str(math.ceil(length * passes * rpm)),
                "record": "summary",
                **_words_of(kind, flaw, bearing, turned - math.pi, draw),
            }
            labels = {"flaw": kind, **flaw, **given, "seed": seed}
            result.append(Record(number, Point(f"{number:04d}", variables), labels, rpm))
    return result


def azimuth(place: float) -> float:
    """Return the azimuth (rad) of a `place` on a clock with 12 at the top; the load acts at 6.

    >>> print(f"{azimuth(6):.4f} {azimuth(3):.4f} {azimuth(12):.4f}")
    -1.5708 0.0000 1.5708
    """
    return math.remainder(math.pi / 2 - place * math.pi / 6, 2 * math.pi)


def _words_of(kind, flaw, bearing: Bearing, turned, draw):
    """Return the arguments of fix bearing/profile for raceways or the rolling equator of a ball."""
    if kind == "none":
        return {}
    if kind == "waviness":
        return {
            f"flaw_{name}": " ".join(
                f"wave {order} {flaw['amplitude']:g} {draw.uniform(0, 2 * math.pi):.9g}"
                for order in (bearing.balls - 1, bearing.balls + 1)
            )
            for name in ("inner", "outer")
        }
    if kind == "ball":
        size = f"{flaw['length']:g}"
        return {
            "flaw_ball": f"pit {turned:.9g} 0 {size} {size} {flaw['depth']:g} {flaw['edge']:g}",
            "flawed_ball": str(draw.integers(1, int(bearing.balls) + 1)),
        }
    width = f"{flaw['length']:g}" if flaw["width"] == "round" else "full"
    rest = f"{flaw['length']:g} {width} {flaw['depth']:g} {flaw['edge']:g}"
    words = {}
    if kind in ("inner", "both"):
        words["flaw_inner"] = f"notch {turned:.9g} {rest}"
    if kind in ("outer", "both"):
        words["flaw_outer"] = f"notch {azimuth(flaw['place']):.9g} {rest}"
    return words
