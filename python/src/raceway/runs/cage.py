# SPDX-License-Identifier: GPL-2.0-or-later
"""Results for a one-piece cage (fix bearing/cage/ring) in a run: slip and its causes, orbit, whirl
and pocket forces."""

import math
from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from raceway.arrays import Floats
from raceway.errors import RunError
from raceway.runs.record import CAGE_RING
from raceway.runs.settings import deck_words
from raceway.theory import cage_speed
from raceway.theory.bearing import INNER, OUTER

if TYPE_CHECKING:
    import xarray as xr

    from raceway.runs.record import Record
    from raceway.runs.tables import RunTables

TURNS = 2  # minimum number of cage revolutions needed to identify a whirl
ROUNDING = 1e-12  # rounding error of a slip
STILL = 1e-9  # rad/s, smaller speeds are rounding errors
WHIRLS = 0.02  # smallest orbit of a cage that whirls, as a fraction of the play
NEAR = 0.1  # a whirl follows a part whose speed is within this fraction of the cage speed


class CageFigures(NamedTuple):
    """Results for a one-piece cage, as described in `cage_figures`."""

    cage_slip: float
    cage_slip_angle: float
    cage_slip_groove: float
    cage_slip_play: float
    cage_orbit_m: float
    cage_whirl: str | None
    cage_whirl_order: float | None
    pocket_play_m: float
    pocket_force_max_N: float
    pocket_force_mean_N: float


def ring_of_cage(record: "Record") -> tuple[int, float] | None:
    """Return (index of the one-piece cage among the rings of the selected bearing, play of its
    pockets in m), or None if there is no such cage. The play is NaN in records of earlier
    versions."""
    side = record.fixed("ring_raceway").tolist()
    if CAGE_RING not in side:
        return None
    cage, known = side.index(CAGE_RING), "ring_pocket_play" in record.variables
    return cage, float(record.fixed("ring_pocket_play")[cage]) if known else math.nan


def cage_figures(tables: "RunTables") -> CageFigures | None:
    """Return the `CageFigures` of a run, or None if it has no one-piece cage.

    `cage_slip` is 1 minus the ratio of the cage speed to its value for rolling at contact angle 0,
    both relative to the outer ring and averaged over the measured passes. It is the sum of
    `cage_slip_angle` (rolling at the contact angles of the run), `cage_slip_groove` (balls roll
    without sliding on two lines of their contact ellipse, not at the bottom of the groove) and
    `cage_slip_play` (the remainder, caused by the pocket play, by which idle balls lag behind, and
    by creep under drag); these three are missing if the record has no contacts. `cage_orbit_m` is
    the largest distance of the cage centre from its mean position (m). `cage_whirl` and
    `cage_whirl_order` are the results of `whirl` and `whirl_order`. `pocket_play_m` is the play
    along the pitch circle (m). `pocket_force_max_N` and `pocket_force_mean_N` are the largest and
    the mean force of a ball on its pocket (N), evaluated at the ends of steps.
    """
    record = tables.record
    if (found := ring_of_cage(record)) is None:
        return None
    (cage, play), side = found, record.fixed("ring_raceway").tolist()
    start, stop = tables.first, len(record) if tables.stop is None else tables.stop
    data = record.read(["ring_spin", "ring_x", "ring_y"], start, stop)
    spin = data["ring_spin"]
    inner, outer = (spin[:, side.index(k)] if k in side else 0.0 for k in (INNER, OUTER))
    geometry = tables.geometry
    way = np.sign(inner - outer)  # both directions count as positive
    flat = 0.5 * (1 - geometry.ball_radius / geometry.pitch_radius)
    rolling = flat * float(np.mean(way * (inner - outer)))
    own = float(np.mean(way * (spin[:, cage] - outer)))
    slip = 1 - own / rolling if rolling > STILL else math.nan
    angle, groove = _rolling_slip(tables, start, stop)
    place = data["ring_x"][:, cage] + 1j * data["ring_y"][:, cage]
    place = place - place.mean()
    speeds = {"cage": spin[:, cage], "inner ring": inner, "outer ring": outer}
    speeds = {name: float(np.mean(speed)) for name, speed in speeds.items()}
    order = whirl_order(place, speeds["cage"] * tables.settings["sample_s"], play)
    force = record.read(["ball_pocket_force"], start, stop)["ball_pocket_force"]
    known = force[np.isfinite(force)]
    return CageFigures(
        cage_slip=slip,
        cage_slip_angle=angle,
        cage_slip_groove=groove,
        cage_slip_play=slip - angle - groove,
        cage_orbit_m=float(np.abs(place).max()),
        cage_whirl=whirl(order, _relative(speeds)),
        cage_whirl_order=order,
        pocket_play_m=play,
        pocket_force_max_N=float(known.max()) if known.size else math.nan,
        pocket_force_mean_N=float(known.mean()) if known.size else math.nan,
    )


def _relative(speeds):
    """Return the speeds of the parts that turn, relative to that of the cage."""
    if abs(speeds["cage"]) <= STILL:
        return {}
    return {name: speed / speeds["cage"] for name, speed in speeds.items() if speed}


def whirl(order: float | None, known: dict[str, float]) -> str | None:
    """Return the name of a whirl at `order` times the speed of the cage (see `whirl_order`).

    The name is "none", "irregular", the part with which the whirl rotates, "forward" (in the
    direction of the cage rotation) or "backward". `known` maps parts to their speeds relative to
    the speed of the cage.

    >>> whirl(0.52, {"cage": 1.0, "inner ring": 2.5}), whirl(-3.0, {})
    ('half the speed of the cage', 'backward')
    """
    if order is None:
        return None
    if order == 0.0 or math.isnan(order):
        return "irregular" if order else "none"
    for share, text in ((1.0, "with the {}"), (0.5, "half the speed of the {}")):
        for part, speed in known.items():
            if abs(order - share * speed) < NEAR:
                return text.format(part)
    return "forward" if order > 0 else "backward"


def whirl_order(place: np.ndarray, turn: float, play: float) -> float | None:
    """Return the ratio of the whirl speed of `place` (complex, m) to the speed of the cage, which
    rotates by `turn` rad per sample.

    The ratio is 0 for a cage whose orbit stays within the fraction `WHIRLS` of its `play` (m), None
    if the run is too short, and NaN if the motion is irregular, i.e. if no line of the spectrum
    contains half of the power.
    """
    count = len(place)
    if not abs(turn) * count > TURNS * 2 * math.pi:
        return None
    if np.abs(place).max() < WHIRLS * play:
        return 0.0
    # A window and zero padding are used so that a line may lie between bins. The FFT of a length
    # with large prime factors would take several times the memory.
    wide = 8 << (count - 1).bit_length()
    power = np.abs(np.fft.fft(place * np.hanning(count), wide)) ** 2
    speed = np.fft.fftfreq(wide) * 2 * math.pi / turn
    bin_ = 2 * math.pi / (abs(turn) * count)
    power[np.abs(speed) < bin_] = 0.0  # drift of the centre
    top = float(speed[power.argmax()])
    line = np.abs(speed - top) < 2 * bin_  # the width of the window's line
    return top if power[line].sum() > 0.5 * power.sum() else math.nan


def _rolling_slip(tables, start, stop):
    """Return the slip due to the contact angle and the slip due to the curvature of the grooves,
    both computed from the contacts of the run."""
    record, geometry = tables.record, tables.geometry
    if not {"load", "angle", "a"} <= set(record.contact_columns) or record.two_grooves:
        return math.nan, math.nan
    sums = np.zeros(3)
    tilted = tables.settings.get("models") != "paper"
    for first, last in record.blocks(start, stop):
        data = record.read(["load", "angle", "a"], first, last)
        sides = [
            cage_speed.Rolling(
                *(np.nan_to_num(data[name][:, k]) for name in ("load", "angle", "a"))
            )
            for k in (INNER, OUTER)
        ]
        both = (sides[INNER].load > 0) & (sides[OUTER].load > 0)
        load = (sides[INNER].load + sides[OUTER].load)[both]
        sides = [cage_speed.Rolling(*(one[both] for one in side)) for side in sides]
        speed = cage_speed.rolling(geometry, *sides, tilted=tilted)
        groove = (1 - speed) * cage_speed.shortened(geometry, *sides)
        sums += load.sum(), (load * speed).sum(), (load * speed * (1 + groove)).sum()
    if not sums[0] > 0:
        return math.nan, math.nan
    flat = 0.5 * (1 - geometry.ball_radius / geometry.pitch_radius)
    at_angle, on_groove = sums[1:] / sums[0]
    at = 1 - at_angle / flat
    return at if abs(at) > ROUNDING else 0.0, (at_angle - on_groove) / flat


def cage_ranges(
    tables: "RunTables", figures: Mapping[str, Any]
) -> dict[str, tuple[float, float, str]]:
    """Return {key: (low, high, why)} for the `figures` of the cage that depend on unknown play and
    guidance.

    If the run estimated the play, it ranges over `cage_speed.PLAYS` times the ball diameter. The
    slip due to play follows from `cage_speed.slips_of_play` over the loaded arc, for any position
    of the cage. The range of the largest force is based on idle balls that move through the play
    under a steady drag: the force of an impact is proportional to the speed of the ball and hence
    to the square root of the play.
    """
    play, balls = figures.get("pocket_play_m"), tables.geometry.balls
    slip, shares = figures.get("cage_slip_play"), (1.0, 1.0)
    if not play or figures.get("cage_slip") is None:
        return {}
    estimated = float(deck_words(tables.settings).get("cage_play", 1)) == 0
    if estimated:
        shares = tuple(share * tables.geometry.ball_diameter / play for share in cage_speed.PLAYS)
    found, loaded = {}, figures["loaded_balls_mean"]
    why = "pocket play {:g} to {:g} of the ball's diameter".format(*cage_speed.PLAYS)
    if slip is not None and 0 < loaded < balls - 0.5:
        arc = 2 * math.pi * tables.geometry.pitch_radius * loaded / balls
        low, high = cage_speed.slips_of_play(shares[1] * play, arc)
        text = f"{why}, cage" if estimated else "cage"
        for key in ("cage_slip", "cage_slip_play"):
            off = figures[key] - slip
            found[key] = (
                min(slip, low) + off,
                max(slip, high) + off,
                f"{text} centred or shifted by its play",
            )
    if estimated and (force := figures.get("pocket_force_max_N")):
        found["pocket_force_max_N"] = (*(force * math.sqrt(share) for share in shares), why)
    return found


class Pockets(NamedTuple):
    """The pockets of a one-piece cage at s samples."""

    centre: Floats  # (s, pockets, 3), m
    turned: Floats  # (s,), rad, azimuth of the first pocket
    play: float  # m, along the pitch circle


def pockets(tables: "RunTables", start: int, stop: int) -> Pockets | None:
    """Return the `Pockets` at the samples from `start` to `stop`, neglecting tilts of the cage.

    Return None if there is no one-piece cage or if the record is from an earlier version.
    """
    record = tables.record
    found = ring_of_cage(record)
    if found is None or "ring_pocket_phase" not in record.variables:
        return None
    cage, play = found
    phase = float(record.fixed("ring_pocket_phase")[cage])
    data = record.read(["ring_x", "ring_y", "ring_z", "ring_angle"], start, stop)
    *place, angle = (values[:, cage] for values in data.values())
    middle = np.stack(
        [one + record.fixed(f"ring_origin_{axis}")[cage] for one, axis in zip(place, "xyz")], -1
    )
    balls = tables.geometry.balls
    azimuth = (angle + phase)[:, None] + 2 * math.pi * np.arange(balls) / balls
    way = np.stack([np.cos(azimuth), np.sin(azimuth), np.zeros_like(azimuth)], -1)
    return Pockets(middle[:, None] + tables.geometry.pitch_radius * way, angle + phase, play)


def pockets_around(tables: "RunTables", bins: int = 72) -> "xr.Dataset":
    """Return the force of the balls on the pockets of a cage as a function of azimuth.

    The result is a Dataset (from_load_line) with the `mean` and the `largest` force (N) and
    `samples`, the number of known forces, in each of `bins` equal sectors. `from_load_line` is the
    middle of a sector in rad, relative to the centre of the load zone. Sectors without a known
    force are NaN. Raise `RunError` for a run without a cage ring or ball positions, and
    `ValueError` for fewer than one bin.
    """
    if bins < 1:
        raise ValueError(f"bins = {bins} must be at least 1")
    record = tables.record
    needed = {"ball_pocket_force", "ball_x", "ball_y"}
    if missing := sorted(needed - set(record.variables)):
        raise RunError(f"{record.path} has no {', '.join(missing)}, as required for pocket forces")
    most, total, count = np.zeros(bins), np.zeros(bins), np.zeros(bins, dtype=int)
    stop = len(record) if tables.stop is None else tables.stop
    for first, last in record.blocks(tables.first, stop):
        data = record.read(sorted(needed), first, last)
        force = data["ball_pocket_force"]
        known = np.isfinite(force)
        psi = tables.from_load_line(np.arctan2(data["ball_y"], data["ball_x"])[known])
        part = np.minimum(((psi + np.pi) / (2 * np.pi) * bins).astype(int), bins - 1)
        np.maximum.at(most, part, force[known])
        total += np.bincount(part, weights=force[known], minlength=bins)
        count += np.bincount(part, minlength=bins)
    some = count > 0
    mean = np.divide(total, count, out=np.full(bins, np.nan), where=some)
    middle = (np.arange(bins) + 0.5) / bins * 2 * np.pi - np.pi
    at = "from_load_line"
    import xarray as xr  # loading it takes longer than computing a summary

    return xr.Dataset(
        {
            "mean": (at, mean, {"units": "N", "long_name": "mean force on a pocket"}),
            "largest": (
                at,
                np.where(some, most, np.nan),
                {"units": "N", "long_name": "largest force on a pocket"},
            ),
            "samples": (at, count),
        },
        coords={
            at: (
                at,
                middle,
                {"units": "rad", "long_name": "azimuth from the centre of the load zone"},
            )
        },
    )
