# SPDX-License-Identifier: GPL-2.0-or-later
"""List and search the bearings in an inputs folder, both files and rows of tables."""

import math
from collections.abc import Iterable
from dataclasses import asdict, dataclass
from pathlib import Path

from raceway import catalogue, data_table, inputs
from raceway.files import FilePath

# {field of `Entry`: variable in the bearing's file, which the file may lack}
STATED = {
    "bore_m": "bore_diameter",
    "outside_m": "outside_diameter",
    "width_m": "bearing_width",
    "dynamic_load_N": "basic_dynamic_load",
    "static_load_N": "basic_static_load",
    "fatigue_load_N": "fatigue_load_limit",
    "reference_speed_rpm": "reference_speed",
    "limiting_speed_rpm": "limiting_speed",
    "mass_kg": "bearing_mass",
}


@dataclass(frozen=True)
class Entry:
    """One bearing in the catalogue. Values that its file does not state are None."""

    name: str
    title: str  # first line of the file
    bore_m: float | None
    outside_m: float | None
    width_m: float | None
    contact_angle_deg: float  # 0 for a deep groove ball bearing
    dynamic_load_N: float | None  # dynamic load rating C
    static_load_N: float | None  # static load rating C0
    fatigue_load_N: float | None  # fatigue load limit Pu
    reference_speed_rpm: float | None
    limiting_speed_rpm: float | None
    mass_kg: float | None
    balls: int
    ball_diameter_m: float
    pitch_diameter_m: float
    balls_from: str | None  # comment in the file, which is a source or "estimate"
    ratings_from: str | None

    def figures(self) -> dict[str, str | float | int | None]:
        """Return the fields as a dict."""
        return asdict(self)


def entries(folder: FilePath | None = None) -> list[Entry]:
    """Return an `Entry` for every bearing in an inputs `folder` (see `catalogue.folder`), sorted by
    bore, outside diameter and name. Raises `InputError` if a file does not describe a bearing."""
    shelf = catalogue.folder(folder) / "bearings"
    found = [entry(shelf / name) for name in data_table.names(shelf)]
    return sorted(
        found, key=lambda one: (one.bore_m or math.inf, one.outside_m or math.inf, one.name)
    )


def entry(path: Path) -> Entry:
    """Return the `Entry` for a file or a table row in inputs/bearings. Raises `InputError`."""
    bearing = inputs.bearing(path)
    known, comments = inputs.values(path), inputs.comments(path)
    try:
        stated = {field: float(known[key]) for field, key in STATED.items() if key in known}
        pitch = float(known.get("pitch_diameter", 2 * bearing.pitch_radius))
    except ValueError as error:
        raise inputs.InputError(f"{path}: {error}") from None
    ratings = comments.get("basic_dynamic_load", "")
    return Entry(
        name=path.name,
        title=inputs.text(path).partition("\n")[0].lstrip("# "),
        **{field: stated.get(field) for field in STATED},
        contact_angle_deg=round(
            math.degrees(inputs.four_point_angle(path) or inputs.nominal_angle(path)), 9
        ),
        balls=bearing.balls,
        ball_diameter_m=bearing.ball_diameter,
        pitch_diameter_m=pitch,
        balls_from=comments.get("balls"),
        # "N; C, SKF"
        ratings_from=ratings.rpartition(", ")[2] if ", " in ratings else None,
    )


def search(
    of: Iterable[Entry],
    words: Iterable[str] = (),
    *,
    series: str | None = None,
    bore: float | None = None,
    outside: float | None = None,
    width: float | None = None,
    contact_angle: float | None = None,
    dynamic_load_above: float | None = None,
    static_load_above: float | None = None,
) -> list[Entry]:
    """Return the entries that contain all `words` in their name, title or sources (ignoring case),
    whose name starts with `series`, whose dimensions (in m) and contact angle (in degrees) equal
    the given values, and whose load ratings exceed the given values in N. An entry whose file does
    not state one of the requested quantities does not match."""
    sizes = {
        "bore_m": bore,
        "outside_m": outside,
        "width_m": width,
        "contact_angle_deg": contact_angle,
    }
    loads = {"dynamic_load_N": dynamic_load_above, "static_load_N": static_load_above}

    def fits(one):
        text = " ".join(
            str(part) for part in (one.name, one.title, one.balls_from, one.ratings_from)
        ).lower()
        return (
            all(word.lower() in text for word in words)
            and one.name.startswith(series or "")
            and all(
                wanted is None
                or getattr(one, field) is not None
                and math.isclose(getattr(one, field), wanted, rel_tol=1e-9)
                for field, wanted in sizes.items()
            )
            and all(
                least is None or (getattr(one, field) or 0) > least
                for field, least in loads.items()
            )
        )

    return [one for one in of if fits(one)]
